// The things that the two views show: S and its positions, the sweep, points, trajectories.
// SPDX-License-Identifier: GPL-3.0-or-later

const colour = (text) => new THREE.Color().setStyle(text);
const INK = 0x222222;

/** Flat coordinates less a centre, as three coordinates each. */
function centred(flat, centre) {
  const count = flat.length / d, out = new Float32Array(3 * count);
  for (let k = 0; k < count; k++) for (let i = 0; i < d; i++) out[3 * k + i] = flat[d * k + i] - centre[i];
  return out;
}

function boundsOf(flat) {
  const low = [0, 0, 0], high = [0, 0, 0];
  for (let i = 0; i < d; i++) {
    low[i] = Infinity;
    high[i] = -Infinity;
    for (let k = i; k < flat.length; k += d) {
      low[i] = Math.min(low[i], flat[k]);
      high[i] = Math.max(high[i], flat[k]);
    }
  }
  return [low, high];
}

const middle = ([low, high]) => low.map((x, k) => (x + high[k]) / 2);
const half = ([low, high]) => Math.hypot(...low.map((x, k) => (high[k] - x) / 2));

const vertices = doubles(scene.solid.vertices);
const bodyBounds = boundsOf(vertices), bodyCentre = middle(bodyBounds);
const worldBounds = [[...scene.box.slice(0, d), 0].slice(0, 3), [...scene.box.slice(d), 0].slice(0, 3)];
const worldCentre = middle(worldBounds);

function shell(array, index) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(array, 3));
  geometry.setIndex(new THREE.BufferAttribute(index, 1));
  return geometry;
}

/** Triangles of polygons with holes, by vertex numbers. */
function filled(polygons) {
  const out = [];
  for (const rings of polygons) {
    const [outer, ...holes] = rings.map((ring) => ring.map((v) => new THREE.Vector2(vertices[2 * v], vertices[2 * v + 1])));
    const all = rings.flat();
    for (const face of THREE.ShapeUtils.triangulateShape(outer, holes)) out.push(...face.map((k) => all[k]));
  }
  return Uint32Array.from(out);
}

function ringSides(polygons) {
  const out = [];
  for (const ring of polygons.flat()) ring.forEach((v, k) => out.push(v, ring[(k + 1) % ring.length]));
  return Uint32Array.from(out);
}

const solid = (() => {
  const array = centred(vertices, bodyCentre);
  const faces = shell(array, d === 3 ? counts(scene.solid.triangles) : filled(scene.solid.polygons));
  const edges = shell(array, d === 3 ? counts(scene.solid.edges) : ringSides(scene.solid.polygons));
  return {faces, edges};
})();

/** S as faces and edges, to be put where a matrix says. */
function solidGroup(tint, opacity) {
  const group = new THREE.Group();
  const kind = d === 3 ? THREE.MeshLambertMaterial : THREE.MeshBasicMaterial;
  if (opacity > 0)
    group.add(new THREE.Mesh(solid.faces, new kind({color: tint, side: THREE.DoubleSide, flatShading: d === 3,
      transparent: opacity < 1, opacity, depthWrite: opacity === 1, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1})));
  group.add(new THREE.LineSegments(solid.edges, new THREE.LineBasicMaterial({color: opacity > 0 ? INK : tint})));
  group.matrixAutoUpdate = false;
  return group;
}

/** Put S, whose vertices are less bodyCentre, where it is at t, less worldCentre. */
function moveTo(group, t) {
  const rows = mapAt("place", t), moved = carry(rows, bodyCentre), m = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
  for (let i = 0; i < d; i++) {
    for (let j = 0; j < d; j++) m[4 * i + j] = rows[i * (d + 1) + j];
    m[4 * i + 3] = moved[i] - worldCentre[i];
  }
  group.matrix.set(...m);
  group.matrixWorldNeedsUpdate = true;
}

/** The boundary of the sweep. */
function sweepObject() {
  const faces = counts(scene.surface.faces), array = centred(doubles(scene.surface.vertices), worldCentre);
  const geometry = shell(array, faces);
  if (d === 2) return new THREE.LineSegments(geometry, new THREE.LineBasicMaterial({color: 0x009e73}));
  return new THREE.Mesh(geometry, new THREE.MeshLambertMaterial({color: 0xbfd9ea, side: THREE.DoubleSide, flatShading: true,
    transparent: true, opacity: 0.4, depthWrite: false}));
}

const signsOf = {};
for (const [name, shape] of [["f", "circle"], ["e", "square"], ["v", "triangle"]]) {
  signsOf["X" + name] = signTexture(shape, "#222222", "#ffffff");
  signsOf["T" + name] = signTexture(shape, "#ffffff", "#d55e00");
}
const disk = signTexture("circle", "#ffffff", "#222222");
const wrongDisk = signTexture("square", "#ffffff", "#000000");

const body = (place) => place.map((x, k) => x - (k < d ? bodyCentre[k] : 0));
const world = (place) => [0, 1, 2].map((k) => (k < d ? place[k] - worldCentre[k] : 0));

/** The trajectory of a point through the standing S with its contacts, into a group. */
function trajectory(group, p, strong) {
  let from = start, next = 0;
  [...p.word].forEach((letter, k) => {
    const contact = letter === "B" ? p.contacts[next++] : p.contacts[next];
    const to = letter === "B" ? timeValue(contact.to) : contact ? timeValue(contact.from) : end;
    if (to > from) {
      const places = trail(p.place, from, to).map(body);
      const [tint, width] = letter === "B" ? [0xcc79a7, 6] : letter === "I" ? [INK, 3] : [INK, 1.2];
      group.add(polyline(places, strong ? tint : 0x999999, strong ? width : 1));
    }
    from = to;
  });
  for (const c of p.contacts) {
    const smallest = c.cells.some((x) => x[0] === "v") ? "v" : c.cells.some((x) => x[0] === "e") ? "e" : "f";
    const at = carry(mapAt("trace", (timeValue(c.from) + timeValue(c.to)) / 2), p.place);
    group.add(signs([body(at)], null, signsOf[(c.crossing ? "X" : "T") + smallest], strong ? 15 : 9, 3));
  }
}
