"""Two ways to the same answers: run both on the same files and compare what they print, byte by byte.

SPDX-License-Identifier: GPL-3.0-or-later

A way is a program with flags. Both must succeed and print whole tables; a difference is printed
with the scene, the point and both rows, and the files are kept where --keep names a folder.
"""
import json
from collections import Counter

from program import run
from queries import NEAR, Maker, generated, written

JSON_EVERY = 5
SECONDS = 300   # of one run


class Way:
    """A program and flags of its own. `flags` go to classify and explain, `jobs` to classify."""

    def __init__(self, name, path, flags=(), jobs=1):
        self.name, self.path, self.flags, self.jobs = name, path, list(flags), jobs


def ways(path):
    """The filter with two threads, and the exact path alone with one."""
    return Way("filtered", path, jobs=2), Way("exact", path, ["--no-filter"])


class Sides:
    def __init__(self, graze, checks, left, right):
        """`graze` is the harness's; it makes files and bounds processes."""
        self.graze, self.checks, self.pair = graze, checks, (left, right)
        self.rows, self.kinds = 0, Counter()
        self.judged, self.special, self.hard = 0, 0, 0

    def run(self, path, *args):
        """(status, output, message) in bytes."""
        done = run([path, *args], SECONDS, text=False)
        return done.returncode, done.stdout, done.stderr

    def both(self, command, *args):
        jobs = command == "classify"
        return [self.run(way.path, command, *way.flags,
                         *(["--jobs", str(way.jobs)] if jobs else []), *args)
                for way in self.pair]

    def same(self, name, command, *args):
        """The common output of both, or None after a failed check."""
        left, right = self.both(command, *args)
        if not self.checks.equal((left[0], right[0]), (0, 0), name, " ".join(args),
                                 left[2][:300], right[2][:300]):
            return None
        if left[1] == right[1]:
            self.checks.passed += 1
            return left[1].decode()
        self.report(name, args, left[1], right[1])
        return None

    def report(self, name, args, left, right):
        """Every row that differs, a few at most."""
        pairs = list(zip(left.splitlines(), right.splitlines()))
        unequal = [(a, b) for a, b in pairs if a != b]
        self.checks.fail(f"{len(unequal)} of {len(pairs)} rows differ, "
                         f"{len(left)} and {len(right)} bytes", name, " ".join(args))
        for a, b in unequal[:5]:
            for way, row in zip(self.pair, (a, b)):
                print(f"  {way.name}: {row.decode()[:2000]}")

    def table(self, name, solid, motion, points, flags, count):
        """CSV of a file of points, or of a grid: whole, and the same."""
        points = [points] if isinstance(points, str) else points
        text = self.same(name, "classify", solid, motion, *points, *flags)
        if text is None:
            return
        whole = text.endswith(f"\n# complete {count}\n")
        rows = [line.split(",") for line in text.splitlines() if not line.startswith("#")]
        self.checks.equal((whole, len(rows) - 1), (True, count), name, "a whole table")
        self.rows += count

    def records(self, name, solid, motion, points, kinds, flags):
        """JSON Lines of a file of points; counts how many of the made ones are degenerate in their
        result."""
        text = self.same(name, "classify", solid, motion, points, "--format", "jsonl", *flags)
        if text is None:
            return
        lines = text.splitlines()
        self.checks.equal(len(lines), len(kinds), name, "records")
        for kind, line in zip(kinds, lines):
            if kind == "case":
                continue
            special = is_special(json.loads(line))
            self.judged += 1
            self.special += special
            self.hard += special or kind in NEAR

    def scene(self, scene, rng, count, seed):
        """A scene with points of its own, generated ones, and a grid."""
        tag = scene.name.replace(", ", "_").replace(" ", "-")
        solid, motion = scene.texts()
        solid = self.graze.write(tag + scene.solid.suffix, solid)
        motion = self.graze.write(tag + ".json", motion)
        made = self.generated(scene.name, solid, motion, scene.flags, scene.d, count * 2 // 5, seed)
        maker = Maker(scene, rng)
        points = maker.points(count - len(made)) + made
        rng.shuffle(points)
        self.points(tag, scene, solid, motion, points)
        if scene.ordinary and not scene.heavy:
            grid, size = maker.grid()
            self.table(scene.name, solid, motion, grid, scene.flags, size)
            self.kinds["grid"] += size

    def points(self, tag, scene, solid, motion, points):
        """A table of all, JSON Lines of some, two explanations."""
        every = self.graze.write(tag + ".csv", written(scene.d, points))
        self.table(scene.name, solid, motion, every, scene.flags, len(points))
        self.kinds.update(kind for kind, _ in points)
        some = points[::JSON_EVERY]
        sample = self.graze.write(tag + "_sample.csv", written(scene.d, some))
        self.records(scene.name, solid, motion, sample, [k for k, _ in some], scene.flags)
        for _, p in some[:2]:
            self.same(scene.name, "explain", solid, motion, *scene.flags, "--",
                      *(str(x) for x in p))

    def generated(self, name, solid, motion, flags, d, count, seed):
        operation = flags[:2] if "--operation" in flags else []
        status, text, message = self.run(self.pair[0].path, "generate", solid, motion, *operation,
                                         "-n", str(count), "--seed", str(seed))
        if not self.checks.equal(status, 0, name, "generate", message[:300]):
            return []
        return generated(text.decode(), d)

    def summary(self):
        kinds = ", ".join(f"{k} {n}" for k, n in sorted(self.kinds.items()))
        share = 100.0 / max(1, self.judged)
        print(f"{self.rows} points both ways as rows, every fifth and all of cases/ as JSON Lines")
        print(f"kinds: {kinds}")
        print(f"of {self.judged} made points there {self.special * share:.1f} % have a tangency or a contact at an "
              f"end, an edge or a vertex; {self.hard * share:.1f} % these or a near miss by "
              "construction")


def is_special(record):
    """A tangency, or a contact at an end of the motion, on an edge in space or on a vertex."""
    small = {"vertex"} | ({"edge"} if len(record["point"]) == 3 else set())
    return any(c["kind"] == "tangency" or c["left"] is None or c["right"] is None
               or any(set(f) & small for f in c["features"]) for c in record["contacts"])
