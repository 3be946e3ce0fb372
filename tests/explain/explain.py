#!/usr/bin/env python3
"""`graze explain` of the points of the golden cases: every sentence follows from the word and the times of the case's README.

SPDX-License-Identifier: GPL-3.0-or-later

Counts, case, definition and class come from the printed definitions (agree/lib/definitions.py), the trajectory's ends from
the motion as generate/jets.py reads it, times and cells from the README. At most POINTS points a case, more with --scale.
"""
import decimal
import json
import os
import re
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "..", folder) for folder in ("generate", "cases", "lib")]
sys.path.append(os.path.join(HERE, "..", "agree", "lib"))

import casefile  # noqa: E402
import definitions  # noqa: E402
import jets  # noqa: E402
from harness import ONLY, Checks, options, run  # noqa: E402
from words import unswept  # noqa: E402

POINTS = 4
STATE = {"I": "in the interior of", "B": "on the boundary of", "O": "outside"}
WHY = {"in": "P is in the interior of S^t for some t",
       "on": "P is on the boundary of S^t for some t, but in the interior of none", "out": "no S^t reaches P"}
UNSWEEP_WHY = {"in": "the word is I: the trajectory stays in the interior of S",
               "out": "the word holds an O: the trajectory leaves S",
               "on": "the word holds no O but a B: the trajectory stays in S and reaches its boundary"}


def shown(x):
    """A rational; of more than 40 digits the first and last twelve."""
    return re.sub(r"(\d{12})(\d{17,})(\d{12})", lambda m: f"{m[1]}...{m[3]}[{len(m[0])} digits]", str(x))


def rounded(x, digits=12):
    """(decimal, 1 if it is the number itself): positional from 10^-5 on and up to as many places as there are digits."""
    with decimal.localcontext() as context:
        context.prec = digits
        near = decimal.Decimal(int(x.numerator)) / decimal.Decimal(int(x.denominator))
    exact, figures = jets.F(near) == x, "".join(map(str, near.as_tuple().digits))
    if x == 0:
        return "0", True
    e = len(figures) + near.as_tuple().exponent
    figures = figures.rstrip("0") if exact else figures.ljust(digits, "0")
    if e > digits or e < -4:
        text = figures[0] + ("." + figures[1:] if figures[1:] else "") + f"e{e - 1}"
    elif e <= 0:
        text = "0." + "0" * -e + figures
    else:
        text = figures[:e].ljust(e, "0") + ("." + figures[e:] if figures[e:] else "")
    return ("-" if x < 0 else "") + text, exact


def place(values):
    """Coordinates, and their decimals where a ratio has more than twelve digits."""
    values = list(values)
    text = "(" + ", ".join(map(shown, values)) + ")"
    if all(x.denominator == 1 or len(f"{abs(x.numerator)}{x.denominator}") <= 12 for x in values):
        return text
    near = [rounded(jets.F(x)) for x in values]
    decimals = ", ".join(n for n, _ in near)
    return text + (f" = ({decimals})" if all(exact for _, exact in near) else f", about ({decimals}),")


def phrase(word, k):
    """When the letter number k, which is I or O, holds."""
    if len(word) == 1:
        return "all the time"
    return "from the start" if k == 0 else "until the end" if k == len(word) - 1 else "between"


def is_intersection(word, k):
    before, after = word[:k][-1:], word[k + 1:k + 2]
    return before != after if before and after else "I" in (before, after)


class Point:
    """A point of a case, and what its explanation must say."""

    def __init__(self, case, motion, id, point):
        self.case, self.motion, self.point = case, motion, [jets.F(x) for x in point]
        self.word, self.spans, self.cells = case.table[id]
        self.unsweep = case.option("--operation", "sweep") == "unsweep"
        self.combined = case.option("--folds", "separate") == "combined"
        self.fields = {} if self.unsweep else definitions.expected(self.word, self.combined)
        self.pmc = unswept(self.word) if self.unsweep else self.fields["pmc"]

    def head(self):
        which = "unsweep" if self.unsweep else f"sweep, class `{self.fields['class']}`"
        return f"P = {place(self.point)} is `{self.pmc}` for the {which}. Its word is {self.word}."

    def image(self, last):
        """c(t0) or c(t1) as text; None where jets.py cannot say, in a half turn written as a pole."""
        try:
            m = jets.matrix_at(self.motion, jets.breaks(self.motion)[-last], left=bool(last))
        except ZeroDivisionError:
            return None
        rows, d = m if self.unsweep else jets.inverse(m), len(self.point)
        return place(sum((rows[i][j] * self.point[j] for j in range(d)), rows[i][d]).terms[0] for i in range(d))

    def end(self, last):
        """A pattern of the line about t0 or t1."""
        t, image, state = jets.breaks(self.motion)[-last], self.image(last), STATE[self.word[-last]]
        also = "" if self.unsweep else rf", so P is {state} S\^{last}"
        return (rf"^  t{last} = {t}  {'x' if self.unsweep else 'c'}\(t{last}\) = "
                rf"{re.escape(image) if image else '.*'} is {state} S{also}$")

    def counts(self):
        i, t = int(self.fields["i"]), int(self.fields["t"])
        first, last = (int(self.word[k] == "I") for k in (0, -1))
        k = (i + first + last) // 2
        return (f"  i = {i}: the number of intersections\n  t = {t}: the number of tangencies\n"
                f"  k = {k}: the number of visits of P to the interior of S; a tangency from inside ends none\n"
                f"  k = (i + a + b) / 2 = ({i} + {first} + {last}) / 2, where a is 1 if ")

    def rule(self):
        """A pattern of the class's two or three lines."""
        number = self.fields["definition"]
        name = self.fields["class"].replace("_", " ") if self.fields["class"] != "boundary" else "sweep boundary"
        cited = r"\d+" if number == "ext" else number
        case = self.fields["case"]
        where = (rf"\.\n  \[EI\] leaves out case {case}, .*\n  .*`ext`\.\n" if number == "ext" else rf" in case {case}\n")
        return rf"The class\n  k .*: P is an? {name} point \(Definition {cited}\){where}  P is `{self.pmc}` by \[EI\] eq\. 7: "


def check_line(checks, at, text):
    """The time line: its letters, their phrases, the rational times, and the kind of each contact."""
    part = text[text.index("\nThe time line"):]
    lines = re.findall(r"^  ([IBO])  (.*)$", part, re.M)
    if not checks.equal("".join(letter for letter, _ in lines), at.word, *where_of(at), "letters of the time line"):
        return
    kinds = re.findall(r"^       (tangency|intersection): ", part, re.M)
    checks.equal(kinds, ["intersection" if is_intersection(at.word, k) else "tangency"
                         for k, letter in enumerate(at.word) if letter == "B"], *where_of(at), "kinds")
    ends = re.findall(r"^     to t = (.*)$", part, re.M)
    spans = iter(at.spans)
    for k, (letter, said) in enumerate(lines):
        if letter != "B":
            checks.equal(said, phrase(at.word, k), *where_of(at), f"letter {k}")
            continue
        low, high = next(spans)
        slides = low != high
        checks.equal(said.split(" t = ")[0], "from" if slides else "at", *where_of(at), f"letter {k}")
        for time, given in ((low, said.split(" t = ")[1]), (high, ends.pop(0) if slides else None)):
            if given and time[0] is None:   # rational
                checks.equal(re.split(" = |, ", given)[0], shown(time[1]), *where_of(at), f"time of letter {k}")
    checks.equal(ends, [], *where_of(at), "ends of slides")


def where_of(at):
    return at.case.name, place(at.point)


def check_point(checks, at, text):
    where = where_of(at)
    checks.equal(text.split("\n")[0], at.head(), *where)
    for last in (0, 1):
        checks.holds(re.search(at.end(last), text, re.M), *where, f"expected {at.end(last)!r}", text)
    check_line(checks, at, text)
    if at.unsweep:
        checks.holds(f"\n  pmc `{at.pmc}`: {UNSWEEP_WHY[at.pmc]}\n" in text, *where, "the rule of the unsweep", text)
        return
    checks.holds(f"This is case {at.fields['case']} of Table 1" in text, *where, "the case", text)
    checks.holds(at.counts() in text, *where, f"expected {at.counts()!r}", text)
    checks.holds(re.search(at.rule() + re.escape(WHY[at.pmc]) + "\n", text), *where, f"expected {at.rule()!r}", text)


# Unit square, moved by (t - t0)^2 along x from t0 to t0 + 2: met where that is x - 1, left where it is x.
CLOCK = 1700000000
CLOCK_POINTS = (("2", ("t0 + 1", "about t0 + 1.41421356237, the one root of t^2 - 3400000000*t + 2889999999999999998 between")),
                ("10/9", ("t0 + 1/3, about t0 + 0.333333333333", "about t0 + 1.05409255339, the one root of")))


def check_clock(checks, graze, folder):
    """Seconds since 1970 are told from t0, which is named; JSON Lines keep them."""
    files = []
    for name, text in (("square.wkt", "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))"),
                       ("log.json", '{"dimension": 2, "pieces": [{"t": ["%d", "%d"], "transform": {"translate": ["(t - %d)^2", "0"]}}]}'
                        % (CLOCK, CLOCK + 2, CLOCK))):
        files.append(os.path.join(folder, name))
        with open(files[-1], "w", encoding="utf-8") as file:
            file.write(text)
    for x, expected in CLOCK_POINTS:
        said = run([graze, "explain", *files, x, "1/2", "--sdf", "1e-6"]).stdout
        checks.holds(f". Times are told from the motion's start, t0 = {CLOCK}.\n" in said, "t0 is named", said)
        checks.holds(f"\n  t0 = {CLOCK}  c(t0)" in said and "\n  t1 = t0 + 2  c(t1)" in said, "the ends", said)
        checks.holds("\n  for t from t0 to t0 + 2\n" in said, "the pieces", said)
        times = re.findall(r"^  B  at t = (.*)$", said, re.M)
        checks.holds(len(times) == len(expected) and all(map(str.startswith, times, expected)), x, times)
        checks.holds(" t = t0 + " in said.split("signed distance")[-1], "the distance's time", said[-300:])
        rows = run([graze, "classify", *files, "-", "--format", "jsonl"], input=f"{x},1/2\n").stdout
        checks.holds(f'"{CLOCK}' in rows or f'"{CLOCK * 3 + 1}/3' in rows or f'"{CLOCK + 1}' in rows, "JSON Lines", rows)


def check_long_path(checks, graze, folder):
    """The unit square in 30 pieces of one unit along x: (x, 1/2) is met at x - 1 and x. Told are the first and the last piece and those
    of contacts, both at a time that two share."""
    files = [os.path.join(folder, name) for name in ("square.wkt", "long.json")]
    with open(files[0], "w", encoding="utf-8") as file:
        file.write("POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))")
    with open(files[1], "w", encoding="utf-8") as file:
        json.dump({"dimension": 2, "pieces": [{"t": [str(k), str(k + 1)], "transform": {"translate": ["t", "0"]}} for k in range(30)]}, file)
    for x, y, told in (("21/2", "1/2", (0, 9, 10, 29)), ("10", "1/2", (0, 8, 9, 10, 29)), ("21/2", "1", (0, 9, 10, 29)),
                       ("7/2", "1/2", (0, 2, 3, 29)), ("1/2", "3", (0, 29)), ("30", "1/2", (0, 28, 29))):
        said = run([graze, "explain", *files, x, y]).stdout
        got = re.findall(r"^  for t from (\d+) to |^  \[(\d+) pieces? without a contact left out\]$", said, re.M)
        want = [("0", "")]
        for before, piece in zip(told, told[1:]):
            want += [("", str(piece - before - 1))] * (piece > before + 1) + [(str(piece), "")]
        checks.equal(got, want, x, y, "pieces", said)
        checks.equal("[1 piece without" in said, ("", "1") in want, x, y, said)


def check_one_source(checks):
    """Sentences stand in one file: no part of them in a source of C or a script."""
    output = os.path.join(HERE, "..", "..", "src", "output")
    with open(os.path.join(output, "report", "sentences.json"), encoding="utf-8") as file:
        sentences = json.load(file)
    sources = {}
    for folder in ("report", "page"):
        for name in os.listdir(os.path.join(output, folder)):
            if name.endswith((".c", ".js")):
                with open(os.path.join(output, folder, name), encoding="utf-8") as file:
                    sources[name] = re.sub(r'"\s*\n\s*"', "", file.read())
    checks.holds(len(sources) > 20 and len(sentences) > 40, "sources", len(sources), len(sentences))
    for key, sentence in sentences.items():
        for part in re.split(r"[%#$\n]+", sentence):
            if len(part.strip()) > 14:
                checks.equal([name for name, text in sources.items() if part.strip() in text], [], key, part)


def main():
    args, checks, words = options(__doc__, ONLY), Checks(), set()
    if args.derived:
        with tempfile.TemporaryDirectory() as folder:
            check_clock(checks, args.graze, folder)
            check_long_path(checks, args.graze, folder)
        check_one_source(checks)
    for name in args.once(name for name in casefile.names() if args.only in name):
        case = casefile.Case(name)
        motion = jets.load(case.path("motion.json"))
        every = max(1, len(case.points) // (POINTS * max(1, int(args.scale))))
        for id, point in case.points[::every]:
            done = run([args.graze, "explain", case.path(case.solid), case.path("motion.json"), *case.options, "--", *point])
            if checks.equal(done.returncode, 0, name, id, done.stderr):
                at = Point(case, motion, id, point)
                words.add((at.unsweep, at.word))
                check_point(checks, at, done.stdout)
    if args.ample and not args.only:
        checks.holds(len(words) >= 40, f"{len(words)} different words")
    checks.finish()


if __name__ == "__main__":
    main()
