"""The rows of tests/README.md: which suites there are, what each is about, when it runs, and how many checks it must count.

`| suite | what it proves | method | rooms | tier | checks |`. Rooms are folders of src, `all` for a suite that guards every one, `-` for
one that is about no source. Tiers and their checks are those of TIERS; a suite of tier `random` has two least counts, of the first
quarter of its stream and of the rest. seeds.txt has what a seed found, `SUITE SEED SCALE  reason`, until a derived case is there.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import collections
import fractions
import glob
import os
import re

TESTS = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
README, SEEDS = os.path.join(TESTS, "README.md"), os.path.join(TESTS, "seeds.txt")
QUARTER = "1/4"
COUNT = (r"[1-9]\d*", "a number of checks above 0")
TIERS = {"derived": COUNT, "random": (r"[1-9]\d* \+ [1-9]\d*", "two numbers of checks above 0, as 20 + 50"), "ci": COUNT, "long": COUNT,
         "by hand": ("-", "-")}
LINE = re.compile(r"^\| `([\w-]+/[\w/-]+\.(?:py|c))` \|(.*)\|$", re.M)

Row = collections.namedtuple("Row", "path rooms tier least")  # least: as many numbers as the tier has
Seed = collections.namedtuple("Seed", "path seed scale")


def found():
    """The paths under tests/ of all suites and scripts."""
    paths = [path for kind in ("unit", "api") for path in glob.glob(f"{TESTS}/{kind}/*.c")]
    for path in glob.glob(f"{TESTS}/*/*.py"):
        with open(path, encoding="utf-8") as file:
            if re.search(r'^if __name__ == "__main__":', file.read(), re.M):
                paths.append(path)
    return sorted(os.path.relpath(path, TESTS) for path in paths)


def is_room(name):
    return name in ("all", "-") or (re.fullmatch(r"[\w/]+", name) and os.path.isdir(os.path.join(TESTS, "..", "src", name)))


def parsed(path, rest):
    """A row, and its faults."""
    cells = [cell.strip() for cell in rest.split(" | ")]
    if len(cells) != 5:
        return None, [f"{path}: {len(cells) + 1} columns; expected 6: suite, what it proves, method, rooms, tier, checks"]
    rooms, tier, least = tuple(cells[2].split(", ")), cells[3], cells[4]
    faults = [f"{path}: the room {room}; expected folders of src, `all` or `-`" for room in rooms if not is_room(room)]
    faults += [f"{path}: the rooms {cells[2]}; expected `all` or `-` alone"] if len(rooms) > 1 and {"all", "-"} & set(rooms) else []
    if tier not in TIERS:
        return None, [*faults, f"{path}: the tier {tier}; expected one of {', '.join(TIERS)}"]
    form, expected = TIERS[tier]
    if not re.fullmatch(form, least):
        faults.append(f"{path}: the checks {least}; expected {expected} for the tier {tier}")
        return None, faults
    return Row(path, rooms, tier, tuple(map(int, re.findall(r"\d+", least)))), faults


def read():
    """Path -> Row, and the faults of the record; a suite whose row is refused has none."""
    with open(README, encoding="utf-8") as file:
        lines = LINE.findall(file.read())
    rows, faults, named, there = {}, [], collections.Counter(path for path, _ in lines), found()
    for path, rest in dict(lines).items():
        row, wrong = parsed(path, rest)
        faults += wrong
        if row:
            rows[path] = row
    faults += [f"{path} has two rows" for path, many in named.items() if many > 1]
    faults += [f"tests/{path} has no row" for path in there if path not in named]
    faults += [f"there is no suite or script tests/{path}" for path in named if path not in there]
    return rows, [f"tests/README.md: {fault}" for fault in faults]


def share(text):
    """A positive number such as 1/4, 1 or 4."""
    value = fractions.Fraction(text)
    if value <= 0:
        raise ValueError(text)
    return value


def seeds(rows):
    """The runs to replay, and the faults of seeds.txt."""
    out, faults = [], []
    if os.path.exists(SEEDS):
        with open(SEEDS, encoding="utf-8") as file:
            lines = [line.split(None, 3) for line in file if line.strip() and not line.startswith("#")]
        for words in lines:
            try:
                path, seed, scale, _ = words
                share(scale)
                if path not in rows or rows[path].tier not in ("random", "ci", "long"):
                    raise ValueError(path)
                out.append(Seed(path, str(int(seed)), scale))
            except (ValueError, ZeroDivisionError):
                faults.append(f"tests/seeds.txt: {' '.join(words).strip()}; expected a suite with random input, a seed, a scale, a reason")
    return out, faults


def fill(counted):
    """Put least counts into the rows: (path, which of a row's numbers) -> number."""
    with open(README, encoding="utf-8") as file:
        text = file.read()
    for (path, k), least in counted.items():
        row = re.search(rf"^\| `{re.escape(path)}` \|.*\|$", text, re.M)[0]
        head, numbers = re.fullmatch(r"(.*\| )([\d+ ]+) \|", row).groups()
        numbers = numbers.split(" + ")
        numbers[k] = str(least)
        text = text.replace(row, f"{head}{' + '.join(numbers)} |")
    with open(README, "w", encoding="utf-8") as file:
        file.write(text)
