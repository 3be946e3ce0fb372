// Axes: round numbers along the sides of a view of the plane, or along edges of a box in space.
// SPDX-License-Identifier: GPL-3.0-or-later

/** Round numbers from low to high, about `wanted` of them. */
function ticks(low, high, wanted) {
  const rough = (high - low) / Math.max(1, wanted), power = Math.pow(10, Math.floor(Math.log10(rough)));
  const step = [1, 2, 5, 10].map((k) => k * power).find((s) => s >= rough * 0.999);
  const out = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + step * 1e-9 && out.length < 100; k++) out.push(Number((k * step).toPrecision(12)));
  return out;
}

const numberText = (x) => String(Number(x.toPrecision(9))).replace("-", "−");

function strokeLine(c, from, to) {
  c.beginPath();
  c.moveTo(...from);
  c.lineTo(...to);
  c.stroke();
}

/** Numbers along the left and the lower side. `shift` is added to places for coordinates. */
function planeAxes(view, labels, shift) {
  const c = labels.context, {width, height} = labels, camera = view.camera;
  const across = (camera.right - camera.left) / camera.zoom, up = (camera.top - camera.bottom) / camera.zoom;
  const left = camera.position.x - across / 2 + shift[0], below = camera.position.y - up / 2 + shift[1];
  c.strokeStyle = tint("axis");
  c.lineWidth = 1;
  labels.at("x", width - 10, height - 15);
  labels.at("y", 13, 14);
  strokeLine(c, [0.5, 0], [0.5, height]);
  strokeLine(c, [0, height - 0.5], [width, height - 0.5]);
  for (const x of ticks(left, left + across, width / 90)) {
    const at = ((x - left) / across) * width;
    strokeLine(c, [at, height - 6], [at, height]);
    if (at > 34 && at < width - 34) labels.at(numberText(x), at, height - 15);
  }
  for (const y of ticks(below, below + up, height / 70)) {
    const at = height - ((y - below) / up) * height, text = numberText(y);
    strokeLine(c, [0, at], [6, at]);
    if (at > 40 && at < height - 40) labels.at(text, 11 + c.measureText(text).width / 2, at);
  }
}

/** The edge of the box, along an axis, that carries the numbers: for a horizontal axis the edge of the floor that is
 * lowest on the canvas, for the upright axis the leftmost edge. */
function edgeOf(view, [low, high], axis) {
  const [i, j] = [0, 1, 2].filter((k) => k !== axis);
  const floor = view.camera.position.z >= low[2] ? low[2] : high[2];
  let best = null;
  for (const a of [low[i], high[i]])
    for (const b of axis === 2 ? [low[j], high[j]] : [floor]) {
      const from = [0, 0, 0], to = [0, 0, 0];
      [from[i], from[j], from[axis]] = [a, b, low[axis]];
      [to[i], to[j], to[axis]] = [a, b, high[axis]];
      const middle = view.spot(from.map((x, k) => (x + to[k]) / 2)), worth = axis === 2 ? -middle[0] : middle[1];
      if (!best || worth > best.worth) best = {worth, from, to};
    }
  return best;
}

/** Numbers along three edges of a box. */
function spaceAxes(view, labels, bounds, shift) {
  const c = labels.context, centre = view.spot(bounds[0].map((x, k) => (x + bounds[1][k]) / 2));
  c.strokeStyle = tint("axis");
  c.lineWidth = 1;
  for (let axis = 0; axis < 3; axis++) {
    const {from, to} = edgeOf(view, bounds, axis), a = view.spot(from), b = view.spot(to);
    const long = Math.hypot(b[0] - a[0], b[1] - a[1]);
    if (long < 30) continue;
    strokeLine(c, a, b);
    let away = [-(b[1] - a[1]) / long, (b[0] - a[0]) / long];
    if (away[0] * (a[0] - centre[0]) + away[1] * (a[1] - centre[1]) < 0) away = away.map((x) => -x);
    const beside = (at, off) => [at[0] + off * away[0], at[1] + off * away[1]];
    labels.at("xyz"[axis], ...beside([a[0] + (b[0] - a[0]) * 1.06, a[1] + (b[1] - a[1]) * 1.06], 12));
    for (const x of ticks(from[axis] + shift[axis], to[axis] + shift[axis], long / 70)) {
      const place = [...from];
      place[axis] = x - shift[axis];
      const at = view.spot(place);
      strokeLine(c, at, beside(at, 5));
      labels.at(numberText(x), ...beside(at, 15));
    }
  }
}
