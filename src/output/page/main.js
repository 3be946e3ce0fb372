// The page: two views, a slider, filters, and what is said of a point.
// SPDX-License-Identifier: GPL-3.0-or-later

const $ = (id) => document.getElementById(id);
const points = scene.points.map(pointOf);
const errors = [];
window.addEventListener("error", (event) => errors.push(String(event.message)));

const space = new View("world"), standing = new View("body");
const moving = solidGroup(0xf0e442, 1);
const sweep = new THREE.Group(), positions = new THREE.Group(), marks = new THREE.Group();
const trails = new THREE.Group(), here = new THREE.Group();
let shown = [], chosen = -1, now = start;

space.scene.add(moving, sweep, positions, marks);
standing.scene.add(solidGroup(0xd8d8d8, d === 3 ? 0.45 : 1), trails, here);
if (scene.surface) sweep.add(sweepObject());
for (let k = 0; k < scene.times; k++) {
  const ghost = solidGroup(0x888888, 0);
  moveTo(ghost, start + ((end - start) * k) / (scene.times - 1));
  positions.add(ghost);
}

function setTime(t) {
  now = Math.min(end, Math.max(start, t));
  $("time").value = String(Math.round((1000 * (now - start)) / (end - start)));
  $("clock").textContent = `t = ${Number(now.toPrecision(9))}`;
  moveTo(moving, now);
  dispose(here);
  if (chosen >= 0) here.add(signs([body(carry(mapAt("trace", now), points[chosen].place))], null, disk, 13, 4));
  space.ask();
  standing.ask();
}

function passes(p) {
  const box = document.querySelector(`#classes input[value="${p.class}"]`);
  const stratum = $("strata").value, wrong = $("wrong").value;
  return (!box || box.checked) && (stratum === "*" || p.stratum === stratum) &&
    (wrong === "all" || (wrong === "wrong") === Boolean(p.answer));
}

/** Show the points that the filters let through; those on which the candidate is wrong are square. */
function filter() {
  shown = points.filter(passes);
  dispose(marks);
  const size = points.length > 20000 ? 5 : points.length > 2000 ? 8 : 12;
  for (const wrong of [false, true]) {
    const some = shown.filter((p) => Boolean(p.answer) === wrong);
    const tints = some.map((p) => colour(scene.tones[p.tone][1]).toArray());
    if (some.length) marks.add(signs(some.map((p) => world(p.place)), tints, wrong ? wrongDisk : disk, wrong ? size + 5 : size, 1));
  }
  if (chosen >= 0) marks.add(signs([world(points[chosen].place)], [colour(scene.tones[points[chosen].tone][1]).toArray()], disk, 20, 2));
  $("count").textContent = shown.length === points.length ? `(${points.length})` : `(${shown.length} of ${points.length})`;
  space.ask();
}

function line(text, kind) {
  const out = document.createElement(kind || "span");
  out.textContent = text + "\n";
  $("says").append(out);
  return out;
}

function say(p) {
  $("says").replaceChildren();
  line(p.stratum ? `${p.name} (${p.stratum})` : p.name, "b");
  line(answerLine(p));
  if (p.answer) line(`The candidate says ${p.answer}.`).className = "wrong";
  for (const text of endLines(p)) line(text);
  line("\nThe time line: I inside S, B on its boundary, O outside");
  for (const {lines, time} of timeLines(p)) {
    const out = line(lines[0], time === undefined ? "span" : "a");
    if (time !== undefined) out.addEventListener("click", () => setTime(time));
    for (const text of lines.slice(1)) line(text);
  }
  if (!unsweep) for (const text of countLines(p)) line(text);
  for (const text of ruleLines(p)) line(text);
}

function choose(index) {
  chosen = index;
  dispose(trails);
  if (points.length <= 40) points.forEach((p, k) => k !== chosen && trajectory(trails, p, false));
  if (chosen >= 0) {
    trajectory(trails, points[chosen], true);
    say(points[chosen]);
  }
  filter();
  setTime(now);
}

function step(by) {
  if (!shown.length) return;
  const at = shown.findIndex((p) => p.index === chosen);
  choose(shown[(at + by + shown.length) % shown.length].index);
}

/** A click that is no drag chooses the point under it. */
function onClick(view, places, numbers) {
  let down = null;
  view.canvas.addEventListener("pointerdown", (event) => (down = [event.clientX, event.clientY]));
  view.canvas.addEventListener("pointerup", (event) => {
    if (!down || Math.hypot(event.clientX - down[0], event.clientY - down[1]) > 4) return;
    const found = view.pick(event.clientX, event.clientY, places());
    if (found >= 0) choose(numbers(found));
  });
}

function fitBoth() {
  space.fit([0, 0, 0], half(worldBounds) * 1.08);
  standing.fit([0, 0, 0], half(bodyBounds) * (points.length ? 1.9 : 1.1));
}

function fillFilters() {
  const classes = new Map();
  for (const p of points) classes.set(p.class, (classes.get(p.class) || 0) + 1);
  scene.tones.forEach(([name, tint]) => {
    if (!classes.has(name)) return;
    const label = document.createElement("label"), box = document.createElement("input"), swatch = document.createElement("span");
    Object.assign(box, {type: "checkbox", checked: true, value: name});
    swatch.className = "swatch";
    swatch.style.background = tint;
    label.append(box, swatch, `${name} (${classes.get(name)})`);
    $("classes").append(label);
  });
  const strata = [...new Set(points.map((p) => p.stratum).filter(Boolean))].sort();
  $("strata").append(new Option("all", "*"), ...strata.map((name) => new Option(name, name)));
  $("strata-label").hidden = strata.length === 0;
  $("wrong-label").hidden = !points.some((p) => p.answer);
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

function begin() {
  const surface = scene.surface, name = unsweep ? "unsweep" : "sweep";
  document.title = scene.title || "Graze";
  $("title").textContent = document.title;
  $("remark").textContent = `${points.length} points, classified exactly` + (surface
    ? ` · boundary of the ${name} sampled at level ${surface.level}: details smaller than a cell may be missing` : "") +
    ` · graze ${scene.version}`;
  $("world-title").textContent = unsweep ? "M(t)⁻¹S, the unsweep, the points" : "S at t, the sweep, the points";
  $("body-title").textContent = (unsweep ? "M(t)P" : "Inverted trajectory M(t)⁻¹P") + " through the standing S";
  $("sweep-name").textContent = name;
  $("show-sweep").parentElement.hidden = !surface;
  $("show-positions").checked = !surface;
  for (const [id, group] of [["show-solid", moving], ["show-sweep", sweep], ["show-positions", positions]]) {
    const update = () => {
      group.visible = $(id).checked;
      space.ask();
    };
    $(id).addEventListener("change", update);
    update();
  }
  fillFilters();
  $("time").addEventListener("input", () => setTime(start + ((end - start) * Number($("time").value)) / 1000));
  $("play").addEventListener("click", play);
  $("previous").addEventListener("click", () => step(-1));
  $("next").addEventListener("click", () => step(1));
  $("world-fit").addEventListener("click", fitBoth);
  $("body-fit").addEventListener("click", fitBoth);
  onClick(space, () => shown.map((p) => world(p.place)), (k) => shown[k].index);
  fitBoth();
  const wrong = points.findIndex((p) => p.answer);
  choose(wrong >= 0 ? wrong : points.length && points.length <= 40 ? 0 : -1);
  document.documentElement.dataset.ready = "yes";
}

window.graze = {points, errors, choose, setTime, moving, sweep, space, standing, shown: () => shown, chosen: () => chosen,
  pixelOf: (k) => space.pixel(world(points[k].place)), frame: () => space.measure() + standing.measure()};
begin();
