// The motion in doubles. They only serve to draw; no answer depends on them.
// SPDX-License-Identifier: GPL-3.0-or-later

const scene = JSON.parse(document.getElementById("scene").textContent);
const d = scene.dimension;
const pieces = scene.motion.map((piece) => ({...piece, from: value(piece.t[0]), to: value(piece.t[1])}));
const start = pieces[0].from, end = pieces[pieces.length - 1].to;

/** Times that are large compared with the motion's length, such as seconds since 1970, are shown relative to t0. */
const zero = scene.since ? scene.motion[0].t[0] : null;

/** The text of a time beside the slider. */
function clockText(t, digits) {
  return zero ? `t − t0 = ${Number((t - start).toPrecision(digits))}` : `t = ${Number(t.toPrecision(digits))}`;
}

function horner(coefficients, u) {
  let sum = 0;
  for (let k = coefficients.length - 1; k >= 0; k--) sum = sum * u + coefficients[k];
  return sum;
}

/** The rows of a map at a time: d rows of d + 1 numbers. `which` is "place" or "trace". */
function mapAt(which, t) {
  let k = 0;
  while (k + 1 < pieces.length && t > pieces[k].to) k += 1;
  const piece = pieces[k], map = piece[which];
  const u = Math.min(1, Math.max(0, (t - piece.from) / (piece.to - piece.from)));
  const weight = horner(map.weight, u);
  return map.entries.map((entry) => horner(entry, u) / weight);
}

/** The image of a point, always with three coordinates. */
function carry(rows, point) {
  const out = [0, 0, 0];
  for (let i = 0; i < d; i++) {
    out[i] = rows[i * (d + 1) + d];
    for (let j = 0; j < d; j++) out[i] += rows[i * (d + 1) + j] * point[j];
  }
  return out;
}

/** Places of a point's trajectory through the standing S between two times. */
function trail(point, from, to) {
  const times = [from], count = Math.max(2, Math.ceil((240 * (to - from)) / (end - start)));
  for (let k = 1; k < count; k++) times.push(from + ((to - from) * k) / count);
  for (const piece of pieces) if (piece.from > from && piece.from < to) times.push(piece.from);
  times.push(to);
  times.sort((a, b) => a - b);
  return times.map((t) => carry(mapAt("trace", t), point));
}
