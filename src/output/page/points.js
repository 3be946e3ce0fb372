// The points: arrays by which all are drawn, and the line of one point taken apart.
// SPDX-License-Identifier: GPL-3.0-or-later

const unsweep = scene.operation === "unsweep";
const IN = new Set(["regular", "fold", "fold_boundary", "in"]);

/** Places relative to the centre of the page's box, d numbers for each point, and numbers of tones. */
const places = floats(scene.points.places), tones = octets(scene.points.tones);
const pointCount = tones.length, lines = scene.points.lines;
const toneName = (k) => scene.tones[k][0];
const nameOf = (k) => (scene.points.names && scene.points.names[k]) || "";
const stratumOf = (k) => (scene.points.strata && scene.points.strata[k]) || "";
const answerOf = (k) => scene.points.answers[k] || "";
const wrongCount = Object.keys(scene.points.answers).length;

/** A time: a ratio, or {decimal, poly, low, high}, the last three empty where the page has no room for them. */
function timeOf(text) {
  const [decimal, poly, low, high] = text.split("~");
  return poly === undefined ? decimal : {decimal, poly, low, high};
}

const timeValue = (time) => (typeof time === "string" ? value(time) : Number(time.decimal));

function contactOf(text, word, letter) {
  const [from, to, what] = text.split(","), [kind, ...cells] = what.split(" ");
  return {from: timeOf(from), to: timeOf(to || from), instant: to === "", crossing: kind === "X", cells,
    left: word[letter - 1] || "", right: word[letter + 1] || ""};
}

/** A point by names. */
function pointAt(index) {
  const [at, word, numbers, contacts, place, why, pmc] = lines[index].split("|");
  const [definition, position, i, t] = numbers.split(" ").map(Number);
  const point = {index, at: at.split(" "), word, definition, case: position, i, t, tone: tones[index], name: nameOf(index),
    stratum: stratumOf(index), answer: answerOf(index), class: toneName(tones[index])};
  point.place = point.at.map(value);
  point.open = place && {...contactOf(place, "", 0), why};
  point.pmc = pmc || (unsweep ? point.class : IN.has(point.class) ? "in" : point.class === "boundary" ? "on" : "out");
  let letter = -1;
  point.contacts = contacts ? contacts.split(";").map((text) => contactOf(text, word, (letter = word.indexOf("B", letter + 1)))) : [];
  return point;
}
