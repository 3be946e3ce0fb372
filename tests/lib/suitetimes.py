"""tests/times.txt: seconds of wall time and of CPU, with all children, that each suite took, and `make test` and `.ci/run` as wholes.

Only --record of tests/run.py and tests/stages.py writes it, on two idle cores. A row has the two numbers of the whole suite; of one
with random input the two of its first quarter and the two of the rest, `-` for what was not recorded. The runner orders suites by it,
mutate.py ends them by it, documents quote it.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import os

PATH = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "times.txt")
HEAD = "# What a suite took on two idle cores: seconds of wall time and of CPU; of random input the first quarter's and the rest's.\n" \
    "# Written by --record of run.py and stages.py alone.\n"
TEST, CI = "make-test", ".ci/run"
WHOLE, QUARTER, REST = "whole", "quarter", "rest"
SHARES = {WHOLE: 1, QUARTER: 0.25, REST: 0.75}


def parts():
    """Name -> {part: (wall seconds, CPU seconds)}; empty if there is no file."""
    out = {}
    if os.path.exists(PATH):
        with open(PATH, encoding="utf-8") as file:
            for line in file:
                name, *numbers = line.split()
                if name != "#":
                    pairs = zip([WHOLE] if len(numbers) == 2 else [QUARTER, REST], zip(numbers[::2], numbers[1::2]))
                    out[name] = {part: tuple(map(float, pair)) for part, pair in pairs if "-" not in pair}
    return out


def part_of(row, part):
    """Seconds of a part of a suite, by its share of what was recorded where it was not itself; 0 if nothing was."""
    if part in row:
        return row[part]
    known = sum(SHARES[k] for k in row)
    return tuple(sum(column) * SHARES[part] / known for column in zip(*row.values())) if row else (0, 0)


def read():
    """Name -> (wall seconds, CPU seconds) of the whole."""
    return {name: part_of(row, WHOLE) for name, row in parts().items()}


def write(took, names):
    """Take over what some took, (name, part) -> (wall, CPU); of others than `names`, TEST and CI no row is left."""
    rows = {name: row for name, row in parts().items() if name in {*names, TEST, CI}}
    for (name, part), pair in took.items():
        before = rows.get(name, {})
        rows[name] = {part: pair} if part == WHOLE else {**{k: v for k, v in before.items() if k != WHOLE}, part: pair}
    with open(PATH, "w", encoding="utf-8") as file:
        file.write(HEAD)
        for name, row in sorted(rows.items()):
            pairs = [row[WHOLE]] if WHOLE in row else [row.get(QUARTER), row.get(REST)]
            file.write(" ".join([name, *(f"{pair[0]:.1f} {pair[1]:.1f}" if pair else "- -" for pair in pairs)]) + "\n")
