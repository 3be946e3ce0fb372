// The page: two views, a slider, filters, keys.
// SPDX-License-Identifier: GPL-3.0-or-later

/** At most MOST_DRAWN points are drawn; with more than MANY points the page opens with some of them filtered out; at most
 * MOST_NAMED have their names beside them. */
const MOST_DRAWN = 20000, MANY = 5000, MOST_NAMED = 400;

const errors = [];
window.addEventListener("error", (event) => errors.push(String(event.message)));

const moving = new THREE.Group(), sweep = new THREE.Group(), cells = new THREE.Group(), positions = new THREE.Group();
const marks = new THREE.Group(), standingSolid = new THREE.Group(), trails = new THREE.Group(), here = new THREE.Group();
const floors = [new THREE.Group(), new THREE.Group()];
const worldHome = around(worldBounds, worldCentre), bodyHome = around(bodyBounds, bodyCentre);
let shown = [], drawn = [], chosen = null, now = start;

const space = new View("world", (view, labels) => {
  d === 2 ? planeAxes(view, labels, worldCentre) : spaceAxes(view, labels, worldHome, worldCentre);
  namePoints(view, labels);
});
const standing = new View("body", (view, labels) => {
  d === 2 ? planeAxes(view, labels, bodyCentre) : spaceAxes(view, labels, bodyHome, bodyCentre);
  nameContacts(view, labels);
});

space.scene.add(floors[0], cells, moving, sweep, positions, marks);
standing.scene.add(floors[1], standingSolid, trails, here);

const pointName = (k) => nameOf(k) || String(k + 1);

function namePoints(view, labels) {
  const index = chosen ? chosen.index : -1, named = wrongCount ? drawn.filter((k) => answerOf(k)) : drawn;
  const names = named.length <= MOST_NAMED ? named.filter((k) => k !== index) : [];
  const spots = names.map((k) => view.spot(world(k)));
  for (const [x, y] of spots) labels.avoid(x, y, 4);
  if (index >= 0) {
    const [x, y] = view.spot(world(index));
    labels.avoid(x, y, 7);
    labels.beside(pointName(index), x, y, 13, true);
  }
  names.forEach((k, i) => labels.beside(pointName(k), spots[i][0], spots[i][1], 9, false));
}

function nameContacts(view, labels) {
  if (!chosen) return;
  const spots = chosen.contacts.map((c) => view.spot(contactPlace(chosen, c)));
  for (const [x, y] of spots) labels.avoid(x, y, 5);
  chosen.contacts.forEach((c, k) => labels.beside(clockText(timeValue(c.from), 4) + (c.instant ? "" : ` to ${clockText(timeValue(c.to), 4).split("= ")[1]}`),
    spots[k][0], spots[k][1], 9, true, CORNERS));
}

/** Fill both scenes, in the colours of the theme. */
function paint() {
  for (const group of [moving, sweep, cells, positions, standingSolid, ...floors]) dispose(group);
  makeSigns();
  fillSolid(moving, "moving", d === 3 ? 1 : 0.55);
  fillSolid(standingSolid, "solid", d === 3 ? 0.5 : 1);
  if (scene.surface) sweep.add(sweepObject());
  if (scene.mesh) sweep.add(meshObject());
  cells.add(cellsObject(Math.min(4096, space.renderer.capabilities.maxTextureSize)));
  for (let k = 0; k < scene.times; k++) {
    const ghost = new THREE.Group();
    fillSolid(ghost, "soft", 0);
    moveTo(ghost, start + ((end - start) * k) / (scene.times - 1));
    positions.add(ghost);
  }
  if (d === 3) [worldHome, bodyHome].forEach((home, k) => floors[k].add(floorObject(home, k ? bodyCentre : worldCentre)));
  drawTrail();
  drawPoints();
  setTime(now);
}

function setTime(t) {
  now = Math.min(end, Math.max(start, t));
  $("time").value = String(Math.round((1000 * (now - start)) / (end - start)));
  $("clock").textContent = clockText(now, 9);
  moveTo(moving, now);
  dispose(here);
  if (chosen) here.add(signs(body(carry(mapAt("trace", now), chosen.place)), null, disk, 14, 4));
  space.ask();
  standing.ask();
}

/** Numbers of the points that the filters let through. */
function passing() {
  const off = new Set([...document.querySelectorAll("#classes input:not(:checked)")].map((box) => box.value));
  const passes = scene.tones.map(([name]) => !off.has(name)), stratum = $("strata").value, wrong = $("wrong").value, out = [];
  for (let k = 0; k < pointCount; k++)
    if (passes[tones[k]] && (stratum === "*" || stratumOf(k) === stratum) && (wrong === "all" || (wrong === "wrong") === Boolean(answerOf(k))))
      out.push(k);
  return out;
}

/** Draw the points of `drawn`. Points on which the candidate is wrong are large squares, and then the others are small; the
 * chosen point is large. */
function drawPoints() {
  dispose(marks);
  const size = drawn.length > 5000 ? 6 : drawn.length > 1000 ? 9 : 12;
  for (const wrong of [false, true]) {
    const some = drawn.filter((k) => Boolean(answerOf(k)) === wrong);
    const paints = scene.tones.map(([, tint]) => colour(tint).toArray());
    if (some.length)
      marks.add(signs(some.flatMap(world), some.flatMap((k) => paints[tones[k]]), wrong ? wrongDisk : disk, sizeOf(wrong, size), wrong ? 2 : 1));
  }
  if (chosen) marks.add(signs(world(chosen.index), colour(scene.tones[chosen.tone][1]).toArray(), chosen.answer ? wrongDisk : disk, 22, 3));
  space.ask();
}

const sizeOf = (wrong, size) => (wrong ? Math.max(16, size) : wrongCount ? 5 : size);
const grouped = (n) => String(n).replace(/\B(?=(\d{3})+$)/g, ",");

/** Show the points that pass the filters, and tell how many they are. */
function filter() {
  shown = passing();
  const stride = Math.ceil(shown.length / MOST_DRAWN);
  drawn = stride > 1 ? shown.filter((_, k) => k % stride === 0) : shown;
  const some = shown.length === pointCount ? "" : `${grouped(shown.length)} of `;
  $("count").textContent = `${some}${grouped(pointCount)} ${pointCount === 1 ? "point" : "points"}` +
    (stride > 1 ? `; ${grouped(drawn.length)} of these are drawn, filters bring out the others` : "");
  drawPoints();
}

function drawTrail() {
  dispose(trails);
  if (chosen) trajectory(trails, chosen);
}

function choose(index) {
  chosen = index >= 0 ? pointAt(index) : null;
  drawTrail();
  if (chosen) say(chosen, setTime);
  drawPoints();
  setTime(now);
}

function step(by) {
  if (!shown.length) return;
  const at = chosen ? shown.indexOf(chosen.index) : -1;
  choose(shown[(at + (at < 0 && by < 0 ? 0 : by) + shown.length) % shown.length]);
}

/** A click that is no drag chooses the point under it. */
function onClick(view) {
  let down = null;
  view.canvas.addEventListener("pointerdown", (event) => (down = [event.clientX, event.clientY]));
  view.canvas.addEventListener("pointerup", (event) => {
    if (!down || Math.hypot(event.clientX - down[0], event.clientY - down[1]) > 6) return;
    const found = view.pick(event.clientX, event.clientY, drawn, world, event.pointerType === "touch" ? 24 : 9);
    if (found >= 0) choose(found);
  });
}

/** Enlarge a box to hold the points that are at most half its longest side away from it. */
function withPoints([low, high]) {
  const off = Math.max(...high.map((x, i) => x - low[i])) / 2, grown = [[...low], [...high]];
  for (let k = 0; k < pointCount; k++) {
    const at = world(k);
    if (!at.every((x, i) => x >= low[i] - off && x <= high[i] + off)) continue;
    at.forEach((x, i) => {
      grown[0][i] = Math.min(grown[0][i], x);
      grown[1][i] = Math.max(grown[1][i], x);
    });
  }
  return grown;
}

function fitBoth() {
  space.fit(withPoints(worldHome));
  const room = d === 3 ? 1.15 : 1.25;
  standing.fit(bodyHome.map((v) => v.map((x) => x * room)));
}

/** The legend of classes, whose boxes are filters too: those of points and of cells. */
function fillClasses() {
  const count = scene.tones.map(() => 0), inCells = new Set([...octets(scene.cells.tones), ...octets(scene.cells.part)]);
  for (const tone of tones) count[tone] += 1;
  scene.tones.forEach(([name, tint], k) => {
    if (!count[k] && !inCells.has(k)) return;
    const label = put($("classes"), "label", ""), box = put(label, "input", "");
    Object.assign(box, {type: "checkbox", checked: true, value: name, hidden: !count[k]});
    put(label, "span", "swatch").style.background = tint;
    label.append(name + (count[k] ? ` ${grouped(count[k])}` : ""));
  });
  return count;
}

function fillFilters() {
  const count = fillClasses(), strata = scene.points.strata ? [...new Set(scene.points.strata)].filter(Boolean).sort() : [];
  $("strata").append(new Option("all", "*"), ...strata.map((name) => new Option(name, name)));
  $("strata-label").hidden = strata.length === 0;
  $("wrong-label").hidden = wrongCount === 0;
  $("steps").hidden = pointCount === 0;
  if (wrongCount && pointCount > MANY) $("wrong").value = "wrong";
  const on = scene.tones.findIndex(([name], k) => count[k] && (name === "boundary" || name === "on"));
  if (!wrongCount && pointCount > MANY && on >= 0)
    for (const box of document.querySelectorAll("#classes input")) box.checked = box.value === toneName(on);
  for (const id of ["classes", "strata", "wrong"]) $(id).addEventListener("change", filter);
}

function play() {
  const button = $("play"), running = button.textContent === "stop";
  button.textContent = running ? "play" : "stop";
  if (running) return;
  let last = performance.now();
  const tick = (at) => {
    if (button.textContent !== "stop") return;
    const next = now + ((end - start) * (at - last)) / 5000;
    last = at;
    setTime(next > end ? start : next);
    requestAnimationFrame(tick);
  };
  requestAnimationFrame(tick);
}

/** Move the time to the chosen point's next contact or, if `by` is negative, to the contact before. */
function contact(by) {
  const times = chosen ? chosen.contacts.flatMap((c) => [timeValue(c.from), timeValue(c.to)]) : [], far = (end - start) * 1e-9;
  const next = by > 0 ? times.find((t) => t > now + far) : times.reverse().find((t) => t < now - far);
  if (next !== undefined) setTime(next);
}

const KEYS = {
  " ": play, n: () => step(1), p: () => step(-1), f: fitBoth, d: () => $("theme").click(), "?": () => $("keys").toggleAttribute("hidden"),
  Escape: () => ($("keys").hidden = true), ArrowLeft: () => setTime(now - (end - start) / 100), ArrowRight: () => setTime(now + (end - start) / 100),
  Home: () => setTime(start), End: () => setTime(end), ".": () => contact(1), ",": () => contact(-1),
  "+": () => [space, standing].forEach((view) => view.zoom(1.2)), "-": () => [space, standing].forEach((view) => view.zoom(1 / 1.2)),
};

function onKey(event) {
  const act = KEYS[event.key], busy = /^(INPUT|SELECT|BUTTON)$/.test(event.target.tagName) && /^( |Arrow.*|Home|End)$/.test(event.key);
  if (!act || busy || event.ctrlKey || event.metaKey || event.altKey) return;
  event.preventDefault();
  act();
}

/** The toggles of what is shown: name of the box, group, shown at first. */
function fillToggles() {
  const toggles = [["solid", moving, !scene.mesh], ["sweep", sweep, true], ["cells", cells, d === 2], ["positions", positions, d === 2 ? false : !scene.surface && !scene.mesh]];
  for (const [name, group, first] of toggles) {
    const box = $("show-" + name), update = () => {
      group.visible = box.checked;
      space.ask();
    };
    box.checked = first;
    box.addEventListener("change", update);
    update();
  }
  $("show-sweep").parentElement.hidden = !scene.surface && !scene.mesh;
}

function fillTexts() {
  const surface = scene.surface, name = unsweep ? "unsweep" : "sweep";
  document.title = scene.title || "Graze";
  $("title").textContent = document.title;
  $("remark").textContent = "classified exactly" + (surface && surface.sources ? ` · boundary of the ${name} by its exact arcs` : surface
    ? ` · boundary of the ${name} sampled at level ${surface.level}, details smaller than a cell may be missing` : "") + (scene.primitives ? " · S is drawn as triangles made for the eye" : "") + (zero ? ` · t0 = ${decimal(zero, 17).text}` : "") + ` · graze ${scene.version}`;
  $("distances").hidden = !scene.mesh;
  for (const [id, sign] of [["mesh-inside", "−"], ["mesh-outside", ""]]) $(id).textContent = sign + meshMost.toPrecision(3);
  $("world-title").textContent = scene.mesh ? "S at time t and the mesh" : unsweep ? "M(t)⁻¹S and the unsweep" : "S at time t and the sweep";
  $("body-title").textContent = (unsweep ? "M(t)P" : "M(t)⁻¹P, the inverted trajectory of the point,") + " through the standing S";
  $("sweep-name").textContent = scene.mesh ? "mesh" : d === 2 ? `boundary of the ${name}` : name;
  for (const [source, index] of Object.entries((surface && surface.sources) || {}))
    if (index) $("sweep-name").append(" · ", Object.assign(document.createElement("span"), {textContent: ARCS[source][0], style: `color: ${ARCS[source][1]}`}));
  $("cells-name").textContent = d === 2 ? "classes" : `classes in ${scene.cells.plane}`;
  document.body.dataset.points = pointCount ? "some" : "none";
  const [low, high] = worldBounds;
  if (d === 2 && high[0] - low[0] > 1.5 * (high[1] - low[1])) document.body.dataset.wide = "yes";
}

/** On a narrow window one part is seen at a time, and legends are closed at first. */
function onTabs() {
  if (matchMedia("(max-width: 820px)").matches) document.querySelectorAll(".legend").forEach((legend) => (legend.open = false));
  for (const tab of document.querySelectorAll("#tabs button"))
    tab.addEventListener("click", () => {
      document.body.dataset.tab = tab.value;
      for (const other of document.querySelectorAll("#tabs button")) other.setAttribute("aria-pressed", String(other === tab));
      fitBoth();
    });
}

/** Take the scripts of graze-check, where the page has them: they put a button into the head that proves the points. */
function takeChecker() {
  if (!scene.proof || !scene.proof.checker) return;
  const page = new DOMParser().parseFromString(new TextDecoder().decode(bytes(scene.proof.checker)), "text/html");
  for (const one of [...page.scripts].slice(0, 2)) {
    const script = document.createElement("script");
    script.textContent = one.textContent;
    document.body.append(script);
  }
}

function begin() {
  fillTexts();
  takeChecker();
  setTheme("");
  fillToggles();
  fillFilters();
  paint();
  themeListeners.push(paint);
  dark.addEventListener("change", () => setTheme(""));
  $("theme").addEventListener("click", () => setTheme(document.documentElement.dataset.theme === "dark" ? "light" : "dark"));
  $("time").addEventListener("input", () => setTime(start + ((end - start) * Number($("time").value)) / 1000));
  for (const [id, act] of [["play", play], ["previous", () => step(-1)], ["next", () => step(1)], ["world-fit", fitBoth], ["body-fit", fitBoth],
    ["help", KEYS["?"]]]) $(id).addEventListener("click", act);
  document.addEventListener("keydown", onKey);
  onTabs();
  onClick(space);
  fitBoth();
  filter();
  const wrong = shown.find((k) => answerOf(k));
  choose(wrong !== undefined ? wrong : shown.length ? shown[0] : -1);
  $("loading").remove();
  document.documentElement.dataset.ready = "yes";
}

window.graze = {count: pointCount, point: pointAt, errors, choose, setTime, moving, sweep, cells, trails, space, standing, shown: () => shown,
  drawn: () => drawn, chosen: () => (chosen ? chosen.index : -1), pixelOf: (k) => space.pixel(world(k)),
  sizes: () => marks.children.map((some) => [some.geometry.attributes.position.count, some.material.size]),
  frame: () => space.measure() + standing.measure()};
setTimeout(begin);
