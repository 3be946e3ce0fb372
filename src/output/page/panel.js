// The panel of a point: its word and its explanation, in which a click opens a value.
// SPDX-License-Identifier: GPL-3.0-or-later

const $ = (id) => document.getElementById(id);

/** An element of a class with a text, put into another. */
function put(parent, kind, className, text) {
  const out = document.createElement(kind);
  if (className) out.className = className;
  if (text !== undefined) out.textContent = text;
  parent.append(out);
  return out;
}

/** A line of texts and values; a closed value is a button that shows it in full. */
function putLine(parent, line, className) {
  const out = put(parent, "div", `line ${className || ""}`);
  for (const part of [line].flat()) {
    if (typeof part === "string") {
      out.append(part);
      continue;
    }
    const button = put(out, "button", "value", part.brief);
    button.title = "show the exact value";
    button.addEventListener("click", () => {
      const open = button.classList.toggle("open");
      button.textContent = open ? part.full : part.brief;
      button.title = open ? "show the decimal" : "show the exact value";
    });
  }
  return out;
}

function putSection([heading, ...rest]) {
  put($("says"), "h4", "line", heading);
  for (const line of rest) putLine($("says"), line);
}

/** The word as letters; those of contacts lead to their times. */
function putWord(p, go) {
  const row = put($("says"), "div", "word");
  row.title = "the word: what the trajectory meets, in order of time";
  for (const {letter, time} of timeLines(p).slice(0, 200)) {
    const out = put(row, time === undefined ? "span" : "button", "letter " + letter, letter);
    out.title = (letter === "?" ? "not decided" : SAYS[letter] + " S") + (time === undefined ? "" : ", go there");
    if (time !== undefined) out.addEventListener("click", () => go(time));
  }
}

/** Show all about a point. `go` sets the time. */
function say(p, go) {
  $("says").replaceChildren();
  const head = put($("says"), "h3", "", p.name || `point ${p.index + 1}`), badge = put(head, "span", "badge", p.class);
  badge.style.setProperty("--tone", scene.tones[p.tone][1]);
  if (p.stratum) put(head, "span", "stratum", p.stratum);
  putWord(p, go);
  putLine($("says"), answerLine(p));
  if (p.answer) putLine($("says"), `The candidate says ${p.answer}.`, "wrong");
  put($("says"), "h4", "line", sentenceLines("line")[0]);
  for (const {letter, lines, time} of timeLines(p)) {
    const first = putLine($("says"), lines[0], "time " + letter);
    if (time !== undefined) {
      const button = put(first, "button", "go", "▸");
      button.title = "move S to this time";
      button.addEventListener("click", () => go(time));
    }
    for (const line of lines.slice(1)) putLine($("says"), line, "more");
  }
  if (p.open) {
    putSection(openLines(p));
    return;
  }
  putSection(endLines(p));
  if (!unsweep) putSection(countLines(p));
  putSection(ruleLines(p));
}
