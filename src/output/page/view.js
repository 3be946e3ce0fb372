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
  constructor(id) {
    this.canvas = document.getElementById(id);
    const light = scene.points.length + (scene.surface ? scene.surface.faces.length / 16 : 0) < 50000;
    this.renderer = new THREE.WebGLRenderer({canvas: this.canvas, antialias: light, preserveDrawingBuffer: true});
    this.renderer.setClearColor(0xffffff);
    this.scene = new THREE.Scene();
    this.scene.add(new THREE.HemisphereLight(0xffffff, 0x888888, 2.2));
    this.lamp = new THREE.DirectionalLight(0xffffff, 1.4);
    this.scene.add(this.lamp);
    this.camera = d === 3 ? new THREE.PerspectiveCamera(30, 1, 0.1, 1000) : new THREE.OrthographicCamera(-1, 1, 1, -1, -10, 10);
    this.camera.up.set(0, d === 3 ? 0 : 1, d === 3 ? 1 : 0);
    this.controls = new THREE.OrbitControls(this.camera, this.canvas);
    this.controls.enableRotate = d === 3;
    if (d === 2) this.controls.mouseButtons.LEFT = 2;
    this.controls.addEventListener("change", () => this.ask());
    this.asked = false;
    new ResizeObserver(() => this.resize()).observe(this.canvas.parentElement);
  }

  /** Look at a box of centre and half diagonal, which is what the two buttons "fit" do. */
  fit(centre, radius) {
    this.home = [centre, radius];
    this.controls.target.set(...centre);
    if (d === 3) {
      const wide = Math.min(1, this.canvas.parentElement.clientWidth / Math.max(1, this.canvas.parentElement.clientHeight));
      const far = radius / Math.sin(Math.atan(Math.tan((15 * Math.PI) / 180) * wide)), way = new THREE.Vector3(2, -3, 2).normalize();
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

  resize() {
    const room = this.canvas.parentElement, width = Math.max(1, room.clientWidth), height = Math.max(1, room.clientHeight);
    this.renderer.setSize(width, height, false);
    if (d === 3) this.camera.aspect = width / height;
    else if (this.home) {
      const half = this.home[1] * 1.05, wide = width / height;
      const [x, y] = wide > 1 ? [half * wide, half] : [half, half / wide];
      Object.assign(this.camera, {left: -x, right: x, top: y, bottom: -y});
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
    this.lamp.position.copy(this.camera.position);
    this.renderer.render(this.scene, this.camera);
  }

  /** Milliseconds of one frame, the pixels fetched. */
  measure() {
    const before = performance.now(), gl = this.renderer.getContext();
    this.draw();
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
    return performance.now() - before;
  }

  /** The pixel of a place on the canvas, and its depth. */
  pixel(place) {
    const v = new THREE.Vector3(...place).project(this.camera), box = this.canvas.getBoundingClientRect();
    return [box.left + ((v.x + 1) / 2) * box.width, box.top + ((1 - v.y) / 2) * box.height, v.z];
  }

  /** The index of the place next to a pixel, at most 9 pixels off; of several the nearest to the eye. -1: none. */
  pick(x, y, places) {
    let best = -1, nearest = [Infinity, Infinity];
    places.forEach((place, k) => {
      const [px, py, depth] = this.pixel(place), off = Math.round(Math.hypot(px - x, py - y) / 3);
      if (off > 3 || depth > 1 || depth < -1) return;
      if (off < nearest[0] || (off === nearest[0] && depth < nearest[1])) [best, nearest] = [k, [off, depth]];
    });
    return best;
  }
}

/** Points of one sign, drawn over what is translucent; from order 3 on over all else. `colours` are three numbers a
 * point, or null. */
function signs(places, colours, texture, size, order) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.Float32BufferAttribute(places.flat(), 3));
  if (colours) geometry.setAttribute("color", new THREE.Float32BufferAttribute(colours.flat(), 3));
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
    child.geometry.dispose();
    child.material.dispose();
  }
}
