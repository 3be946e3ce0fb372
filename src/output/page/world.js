// The things that the two views show: S and its positions, the sweep, points, trajectories.
// SPDX-License-Identifier: GPL-3.0-or-later

const colour = (text) => new THREE.Color().setStyle(text);

/** Points from a flat array, relative to a centre, with three coordinates each. */
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

const vertices = doubles(scene.solid.vertices);
const bodyBounds = boundsOf(vertices), bodyCentre = middle(bodyBounds);
const worldBounds = [[...scene.box.slice(0, d), 0].slice(0, 3), [...scene.box.slice(d), 0].slice(0, 3)];
const worldCentre = middle(worldBounds);
const around = ([low, high], centre) => [low, high].map((v) => v.map((x, k) => x - centre[k]));

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

/** The rings of an outline, whose sides are in no order, as vertex numbers. */
function chained(sides) {
  const beside = new Map(), out = [];
  const link = (from, to) => beside.set(from, [...(beside.get(from) || []), to]);
  for (let k = 0; k < sides.length; k += 2) {
    link(sides[k], sides[k + 1]);
    link(sides[k + 1], sides[k]);
  }
  const take = (from) => {
    const to = (beside.get(from) || []).pop();
    if (to !== undefined) beside.get(to).splice(beside.get(to).indexOf(from), 1);
    return to;
  };
  for (const first of beside.keys())
    for (let at = take(first); at !== undefined; at = take(first)) {
      const ring = [first];
      for (; at !== undefined && at !== first; at = take(at)) ring.push(at);
      out.push(ring);
    }
  return out;
}

const corner = (v) => [vertices[2 * v], vertices[2 * v + 1]];

function isWithin(ring, [x, y]) {
  return ring.reduce((odd, v, k) => {
    const [x0, y0] = corner(v), [x1, y1] = corner(ring[(k + 1) % ring.length]);
    return y0 > y !== y1 > y && x < x0 + ((y - y0) / (y1 - y0)) * (x1 - x0) ? !odd : odd;
  }, false);
}

/** The polygons of rings: each ring inside an even number of others, with the rings directly inside it as holes. */
function nested(rings) {
  const middleOf = ([v, w]) => corner(v).map((x, k) => (x + corner(w)[k]) / 2);
  const around = rings.map((ring) => rings.filter((other) => other !== ring && isWithin(other, middleOf(ring))));
  const outer = rings.filter((_, k) => around[k].length % 2 === 0);
  return outer.map((ring) => [ring, ...rings.filter((_, k) => around[k].includes(ring) && around[k].length === around[rings.indexOf(ring)].length + 1)]);
}

const solid = (() => {
  const array = centred(vertices, bodyCentre);
  const sides = counts(scene.solid.edges);
  return {faces: shell(array, d === 3 ? counts(scene.solid.triangles) : filled(nested(chained(sides)))), edges: shell(array, sides)};
})();

/** Fill a group with the faces and edges of S; the group's matrix places them. */
function fillSolid(group, name, opacity) {
  const kind = d === 3 ? THREE.MeshLambertMaterial : THREE.MeshBasicMaterial;
  if (opacity > 0)
    group.add(new THREE.Mesh(solid.faces, new kind({color: tint(name), side: THREE.DoubleSide, flatShading: d === 3,
      transparent: opacity < 1, opacity, depthWrite: opacity === 1, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1})));
  group.add(new THREE.LineSegments(solid.edges, new THREE.LineBasicMaterial({color: tint(opacity > 0 ? "ink" : "soft")})));
  group.matrixAutoUpdate = false;
}

/** Move S to its position at t. Its vertices are relative to bodyCentre, its position to worldCentre. */
function moveTo(group, t) {
  const rows = mapAt("place", t), moved = carry(rows, bodyCentre), m = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
  for (let i = 0; i < d; i++) {
    for (let j = 0; j < d; j++) m[4 * i + j] = rows[i * (d + 1) + j];
    m[4 * i + 3] = moved[i] - worldCentre[i];
  }
  group.matrix.set(...m);
  group.matrixWorldNeedsUpdate = true;
}

/** Signed distances of the vertices of a judged mesh; colours for inside, boundary and outside; the greatest size. */
const meshDistances = scene.mesh ? doubles(scene.mesh.distances) : [], MESH_TINTS = ["#0072b2", "#f0f0f0", "#d55e00"];
const meshMost = meshDistances.reduce((most, x) => Math.max(most, Math.abs(x)), 0);

/** Sources of the arcs of an exact boundary: what they are, and their colours, as in a picture. */
const ARCS = {path: ["path of a vertex", "#0072b2"], edge: ["edge at one time", "#d55e00"], envelope: ["envelope of an edge", "#cc79a7"]};

/** The boundary of the sweep. */
function sweepObject() {
  const array = centred(floats(scene.surface.vertices), [0, 0, 0]), lines = (index, color) => new THREE.LineSegments(shell(array, counts(index)), new THREE.LineBasicMaterial({color}));
  if (scene.surface.sources) {
    const group = new THREE.Group();
    for (const [source, index] of Object.entries(scene.surface.sources)) group.add(lines(index, colour(ARCS[source][1])));
    return group;
  }
  if (d === 2) return lines(scene.surface.faces, tint("ink"));
  const faces = counts(scene.surface.faces);
  const geometry = shell(array, faces);
  return new THREE.Mesh(geometry, new THREE.MeshLambertMaterial({color: tint("sweep"), side: THREE.DoubleSide, flatShading: true,
    transparent: true, opacity: 0.5, depthWrite: false}));
}

/** The colour of a signed distance, from that of the inside through a neutral one at the boundary to that of the outside. */
function distanceColour(share) {
  return colour(MESH_TINTS[1]).lerp(colour(MESH_TINTS[share < 0 ? 0 : 2]), Math.sqrt(Math.abs(share)));
}

/** The mesh that is judged, each vertex in the colour of its distance. */
function meshObject() {
  const geometry = shell(floats(scene.mesh.vertices), counts(scene.mesh.faces));
  const tints = [...meshDistances].flatMap((x) => distanceColour(meshMost ? x / meshMost : 0).toArray());
  geometry.setAttribute("color", new THREE.Float32BufferAttribute(tints, 3));
  return new THREE.Mesh(geometry, new THREE.MeshLambertMaterial({vertexColors: true, side: THREE.DoubleSide, flatShading: true}));
}

/** Pixels of the cells, one for each part; pixels outside the set are transparent. */
function cellPixels() {
  const {count, parts: n} = scene.cells, [across, up] = count, width = across * n, height = up * n;
  const out = new Uint32Array(width * height), tone = octets(scene.cells.tones), part = octets(scene.cells.part);
  const paint = scene.tones.map(([name, tint]) => (name === "exterior" || name === "out" ? 0
    : 0xff000000 | parseInt(tint.slice(5, 7) + tint.slice(3, 5) + tint.slice(1, 3), 16)) >>> 0);
  for (let y = 0; y < height; y++)
    for (let x = 0, row = Math.floor(y / n) * across; x < width; x++) out[(height - 1 - y) * width + x] = paint[tone[row + Math.floor(x / n)]];
  counts(scene.cells.split).forEach((cell, k) => {
    const x0 = (cell % across) * n, y0 = Math.floor(cell / across) * n;
    for (let i = 0; i < n * n; i++) out[(height - 1 - y0 - Math.floor(i / n)) * width + x0 + (i % n)] = paint[part[k * n * n + i]];
  });
  return new ImageData(new Uint8ClampedArray(out.buffer), width, height);
}

/** The sweep filled by class, in the plane or in a plane of space. */
function cellsObject(most) {
  const image = cellPixels(), whole = document.createElement("canvas"), scale = Math.min(1, most / Math.max(image.width, image.height));
  Object.assign(whole, {width: image.width, height: image.height});
  whole.getContext("2d").putImageData(image, 0, 0);
  const canvas = document.createElement("canvas");
  Object.assign(canvas, {width: Math.ceil(image.width * scale), height: Math.ceil(image.height * scale)});
  canvas.getContext("2d").drawImage(whole, 0, 0, canvas.width, canvas.height);
  const map = new THREE.CanvasTexture(canvas);
  Object.assign(map, {colorSpace: "srgb", magFilter: 1003, generateMipmaps: true});
  const geometry = new THREE.BufferGeometry(), c = scene.cells.corners;
  const corner = (i, j) => [0, 1, 2].map((k) => c[k] + i * (c[3 + k] - c[k]) + j * (c[6 + k] - c[k]) - (k < d ? worldCentre[k] : 1));
  geometry.setAttribute("position", new THREE.Float32BufferAttribute([[0, 0], [1, 0], [1, 1], [0, 1]].flatMap(([i, j]) => corner(i, j)), 3));
  geometry.setAttribute("uv", new THREE.Float32BufferAttribute([0, 0, 1, 0, 1, 1, 0, 1], 2));
  geometry.setIndex([0, 1, 2, 0, 2, 3]);
  const out = new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({map, transparent: true, side: THREE.DoubleSide, alphaTest: 0.5}));
  out.renderOrder = -1;
  return out;
}

/** Lines at round numbers on the floor of a box of space. */
function floorObject([low, high], shift) {
  const at = [];
  for (const axis of [0, 1])
    for (const x of ticks(low[axis] + shift[axis], high[axis] + shift[axis], 6)) {
      const a = [low[0], low[1], low[2]], b = [high[0], high[1], low[2]];
      a[axis] = b[axis] = x - shift[axis];
      at.push(...a, ...b);
    }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.Float32BufferAttribute(at, 3));
  return new THREE.LineSegments(geometry, new THREE.LineBasicMaterial({color: tint("grid")}));
}

const signsOf = {};

/** Make the signs of contacts in the colours of the theme. */
function makeSigns() {
  for (const [name, shape] of [["f", "circle"], ["e", "square"], ["v", "triangle"]]) {
    signsOf["X" + name] = signTexture(shape, tint("ink"), tint("paper"));
    signsOf["T" + name] = signTexture(shape, tint("paper"), "#d55e00");
    signsOf["S" + name] = signTexture(shape, tint("slide"), tint("ink"));
  }
}

const disk = signTexture("circle", "#ffffff", "#222222");
const wrongDisk = signTexture("square", "#ffffff", "#000000");

const body = (place) => place.map((x, k) => x - (k < d ? bodyCentre[k] : 0));
/** The place of a point in the left view, relative to the centre of the view's box. */
const world = (k) => [0, 1, 2].map((i) => (i < d ? places[k * d + i] : 0));

const contactPlace = (p, c) => body(carry(mapAt("trace", (timeValue(c.from) + timeValue(c.to)) / 2), p.place));

/** Add to a group the trajectory of a point through the standing S, with its contacts. */
function trajectory(group, p) {
  let from = start, next = 0;
  [...p.word].forEach((letter) => {
    const contact = letter === "B" ? p.contacts[next++] : p.contacts[next];
    const to = letter === "B" ? timeValue(contact.to) : contact ? timeValue(contact.from) : end;
    if (to > from) {
      const [name, width] = {B: ["slide", 6], I: ["ink", 4], O: ["ink", 1.5], "?": ["soft", 1.5]}[letter];
      group.add(polyline(trail(p.place, from, to).map(body), tint(name), width));
    }
    from = to;
  });
  for (const c of p.contacts) {
    const kinds = ["v", "e", "f"].filter((kind) => c.cells.some((x) => x[0] === kind)), met = (c.instant ? kinds[0] : kinds.pop()) || "f";
    if (!c.instant) slideEnds(group, p, c, met);
    addSign(group, contactPlace(p, c), (c.crossing ? "X" : "T") + met, 16);
  }
}

function addSign(group, place, name, size) {
  group.add(Object.assign(signs(place, null, signsOf[name], size, 3), {name}));
}

/** Add small signs at both ends of a slide: the sign of the cell at which it ends or, if there is no smaller one, of the
 * cell in which it slides. */
function slideEnds(group, p, c, inside) {
  const size = Math.hypot(...bodyBounds[1].map((x, k) => x - bodyBounds[0][k]));
  for (const time of [c.from, c.to]) {
    const place = carry(mapAt("trace", timeValue(time)), p.place);
    const met = c.cells.filter((cell) => "fp".indexOf(cell[0]) < 0 && farFrom(place, cell) < size / 2000).map((cell) => cell[0]);
    addSign(group, body(place), "S" + (met.includes("v") ? "v" : met.includes("e") && inside === "f" ? "e" : inside), 11);
  }
}

/** The distance of a place from an edge or a vertex of the standing S. */
function farFrom(place, cell) {
  const [a, b] = `${cell.slice(1)}-${cell.slice(1)}`.split("-").map((v) => [0, 1, 2].map((k) => (k < d ? vertices[d * Number(v) + k] : 0)));
  const way = b.map((x, k) => x - a[k]), off = place.map((x, k) => x - a[k]), dot = (u, v) => u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
  const share = Math.min(1, Math.max(0, dot(off, way) / (dot(way, way) || 1)));
  return Math.hypot(...off.map((x, k) => x - share * way[k]));
}
