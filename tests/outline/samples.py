# suite
"""`graze outline --samples --certify`: `graze-check` proves both sides of each piece of the outlines that are derived by hand.

SPDX-License-Identifier: GPL-3.0-or-later

Each row's `pmc` is its `side`, and the certificate is verified. The rows of an arc are pairs, `in` and `out`, that differ in one coordinate, and
the first pair is the JSON's sample of the arc; a lower arc has three, the middle one `on`. Table and certificate are the bytes that `graze
classify` writes for the same points. A standing polygon is its own sweep: each pair crosses one of its edges, and each edge is crossed. A row, a
claim or a scene that is forged is refuted.
"""
import json
import os
from collections import Counter

from byhand import SCENES
from exact import Fraction as F
from harness import run, without_leaks
from outlines import Checks, Program, options

from solids import Polygon, box_ring, ring  # noqa: E402

RESTING = {"star at rest": 8, "corner pair at rest": 8, "frames in frames": 24}  # edges, derived in byhand.py
TURN = json.dumps({"dimension": 2, "pieces": [{"t": [0, 1], "transform": {"rotate": {"tan_half": "t"}}}]})
ALONG = json.dumps({"dimension": 2, "pieces": [{"t": [0, 1], "transform": {"translate": ["t", "t^2"]}}]})
BOX = json.dumps({"dimension": 2, "solid": {"box": {"low": [0, 0], "high": [1, 2]}}})


def rows_of(text):
    lines = [line for line in text.splitlines() if not line.startswith("#")]
    names = lines[0].split(",")
    return [dict(zip(names, line.split(","))) for line in lines[1:]]


def read(path):
    with open(path, encoding="ascii") as file:
        return file.read()


class Sampler:
    """Runs of `graze outline` with both files, and of the checker."""

    def __init__(self, program, checks):
        self.program, self.checks = program, checks
        self.table, self.certificate = (os.path.join(program.folder.name, name) for name in ("samples.csv", "proof.txt"))
        self.checker = os.path.join(os.path.dirname(os.path.abspath(program.path)), "graze-check")

    def files(self, scene):
        return self.program.write("s.wkt", scene.solid.text()), self.program.write("m.json", scene.motion.text())

    def outline(self, name, files, *flags):
        """The JSON and the rows, or None after a failed check. A motion with a transform that the checker does not read is beside the certificate."""
        if os.path.exists(self.certificate + ".json"):
            os.remove(self.certificate + ".json")
        out = self.program.call("outline", *files, "--samples", self.table, "--certify", self.certificate, "--format", "json", *flags)
        if out.returncode:
            self.checks.fail(name, f"exit {out.returncode}: {out.stderr.strip()[:300]}")
            return None
        return json.loads(out.stdout), rows_of(read(self.table))

    def check(self, *files):
        out = run([self.checker, *files], env=without_leaks())
        return out.returncode, out.stdout, out.stderr

    def readable(self, files):
        """Solid and motion for the checker."""
        beside = self.certificate + ".json"
        return (files[0], beside if os.path.exists(beside) else files[1])


def point(row):
    return F(row["x"]), F(row["y"])


def check_rows(checks, name, record, rows, unsweep):
    """The rows of each arc and of each lower arc."""
    beside = "out" if unsweep else "in"
    checks.equal([row["pmc"] for row in rows], [row["side"] for row in rows], name, "pmc is the side")
    arcs, lower = [[] for _ in record["arcs"]], [[] for _ in record["lower"]["arcs"]]
    for row in rows:
        (arcs[int(row["arc"])] if row["arc"] else lower[int(row["lower"])]).append(row)
    for arc, mine in zip(record["arcs"], arcs):
        pairs = list(zip(mine[::2], mine[1::2]))
        checks.holds(len(mine) == 2 * len(pairs) > 0, name, "an arc has pairs", len(mine))
        checks.holds(all((a["side"], b["side"]) == ("in", "out") for a, b in pairs), name, "in, out", mine)
        checks.holds(all(sum(x != y for x, y in zip(point(a), point(b))) == 1 for a, b in pairs), name, "one coordinate differs", mine)
        checks.equal([[row["x"], row["y"]] for row in mine[:2]], [arc["sample"][side] for side in ("in", "out")], name, "the sample of the JSON")
    pairs = [(point(a), point(b)) for mine in arcs for a, b in zip(mine[::2], mine[1::2])]
    checks.equal(len(set(pairs)), len(pairs), name, "different pairs")
    for mine in lower:
        checks.equal([row["side"] for row in mine], [beside, "on", beside], name, "a lower arc")
        ends = [point(row) for row in mine]
        checks.equal(ends[1], tuple((a + b) / 2 for a, b in zip(ends[0], ends[-1])), name, "the middle of a lower arc")
    checks.equal(len(rows), 2 * sum(len(mine) // 2 for mine in arcs) + 3 * len(lower), name, "rows")


def crosses(a, b, p, q):
    """Does the open segment ab cross the open segment pq? No point lies on the other one's line."""
    def side(u, v, w):
        return (v[0] - u[0]) * (w[1] - u[1]) - (v[1] - u[1]) * (w[0] - u[0])
    return side(a, b, p) * side(a, b, q) < 0 and side(p, q, a) * side(p, q, b) < 0


def check_standing(checks, scene, rows):
    edges = [(ring[k - 1], ring[k]) for part in scene.solid.parts for ring in part for k in range(len(ring))]
    checks.equal(len(edges), RESTING[scene.name], scene.name, "edges")
    seen = Counter()
    for a, b in zip(rows[::2], rows[1::2]):
        met = [k for k, edge in enumerate(edges) if crosses(point(a), point(b), *edge)]
        checks.equal(len(met), 1, scene.name, "edges that a pair crosses", a, b)
        seen.update(met)
    checks.equal(len(seen), len(edges), scene.name, "edges that are crossed")


def check_scene(checks, sampler, scene):
    files, flags = sampler.files(scene), ("--operation", "unsweep") if scene.unsweep else ()
    got = sampler.outline(scene.name, files, *flags)
    if not got:
        return
    record, rows = got
    proved = (0, f"verified: {len(rows)} rows\n")
    check_rows(checks, scene.name, record, rows, scene.unsweep)
    checks.equal(sampler.check(*sampler.readable(files), sampler.certificate, sampler.table)[:2], proved, scene.name, "graze-check")
    if scene.name in RESTING:
        check_standing(checks, scene, rows)


def classified(checks, sampler):
    """Table and certificate are those of `graze classify` of the same points."""
    for name in ("U to the right by 2", "square along a leg"):
        scene, = (s for s in SCENES if s.name == name)
        files = sampler.files(scene)
        _, rows = sampler.outline(name, files)
        again, proof = (os.path.join(sampler.program.folder.name, base) for base in ("again.csv", "again.txt"))
        points = sampler.program.write("points.csv", "x,y,arc,lower,side\n" + "".join(f"{r['x']},{r['y']},{r['arc']},{r['lower']},{r['side']}\n" for r in rows))
        sampler.program.call("classify", *files, points, "-o", again, "--certify", proof)
        checks.equal((read(sampler.table), read(sampler.certificate)), (read(again), read(proof)), name, "bytes of classify")
        checks.equal(sampler.program.call("compare", sampler.table, again).returncode, 0, name, "compare")


def forged(checks, sampler):
    """Each column of a row, a claim of the certificate, another motion: refuted, or not checked."""
    scene, = (s for s in SCENES if s.name == "square along a leg")
    files = sampler.files(scene)
    _, rows = sampler.outline(scene.name, files)
    table, proof = read(sampler.table), read(sampler.certificate)
    first = next(k for k, line in enumerate(table.splitlines()) if line.startswith("x,")) + 1
    for k, side in ((first, "in"), (first + 1, "out")):
        checks.equal(rows[k - first]["pmc"], side, "forged", k)
        lines = table.splitlines(True)
        cells = lines[k].split(",")
        for column, wrong in ((0, "17"), (2, "on"), (2, "out" if side == "in" else "in"), (-4, "OIO" if side == "out" else "O")):
            made = list(cells)
            checks.holds(made[column] != wrong, "forged", made, wrong)
            made[column] = wrong
            other = sampler.program.write("forged.csv", "".join([*lines[:k], ",".join(made), *lines[k + 1:]]))
            status, _, error = sampler.check(*files, sampler.certificate, other)
            checks.holds(status == 1 and f"forged.csv:{k + 1}" in error, "forged", made, status, error)
    row = next(line for line in proof.splitlines() if line.startswith("row ") and " in " in line)
    other = sampler.program.write("forged.txt", proof.replace(row, row.replace(" in ", " out ", 1)))
    checks.equal(sampler.check(*files, other, sampler.table)[0], 1, "forged", row)
    moved = sampler.program.write("n.json", scene.motion.text().replace("3", "4"))
    checks.holds(sampler.check(files[0], moved, sampler.certificate, sampler.table)[0] != 0, "forged", "another motion")


def conversions(checks, sampler):
    """A solid or a motion that the checker cannot read is converted beside the certificate; a motion of a pipe is read once."""
    solid, square = sampler.program.write("b.csg.json", BOX), sampler.program.write("b.wkt", Polygon([[box_ring(0, 0, 1, 2)]]).text())
    motion = sampler.program.write("turn.json", TURN)
    beside = [sampler.certificate + ending for ending in (".wkt", ".json")]
    out = sampler.program.call("outline", solid, motion, "--samples", sampler.table, "--certify", sampler.certificate)
    checks.holds(out.returncode == 0 and all(f"give it {path} instead" in out.stderr for path in beside), "converted", out.stderr)
    checks.equal(sampler.check(*beside, sampler.certificate, sampler.table)[:2], (0, f"verified: {len(rows_of(read(sampler.table)))} rows\n"), "converted")
    out = run([sampler.program.path, "outline", square, "/dev/stdin", "--samples", sampler.table, "--certify", sampler.certificate], input=ALONG)
    checks.equal(out.returncode, 0, "a motion of a pipe, which is read once", out.stderr)
    checks.equal(sampler.check(square, sampler.program.write("along.json", ALONG), sampler.certificate, sampler.table)[0], 0, "a motion of a pipe")
    out = sampler.program.call("outline", solid, motion, "--samples", sampler.table, "--certify", "-")
    checks.holds(out.returncode == 3 and "a certificate in FILE has it as FILE.off or FILE.wkt" in out.stderr, "standard output", out.stderr)


def ends(checks, sampler):
    """Both files on standard output, an outline without points, and a limit that is met."""
    files = sampler.program.write("triangle.wkt", Polygon([[ring((0, 0), (1, 0), (0, 1))]]).text()), sampler.program.write("along.json", ALONG)
    sampler.outline("forms", files)
    for option, path in (("--samples", sampler.table), ("--certify", sampler.certificate)):
        more = () if option == "--samples" else ("--samples", sampler.table)
        out = sampler.program.call("outline", *files, option, "-", *more)
        checks.equal((out.returncode, out.stdout), (0, read(path)), option, "-")
        checks.holds("components: 1" in out.stderr, option, "the report", out.stderr)
    far = sampler.program.write("far.json", json.dumps({"dimension": 2, "pieces": [{"t": [0, 1], "transform": {"translate": ["9*t", "0"]}}]}))
    got = sampler.outline("empty", (files[0], far), "--operation", "unsweep")
    checks.equal(got and got[1], [], "an empty unsweep")
    checks.equal(sampler.check(files[0], far, sampler.certificate, sampler.table)[:2], (0, "verified: 0 rows\n"), "an empty unsweep")
    turn = sampler.program.write("turn.json", TURN)
    out = sampler.program.call("outline", files[0], turn, "--samples", sampler.table, "--limit", "digits=1")
    checks.holds(out.returncode == 6 and "digits" in out.stderr, "limit digits", out.returncode, out.stderr)


def main():
    args = options(__doc__.splitlines()[0], ("--only", {"default": "", "help": "scenes whose name contains this text"}))
    checks = Checks()
    sampler = Sampler(Program(args, checks), checks)
    for scene in SCENES:
        if args.only in scene.name:
            check_scene(checks, sampler, scene)
    classified(checks, sampler)
    forged(checks, sampler)
    conversions(checks, sampler)
    ends(checks, sampler)
    checks.finish()


if __name__ == "__main__":
    main()
