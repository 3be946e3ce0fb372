// The sentences of `graze explain`, from SAYS (report/sentences.json): lines of texts and of values, which show a decimal until they are opened.
// SPDX-License-Identifier: GPL-3.0-or-later

/** A number with its middle digits left out where it is long. */
function shortened(ratio) {
  return ratio.replace(/\d+/g, (run) => (run.length <= 40 ? run : `${run.slice(0, 12)}...${run.slice(-12)}[${run.length} digits]`));
}

function polynomial(text) {
  const terms = text.split(" ").map((c, power) => [c, power]).filter(([c]) => c !== "0").reverse();
  let out = "";
  terms.forEach(([c, power], k) => {
    if (terms.length > 9 && k >= 3 && k < terms.length - 3) {
      if (k === 3) out += ` + ... [${terms.length - 6} terms left out] ...`;
      return;
    }
    const negative = c.startsWith("-"), size = negative ? c.slice(1) : c, unit = size === "1" && power > 0;
    out += k === 0 ? (negative ? "-" : "") : negative ? " - " : " + ";
    out += (unit ? "" : shortened(size)) + (power > 0 ? (unit ? "t" : "*t") : "") + (power > 1 ? `^${power}` : "");
  });
  return out || "0";
}

/** A value that shows `brief` until it is opened, then what `graze explain` says. */
const closed = (brief, full) => ({brief, full});

/** A time relative to t0, shown as a decimal until it is opened. */
function laterText(time) {
  const near = decimal(difference(typeof time === "string" ? time : time.decimal, zero), 12), full = plainText(time);
  return closed(`${near.exact && typeof time === "string" ? "" : "≈ "}t0 + ${near.text}`, full.full || full);
}

const timeText = (time) => (zero ? laterText(time) : plainText(time));

/** A time as a text, or closed where its exact value is long. */
function plainText(time) {
  if (typeof time !== "string") {
    const where = time.poly ? `the one root of ${polynomial(time.poly)} between ${shortened(time.low)} and ${shortened(time.high)}`
      : "a root, of which this page has the decimal alone";
    return closed(`≈ ${time.decimal}`, `about ${time.decimal}, ${where}`);
  }
  const near = decimal(time, 12);
  if (!time.includes("/") && near.exact) return shortened(time);
  const full = shortened(time) + (near.exact ? " = " : ", about ") + near.text;
  return time.length > 13 ? closed((near.exact ? "= " : "≈ ") + near.text, full) : full;
}

function cellText(cell) {
  if (cell[0] === "p") return scene.primitives[Number(cell.slice(1))];
  return {f: "face ", e: "edge ", v: "vertex "}[cell[0]] + cell.slice(1);
}

function cellsText(cells) {
  const shown = cells.length <= 24 ? cells.length : 20;
  return sentence("meets") + cells.slice(0, shown).map(cellText).join(", ") + (cells.length > shown ? sentence("meets-more", cells.length - shown) : "");
}

/** A sentence of SAYS: % and # are filled by texts and numbers, $ by the sentence of a key. */
function sentence(key, ...fillings) {
  return SAYS[key].replace(/[%#$]/g, (kind) => {
    if (kind !== "$") return fillings.shift();
    const inner = fillings.shift(), used = (SAYS[inner].match(/[%#]/g) || []).length;
    return sentence(inner, ...fillings.splice(0, used));
  });
}

/** The lines of a sentence, without their leading blanks. */
const sentenceLines = (...of) => sentence(...of).split("\n").map((line) => line.trim()).filter(Boolean);

function reason(c) {
  if (c.left === "?" || c.right === "?") return "a state beside it is not decided";
  const at = c.left ? (c.right ? "" : "ends") : c.right ? "begins" : "always";
  return sentence("reason", c.crossing ? "intersection" : "tangency",
    "reason-" + (at || (c.crossing ? "through" : c.left === "I" ? "inside" : "outside")), c.left || c.right, c.right) + (at && !unsweep ? sentence("by-" + at) : "");
}

/** The intervals of the word and the contacts in order of time: {letter, lines}; a contact also has its {time}. */
function timeLines(p) {
  let next = 0;
  return [...p.word].map((letter, k) => {
    if (letter === "B") {
      const c = p.contacts[next++];
      const when = c.instant ? [["B  at t = ", timeText(c.from)]] : [["B  from t = ", timeText(c.from)], ["to t = ", timeText(c.to)]];
      return {letter, lines: [...when, cellsText(c.cells), reason(c)], time: timeValue(c.from)};
    }
    const first = k === 0, last = k + 1 === p.word.length;
    return {letter, lines: sentenceLines("letter", letter, "line-" + (last ? (first ? "all" : "last") : first ? "first" : "between"))};
  });
}

/** The lines on the first undecided state of a point of a curved solid. */
const openLines = (p) => [...sentenceLines("open"), ["at t = ", timeText(p.open.from)],
  ...(p.open.cells.length ? [cellsText(p.open.cells)] : []), p.open.why, ...(p.pmc === "undecided" ? [] : sentenceLines("open-pmc", p.pmc))];

function countLines(p) {
  const first = p.word[0] === "I" ? 1 : 0, last = p.word[p.word.length - 1] === "I" ? 1 : 0;
  return sentenceLines("counts", p.i, p.t, (p.i + first + last) / 2, p.i, first, last);
}

function ruleLines(p) {
  if (unsweep) return sentenceLines("unsweep", p.pmc, "unsweep-" + p.pmc);
  const other = scene.folds === "combined" && p.class.startsWith("fold") ? "-combined" : "";
  return sentenceLines("class", p.class + other, p.definition ? "class-case" : "class-ext", p.case, p.pmc, "pmc-" + p.pmc);
}

/** The first line: the point and its answer. */
function answerLine(p) {
  const exact = `(${p.at.map(shortened).join(", ")})`, decimals = near(p.at), at = decimals ? closed(decimals.brief, exact + decimals.full) : exact;
  const [before, after] = sentence(unsweep ? "answer-unsweep" : "answer-sweep", "\n", p.pmc, ...(unsweep ? [] : [p.class]), p.word).split("\n");
  return [before, at, after];
}

/** Coordinates as decimals, where the ratios have more than 12 digits. */
function near(at) {
  if (!at.some((x) => x.includes("/") && x.replace(/\D/g, "").length > 12)) return null;
  const decimals = at.map((x) => decimal(x, 12)), exact = decimals.every((x) => x.exact), text = decimals.map((x) => x.text).join(", ");
  return {brief: `(${text})`, full: exact ? ` = (${text})` : `, about (${text}),`};
}

function endLines(p) {
  const out = sentenceLines("ends");
  [[start, p.word[0], 0], [end, p.word[p.word.length - 1], 1]].forEach(([t, state, k]) => {
    const at = carry(mapAt("trace", t), p.place).slice(0, d).map((x) => Number(x.toPrecision(9)));
    out.push(...sentenceLines(unsweep ? "end-unsweep" : "end-sweep", `${unsweep ? "x" : "c"}(t${k}) ≈ (${at.join(", ")})`, state, state, k));
  });
  if (!unsweep) out.push(...sentenceLines("case", p.case, scene.meet === null ? "meet-open" : scene.meet ? "meet-yes" : "meet-no"));
  return out;
}
