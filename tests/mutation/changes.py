"""The changes a mutation test makes to a source file, one at a time, and those known to be equivalent.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import re

RECORD = "tests/mutants.txt"
# A token and what it becomes. Two variants for an order: its negation, and its boundary moved.
SWAPS = {
    "<": [">=", "<="], "<=": [">", "<"], ">": ["<=", ">="], ">=": ["<", ">"], "==": ["!="],
    "!=": ["=="], "&&": ["||"], "||": ["&&"], "+": ["-"], "-": ["+"],
    "fmpz_sgn(": ["-fmpz_sgn("], "fmpq_sgn(": ["-fmpq_sgn("], "-1": ["1"],
}
# Operators stand between blanks; the brackets of a template do not.
TOKEN = re.compile(r"/\*.*?\*/|//[^\n]*|\"(?:\\.|[^\"\\])*\"|'(?:\\.|[^'\\])*'|^#[^\n]*|"
                   r"fmpz_sgn\(|fmpq_sgn\(|fmp[zq]_(?:poly_)?neg\(|"
                   r"(?<= )(?:<=|>=|==|!=|&&|\|\||<|>|\+|-)(?=\s)|(?<=[ (])-1(?![0-9a-zA-Z.])", re.S | re.M)
FUNCTION = re.compile(r"^( *)(?!(?:if|for|while|switch|else|do|return)\b)\w[^;{}()#]*?(\w+)\([^;{}]*\)[^;{}()]*\{$", re.M)
# Calls that free memory decide nothing, nor does one turn more of a loop: leaks and overruns are the sanitizers' matter.
GIVES_BACK = re.compile(r"\w*(?:clear|free)\(")


class Mutant:
    """One change: the file, the function, the changed line, and the whole changed source. `is_moved`: an order's boundary."""

    def __init__(self, path, text, function, match, new):
        self.is_moved = new in (match.group() + "=", match.group()[:-1])
        start, end = text.rfind("\n", 0, match.start()) + 1, text.find("\n", match.end())
        self.path, self.function, self.line = path, function, text.count("\n", 0, start) + 1
        self.changed = (text[start:match.start()] + new + text[match.end():end]).strip()
        self._parts = text, match.span(), new

    def source(self):
        text, (start, end), new = self._parts
        return text[:start] + new + text[end:]

    def is_in(self, record):
        return not record.keys().isdisjoint({(self.path, self.function, self.changed), (self.path, self.function, "*")})


def function_at(text):
    """A function: place in the text -> name of the function there, `-` outside all."""
    bodies = [(m.start(), text.find(f"\n{m[1]}}}", m.end()), m[2]) for m in FUNCTION.finditer(text)]
    return lambda place: next((name for start, end, name in reversed(bodies) if start <= place <= end), "-")


def mutants(path):
    """Every change of a file."""
    with open(path, encoding="utf-8") as file:
        text = file.read()
    name = function_at(text)
    for match in TOKEN.finditer(text):
        old = match.group()
        news = [old.replace("neg(", "set(")] if old.endswith("neg(") else SWAPS.get(old, [])
        start = text.rfind("\n", 0, match.start()) + 1
        line, following = text[start:].split("\n", 2)[:2]
        loops = line.lstrip().startswith("for (")
        if not GIVES_BACK.search(line + following if loops else line):
            for new in news[:1] if loops else news:
                yield Mutant(path, text, name(match.start()), match, new)


def record():
    """{(file, function, changed line): reason} of tests/mutants.txt: a line FILE FUNCTION, changed lines after `| `
    (`*` stands for all of the function), and the reason."""
    known = {}
    with open(RECORD, encoding="utf-8") as file:
        for block in file.read().split("\n\n"):
            lines = [line for line in block.splitlines() if not line.startswith("#")]
            if lines:
                changed = [line[2:] for line in lines if line.startswith("| ")]
                reason = " ".join(line for line in lines[1:] if not line.startswith("| "))
                if len(lines[0].split()) != 2 or not changed or not reason:
                    raise SystemExit(f"{RECORD}: expected FILE FUNCTION, lines after `| ` and a reason: {block}")
                known.update({(*lines[0].split(), line): reason for line in changed})
    return known


def strangers(known):
    """The keys that are no mutant's."""
    made = [m for path in {key[0] for key in known} for m in mutants(path)]
    keys = {key for m in made for key in ((m.path, m.function, m.changed), (m.path, m.function, "*"))}
    return sorted(set(known) - keys)
