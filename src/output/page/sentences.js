// What `graze explain` says of a point: lines of texts and of values, which show a decimal until they are opened.
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

/** A time told from t0, as a decimal until it is opened. */
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
  const rest = cells.length > shown ? ` [and ${cells.length - shown} more cells]` : "";
  return "it meets " + cells.slice(0, shown).map(cellText).join(", ") + rest;
}

function reason(c) {
  if (c.left === "?" || c.right === "?") return "a state beside it is not decided";
  let out = `${c.crossing ? "intersection" : "tangency"}: `;
  if (!c.left && !c.right) out += "the trajectory never leaves the boundary";
  else if (!c.left) out += `the motion begins here, and ${c.right} follows`;
  else if (!c.right) out += `the motion ends here, and ${c.left} came before`;
  else if (c.crossing) out += `${c.left} before and ${c.right} after, so the trajectory passes through the boundary`;
  else out += `${c.left} before and after, so the trajectory touches the boundary from ${c.left === "I" ? "inside" : "outside"}`;
  if (!unsweep && !(c.left && c.right))
    out += ` ([EI] ${c.left ? "Definition 3" : c.right ? "Definition 4" : "Definitions 3 and 4"})`;
  return out;
}

/** The stays and contacts in order of time: {letter, lines}, of a contact with its {time}. */
function timeLines(p) {
  let next = 0;
  return [...p.word].map((letter, k) => {
    if (letter === "B") {
      const c = p.contacts[next++];
      const when = c.instant ? [["B  at t = ", timeText(c.from)]] : [["B  from t = ", timeText(c.from)], ["to t = ", timeText(c.to)]];
      return {letter, lines: [...when, cellsText(c.cells), reason(c)], time: timeValue(c.from)};
    }
    const last = k + 1 === p.word.length;
    const when = last && k === 0 ? "all the time" : last ? "until the end" : k === 0 ? "from the start" : "between";
    return {letter, lines: [`${letter}  ${when}`]};
  });
}

/** Where the rules end, of a point of a curved solid that is undecided. */
const openLines = (p) => ["The state is not decided", ["at t = ", timeText(p.open.from)],
  ...(p.open.cells.length ? [cellsText(p.open.cells)] : []), p.open.why];

function countLines(p) {
  const plural = (name, n, one, many) => `${name} = ${n} ${n === 1 ? one : many}`;
  const first = p.word[0] === "I" ? 1 : 0, last = p.word[p.word.length - 1] === "I" ? 1 : 0;
  return ["The counts",
    plural("i", p.i, "intersection", "intersections") + ", " + plural("t", p.t, "tangency", "tangencies"),
    `k = (i + [P in iS^0] + [P in iS^1]) / 2 = (${p.i} + ${first} + ${last}) / 2 = ${(p.i + first + last) / 2}:`,
    "so often the solid's interior comes to P and goes, touching in between not counted"];
}

function rule(p) {
  const combined = scene.folds === "combined";
  return {regular: "k = 1 and t = 0 make a regular point (Definition 5)",
    fold: combined ? "k >= 2 makes a fold point, whatever t is (Definition 10)" : "k >= 2 and t = 0 make a fold point (Definition 6)",
    fold_boundary: combined ? "k = 1 and t >= 1 make a fold boundary point (Definition 11)"
      : "k >= 1 and t >= 1 make a fold boundary point (Definition 7)",
    boundary: "k = 0 and t >= 1 make a sweep boundary point (Definition 8)",
    exterior: "k = 0 and t = 0 make an exterior point (Definition 9)"}[p.class];
}

function ruleLines(p) {
  if (unsweep)
    return ["The rule of the unsweep ([IS] eqs 12, 13, 35)", `pmc \`${p.pmc}\`: ` +
      {in: "the word is I: the trajectory stays in the interior of S", out: "the word holds an O: the trajectory leaves S",
        on: "the word holds no O but a B: the trajectory stays in S and reaches its boundary"}[p.pmc]];
  const out = ["The class", rule(p) + (p.definition ? ` in case ${p.case}` : ".")];
  if (!p.definition)
    out.push(`The definition leaves case ${p.case} out, since it needs S^0 and S^1 to meet; the same rule is`,
      "extended to it and cited as `ext`");
  out.push(`pmc \`${p.pmc}\` by [EI] eq. 7: ` + {in: "P is in the interior of S^t for some t",
    on: "P is on the boundary of S^t for some t, but in the interior of none", out: "no S^t reaches P"}[p.pmc]);
  return out;
}

/** The first line: the point and its answer. */
function answerLine(p) {
  const what = unsweep ? `is \`${p.pmc}\` for the unsweep` : `is \`${p.pmc}\` for the sweep, class \`${p.class}\``;
  const exact = `(${p.at.map(shortened).join(", ")})`, decimals = near(p.at);
  return ["P = ", decimals ? closed(decimals.brief, exact + decimals.full) : exact, ` ${what}. Its word is ${p.word}.`];
}

/** Coordinates as decimals, where the ratios have more than 12 digits. */
function near(at) {
  if (!at.some((x) => x.includes("/") && x.replace(/\D/g, "").length > 12)) return null;
  const decimals = at.map((x) => decimal(x, 12)), exact = decimals.every((x) => x.exact), text = decimals.map((x) => x.text).join(", ");
  return {brief: `(${text})`, full: exact ? ` = (${text})` : `, about (${text}),`};
}

function endLines(p) {
  const phrase = {I: "in the interior of", B: "on the boundary of", O: "outside"};
  const out = ["At the two ends of the motion"];
  [[start, p.word[0], 0], [end, p.word[p.word.length - 1], 1]].forEach(([t, state, k]) => {
    const at = carry(mapAt("trace", t), p.place).slice(0, d).map((x) => Number(x.toPrecision(9)));
    const then = unsweep ? "" : `, so P is ${phrase[state]} S^${k}`;
    out.push(`${unsweep ? "x" : "c"}(t${k}), near (${at.join(", ")}), is ${phrase[state]} S${then}`);
  });
  if (!unsweep) out.push(`This is case ${p.case} of Table 1 in [EI].`, ...meetLines());
  return out;
}

/** What the places of S at the two ends have to do with [EI]. */
function meetLines() {
  if (scene.meet === null)
    return ["Whether S at the start (S^0) and S at the end (S^1) have points in common is not decided.", "The answer is no less certain."];
  return scene.meet ? ["S at the start (S^0) and S at the end (S^1) have points in common. The answer is no less certain:",
    "[EI] speaks of motions without such points, and Graze cites `ext` where it goes beyond them."]
    : ["S at the start (S^0) and S at the end (S^1) have no point in common, as [EI] assumes."];
}
