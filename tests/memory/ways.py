"""Ways through the program to an allocation: what its calls are named, which files they stand in, and which of them are tried.

fail.c numbers ways by addresses, which every build moves. An eighth that is the same in every build is chosen by the names of the
innermost calls instead, and by the rank among the ways of a scene that have the same names.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import array
import collections
import hashlib
import os
import re
import subprocess

from harness import ROOT

NAMED = 11           # innermost calls whose names choose
EIGHTH = 8
MORE = 4             # allocations that are tried whatever their way, of each scene; 25 of those that are tried in full
FULL, EVERY = 2, 16  # the scales from which all ways are tried, and every allocation
BASE = os.path.join(ROOT, "tests", "base.txt")


class Way:
    """The first allocation on a way: its calls from the innermost out, as (object, place)."""

    def __init__(self, number, calls):
        self.number, self.calls = number, calls


def read(path, program):
    """The way of each allocation of a run, 0 for those that are spared, and {way: calls} of each."""
    numbers = array.array("Q")
    with open(path, "rb") as file:
        numbers.frombytes(file.read())
    objects, calls = [], {}
    with open(path + ".calls", encoding="utf-8") as file:
        for line in file:
            if line.startswith("object "):
                objects.append(line[len("object "):-1] or program)
            else:
                way, *places = line.split()
                pairs = [place.split("+") for place in places]
                calls[int(way, 16)] = [(objects[int(k)], int(at, 16)) for k, at in pairs if "fail.so" not in objects[int(k)]]
    return numbers, calls


class Names:
    """The functions and the files of places, by addr2line, each object asked once."""

    def __init__(self, places):
        self.known = {}
        asked = collections.defaultdict(list)
        for program, at in sorted(set(places)):
            asked[program].append(at)
        for program, found in asked.items():
            self.ask(program, found)

    def ask(self, program, places):
        """A place is where a call returns to; the call is before it. Inlined functions have a pair of lines each."""
        if not os.path.exists(program):  # the kernel's own
            return
        out = subprocess.run(["addr2line", "-i", "-f", "-a", "-e", program], input="".join(f"{at - 1:#x}\n" for at in places),
                             stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, check=True, text=True).stdout
        found = re.split(r"^0x([0-9a-f]+)\n", out, flags=re.M)[1:]
        for at, lines in zip(found[::2], found[1::2]):
            pairs = lines.splitlines()
            self.known[program, int(at, 16) + 1] = pairs[::2], {line.rsplit(":", 1)[0] for line in pairs[1::2]}

    def functions(self, place):
        return self.known.get(place, ((), ()))[0]

    def files(self, place):
        return self.known.get(place, ((), ()))[1]


def changed():
    """The sources that differ from those of the commit that base.txt names, committed or not, and which that is; none without git or
    the file."""
    try:
        with open(BASE, encoding="utf-8") as file:
            base = file.read().split()[0]
        git = ["git", "-C", ROOT, "-c", "core.quotePath=off"]
        lists = [subprocess.run([*git, *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=True, text=True).stdout.splitlines()
                 for words in (("diff", "--name-only", base), ("ls-files", "--others", "--exclude-standard"))]
    except (OSError, IndexError, subprocess.CalledProcessError):
        return set(), "no base"
    return {path for paths in lists for path in paths if path.startswith(("src/", "include/"))}, base[:12]


def is_of(file, sources):
    return any(file == source or file.endswith("/" + source) for source in sources)


def drawn(calls, names, before):
    """The number by which a way is chosen, equal in every build; `before` counts the ways of the scene with the same names."""
    text = " ".join(name.split(".")[0] for place in calls[:NAMED] for name in names.functions(place) or [os.path.basename(place[0])])
    before[text] += 1
    return int.from_bytes(hashlib.sha256(f"{text} {before[text]}".encode()).digest()[:8], "big")


class Choice:
    """The failures to try of each scene, as (mode, N): `own` are its ways that no scene before has, first come first."""

    def __init__(self, scale, sources):
        self.scale, self.sources, self.met = scale, sources, set()

    def own(self, numbers, calls):
        found = []
        for n, way in enumerate(numbers, 1):
            if way and way not in self.met:
                self.met.add(way)
                found.append(Way(n, calls.get(way, [])))
        return found

    def passes(self, way, names):
        """Is a changed file on the way?"""
        return any(is_of(file, self.sources) for place in way.calls for file in names.files(place))

    def runs(self, numbers, own, names):
        """(runs, how many of the ways pass through a changed file)"""
        count = len(numbers)
        if self.scale >= EVERY:
            return [(mode, n) for n in range(1, count + 1) for mode in ("once", "from")], 0
        if self.scale >= FULL:
            numbers, again, touched = [way.number for way in own], range(1, count + 1, max(2, count // 25 | 1)), []
        else:
            before = collections.Counter()
            keys = [drawn(way.calls, names, before) for way in own]
            touched = [way.number for way in own if self.sources and self.passes(way, names)]
            numbers = [way.number for way, key in zip(own, keys) if key % EIGHTH == 0]
            if own and not numbers:
                numbers = [min(zip(keys, own), key=lambda pair: pair[0])[1].number]
            again = range(1, count + 1, max(2, count // MORE | 1))
        return [("once", n) for n in sorted({*numbers, *touched, *again})] + \
            [("from", n) for n in sorted({*numbers[::11], *touched[::11], *again})[::2]], len(touched)
