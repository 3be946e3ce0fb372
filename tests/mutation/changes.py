"""The changes a mutation test makes to a source file, one at a time, and those known to be equivalent.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import collections
import re

# A token and what it becomes. Two variants for an order: its negation, and its boundary moved.
SWAPS = {
    "<": [">=", "<="], "<=": [">", "<"], ">": ["<=", ">="], ">=": ["<", ">"], "==": ["!="],
    "!=": ["=="], "&&": ["||"], "||": ["&&"], " + ": [" - "], " - ": [" + "],
    "fmpz_sgn(": ["-fmpz_sgn("], "fmpq_sgn(": ["-fmpq_sgn("], "-1": ["1"], "_neg(": ["_set("],
}
TOKEN = re.compile(r'/\*.*?\*/|"(?:\\.|[^"\\])*"|\'(?:\\.|[^\'\\])*\'|#[^\n]*|->|<<|>>|\+\+|--|'
                   r'fmpz_sgn\(|fmpq_sgn\(|fmp[zq]_(?:poly_)?neg\(|'
                   r'<=|>=|==|!=|&&|\|\||<|>| \+ | - |(?<=[ (])-1(?![0-9a-zA-Z.])', re.S)


class Mutant:
    """One change: where it stands, what it is, and the whole changed source. `seen` counts equal
    changes of equal lines of the file, which are numbered from the second on."""

    def __init__(self, path, text, match, old, new, seen):
        start = text.rfind("\n", 0, match.start()) + 1
        self.path = path
        self.line = text.count("\n", 0, start) + 1
        self.text = text[start:text.find("\n", start)].strip()
        self.what = f"{old.strip()} -> {new.strip()} at {match.start() - start}"
        seen[self.key()] += 1
        if seen[self.key()] > 1:
            self.what += f", {seen[self.key()]}"
        self.source = text[:match.start()] + new + text[match.end():]

    def key(self):
        return self.path, self.text, self.what


def mutants(path):
    """Every change of a file."""
    seen = collections.Counter()
    with open(path, encoding="utf-8") as file:
        text = file.read()
    for match in TOKEN.finditer(text):
        old = match.group()
        if old.endswith("neg("):
            yield Mutant(path, text, match, old, old.replace("neg(", "set("), seen)
        for new in SWAPS.get(old, []):
            yield Mutant(path, text, match, old, new, seen)


def known_equivalents(path):
    """The keys of the mutants of tests/mutants.txt: three lines each, then the reason."""
    known = set()
    with open(path, encoding="utf-8") as file:
        for block in file.read().split("\n\n"):
            lines = [line for line in block.splitlines() if not line.startswith("#")]
            if len(lines) >= 4:
                known.add((lines[0], lines[1].strip(), lines[2]))
    return known
