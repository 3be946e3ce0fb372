// One canvas with its camera: three.js, drawn when something has changed.
// SPDX-License-Identifier: GPL-3.0-or-later

/** A round, square or three-sided sign as a texture: white within a dark rim, or dark within a light one. */
function signTexture(shape, fill, rim) {
  const canvas = document.createElement("canvas"), size = 64, c = canvas.getContext("2d");
  canvas.width = canvas.height = size;
  c.beginPath();
  if (shape === "circle") c.arc(32, 32, 24, 0, 2 * Math.PI);
  else if (shape === "square") c.rect(10, 10, 44, 44);
  else {
    c.moveTo(32, 5);
    c.lineTo(60, 53);
    c.lineTo(4, 53);
    c.closePath();
  }
  c.fillStyle = fill;
  c.fill();
  c.lineWidth = 9;
  c.strokeStyle = rim;
  c.stroke();
  return new THREE.CanvasTexture(canvas);
}

class View {
  /** `annotate` writes axes and names on the canvas above, after each frame. */
  constructor(id, annotate) {
    this.canvas = document.getElementById(id);
    this.sheet = document.getElementById(id + "-sheet");
    this.annotate = annotate;
    const light = (scene.surface && scene.surface.faces ? scene.surface.faces.length / 16 : 0) < 100000;
    this.renderer = new THREE.WebGLRenderer({canvas: this.canvas, antialias: light, preserveDrawingBuffer: true});
    this.scene = new THREE.Scene();
    this.scene.add(new THREE.HemisphereLight(0xffffff, 0x888888, 2.2));
    this.lamp = new THREE.DirectionalLight(0xffffff, 1.4);
    this.scene.add(this.lamp);
    this.camera = d === 3 ? new THREE.PerspectiveCamera(30, 1, 0.1, 1000) : new THREE.OrthographicCamera(-1, 1, 1, -1, -10, 10);
    this.camera.up.set(0, d === 3 ? 0 : 1, d === 3 ? 1 : 0);
    this.controls = new THREE.OrbitControls(this.camera, this.canvas);
    this.controls.enableRotate = d === 3;
    if (d === 2) {
      this.controls.mouseButtons.LEFT = 2;
      this.controls.touches.ONE = 1;
    }
    this.controls.addEventListener("change", () => this.ask());
    this.canvas.addEventListener("keydown", (event) => this.turn(event));
    this.asked = false;
    for (const legend of this.canvas.parentElement.querySelectorAll("details")) legend.addEventListener("toggle", () => this.ask());
    new ResizeObserver(() => this.resize()).observe(this.canvas.parentElement);
  }

  /** Look at a box, given by its two corners. */
  fit(bounds) {
    this.home = bounds;
    const centre = middle(bounds), parent = this.canvas.parentElement;
    this.controls.target.set(...centre);
    if (d === 3) {
      const wide = Math.max(1, parent.clientWidth) / Math.max(1, parent.clientHeight), up = Math.tan((15 * Math.PI) / 180);
      const way = new THREE.Vector3(2, -3, 2).normalize();
      const far = this.distance(bounds, centre, way, up * wide, up);
      this.camera.position.copy(this.controls.target).addScaledVector(way, far);
      this.camera.near = far / 1000;
      this.camera.far = far * 20;
    } else {
      this.camera.position.set(centre[0], centre[1], 5);
      this.camera.zoom = 1;
    }
    this.resize();
    this.controls.update();
  }

  /** The distance from which all corners of a box are in sight, with room for numbers. */
  distance(bounds, centre, way, across, up) {
    const right = new THREE.Vector3(-way.y, way.x, 0).normalize(), above = new THREE.Vector3().crossVectors(way, right);
    let far = 0;
    for (let k = 0; k < 8; k++) {
      const v = new THREE.Vector3(...[0, 1, 2].map((i) => bounds[(k >> i) & 1][i] - centre[i]));
      far = Math.max(far, v.dot(way) + Math.max(Math.abs(v.dot(right)) / (across * 0.84), Math.abs(v.dot(above)) / (up * 0.8)));
    }
    return far || 1;
  }

  /** Arrow keys turn a view of space and move one of the plane, + and - bring it nearer or away. */
  turn(event) {
    const ways = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]}, way = ways[event.key];
    if (!way) return;
    event.preventDefault();
    event.stopPropagation();
    const from = this.camera.position, to = this.controls.target, off = from.clone().sub(to);
    if (d === 3) {
      const flat = Math.hypot(off.x, off.y), around = Math.atan2(off.y, off.x) + way[0] * 0.15;
      const height = Math.min(1.5, Math.max(-1.5, Math.atan2(off.z, flat) + way[1] * 0.1)), far = off.length();
      off.set(far * Math.cos(height) * Math.cos(around), far * Math.cos(height) * Math.sin(around), far * Math.sin(height));
    } else {
      const step = (0.08 * (this.camera.right - this.camera.left)) / this.camera.zoom;
      to.set(to.x + way[0] * step, to.y + way[1] * step, to.z);
    }
    from.copy(to).add(off);
    this.controls.update();
    this.ask();
  }

  zoom(by) {
    const to = this.controls.target;
    if (d === 3) this.camera.position.sub(to).multiplyScalar(1 / by).add(to);
    else this.camera.zoom *= by;
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.ask();
  }

  resize() {
    const room = this.canvas.parentElement, width = Math.max(1, room.clientWidth), height = Math.max(1, room.clientHeight);
    const ratio = Math.min(2, window.devicePixelRatio || 1);
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height, false);
    Object.assign(this.sheet, {width: width * ratio, height: height * ratio});
    if (d === 3) this.camera.aspect = width / height;
    else if (this.home) {
      const [low, high] = this.home, x = ((high[0] - low[0]) / 2) * 1.22 || 1, y = ((high[1] - low[1]) / 2) * 1.3 || 1;
      const unit = Math.max(x / width, y / height);
      Object.assign(this.camera, {left: -unit * width, right: unit * width, top: unit * height, bottom: -unit * height});
    }
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  ask() {
    if (this.asked) return;
    this.asked = true;
    requestAnimationFrame(() => this.draw());
  }

  draw() {
    this.asked = false;
    const width = this.canvas.clientWidth, height = this.canvas.clientHeight, c = this.sheet.getContext("2d");
    if (!width || !height) return;
    this.renderer.setClearColor(tint("paper"));
    this.lamp.position.copy(this.camera.position);
    this.renderer.render(this.scene, this.camera);
    c.setTransform(this.sheet.width / width, 0, 0, this.sheet.height / height, 0, 0);
    c.clearRect(0, 0, width, height);
    this.labels = new Labels(c, width, height);
    const box = this.canvas.getBoundingClientRect();
    for (const part of this.canvas.parentElement.querySelectorAll(":scope > :not(canvas)")) {
      const r = part.getBoundingClientRect();
      this.labels.taken.push([r.left - box.left, r.top - box.top, r.right - box.left, r.bottom - box.top]);
    }
    this.annotate(this, this.labels);
  }

  /** Draw a frame, fetch a pixel, and return the milliseconds that this took. */
  measure() {
    const before = performance.now(), gl = this.renderer.getContext();
    this.draw();
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
    return performance.now() - before;
  }

  /** The pixel of a place on the canvas, and its depth. */
  spot(place) {
    const v = new THREE.Vector3(...place).project(this.camera);
    return [((v.x + 1) / 2) * this.canvas.clientWidth, ((1 - v.y) / 2) * this.canvas.clientHeight, v.z];
  }

  /** The pixel of a place in the window, and its depth. */
  pixel(place) {
    const [x, y, depth] = this.spot(place), box = this.canvas.getBoundingClientRect();
    return [box.left + x, box.top + y, depth];
  }

  /** The thing nearest to a pixel, at most `reach` pixels away; of equally near ones that nearest to the eye. -1: none. */
  pick(x, y, things, placeOf, reach) {
    let best = -1, nearest = [Infinity, Infinity];
    const box = this.canvas.getBoundingClientRect();
    for (const k of things) {
      const [px, py, depth] = this.spot(placeOf(k)), off = Math.round(Math.hypot(px + box.left - x, py + box.top - y) / 3);
      if (off > reach / 3 || depth > 1 || depth < -1) continue;
      if (off < nearest[0] || (off === nearest[0] && depth < nearest[1])) [best, nearest] = [k, [off, depth]];
    }
    return best;
  }
}

/** Points of one sign, drawn over translucent things; from order 3 on over all else. `at` has three numbers for each point,
 * and so has `colours`, which may be null. */
function signs(at, colours, texture, size, order) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.Float32BufferAttribute(at, 3));
  if (colours) geometry.setAttribute("color", new THREE.Float32BufferAttribute(colours, 3));
  const material = new THREE.PointsMaterial({size, sizeAttenuation: false, map: texture, alphaTest: 0.4, vertexColors: Boolean(colours),
    transparent: true});
  if (order >= 3) material.depthTest = false;
  const out = new THREE.Points(geometry, material);
  out.renderOrder = order;
  out.frustumCulled = false;
  return out;
}

/** A line of a width in pixels through places. */
function polyline(places, colour, width) {
  const geometry = new THREE.LineGeometry();
  geometry.setPositions(places.flat());
  const out = new THREE.Line2(geometry, new THREE.LineMaterial({color: colour, linewidth: width}));
  out.frustumCulled = false;
  return out;
}

function dispose(group) {
  for (const child of [...group.children]) {
    group.remove(child);
    if (child.children.length) dispose(child);
    if (child.geometry) child.geometry.dispose();
    if (child.material) child.material.dispose();
  }
}
