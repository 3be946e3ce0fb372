#!/usr/bin/env python3
# suite
"""Tables of contact points by several threads and shards, and continued ones: to the byte the table of one run. A kept
row that is altered is refused and stays.

SPDX-License-Identifier: GPL-3.0-or-later
"""

from bench import COMMON, run_checks, split
from exact import Fraction as F

CUBE = ["contact", COMMON / "cube.off", COMMON / "move3.json"]
NAMES = (b"time,bx,by,bz,x,y,z,cell,role,theta,contact_order,orientation,left,right,trimmed,status,near,near_decimal,near_in,near_in_decimal,word")


def sites(bench, count):
    """Points of the cube's faces, with what stands beside them; moved ones lie anywhere."""
    chance = bench.random
    vertices = [tuple(int(x) for x in line.split()) for line in (COMMON / "cube.off").read_text().splitlines()[2:10]]
    low, high = min(vertices), max(vertices)
    lines, moved = ["# made by a test", "name,time,bx,by,bz,note"], ["cell,time,bx,by,bz,note"]
    for k in range(count):
        t = F(chance.randint(0, 16), 16)
        p = [F(a) + (b - a) * F(chance.randint(0, 12), 12) for a, b in zip(low, high)]
        p[chance.randrange(3)] = F(chance.choice((low[0], high[0])))
        lines.append(f"p{k},{t}," + ",".join(map(str, p)) + f',"a, {k}"')
        cell = chance.choice((f"face {chance.randrange(6)}", f"vertex {chance.randrange(8)}", "edge 0-1"))
        moved.append(f"{cell},{t}," + ",".join(str(x + chance.randint(-1, 1)) for x in p) + f",{k}")
        if chance.random() < 0.05:
            lines.append(chance.choice(("", "# between", "   ")))
    return [bench.file("sites.csv", "\n".join(lines).encode())], [bench.file("moved.csv", "\n".join(moved).encode()), "--snap"]


def check_threads(bench):
    for points in sites(bench, 300 * bench.scale):
        whole = bench.good(*CUBE, *points, "--jobs", "1")
        bench.check(whole.count(b"\n") > 300 and NAMES in whole, "a table", whole[:2000])
        for jobs in ("2", "7"):
            bench.check(bench.good(*CUBE, *points, "--jobs", jobs) == whole, f"{jobs} threads")
        lines = bench.good(*CUBE, *points, "--format", "jsonl", "--jobs", "3")
        bench.check(lines == bench.good(*CUBE, *points, "--format", "jsonl", "--jobs", "1") and lines.count(b"\n") == 300 * bench.scale,
                    "JSON Lines")


def check_shards(bench):
    for points in sites(bench, 101):
        whole = bench.good(*CUBE, *points)
        for count in (1, 2, 5):
            parts = []
            for k in range(count):
                table = bench.good(*CUBE, *points, "--shard", f"{k + 1}/{count}")
                head, rows, end = split(table)
                bench.check(f"# shard {k + 1}/{count}\n".encode() in head and end[0] == b"# rows-of-all-shards 101\n",
                            "marks of a shard", head, end)
                bench.check(rows == split(whole)[1][k::count], "rows of a shard")
                parts.append(bench.file(f"part{k}.csv", table))
            bench.check(bench.good("merge", *parts[::-1], "--quiet") == whole, f"{count} parts put together")
        other = bench.file("other.csv", bench.good("classify", *CUBE[1:], "--grid", "5,5,5", "--shard", "1/2"))
        mine = bench.file("mine.csv", bench.good(*CUBE, *points, "--shard", "2/2"))
        status, out, err = bench.run("merge", other, mine, "--quiet")
        bench.check(status == 3 and out == b"" and b"expected parts of one run" in err, "no part of classify", err)


def check_resume(bench):
    for points in sites(bench, 40):
        for more in ([], ["--shard", "2/3"]):
            whole = bench.good(*CUBE, *points, *more)
            path = bench.folder / "resumed.csv"
            ends = [0]
            for line in whole.splitlines(keepends=True):
                ends.append(ends[-1] + len(line))
            chosen = {0, 1, len(whole) - 1} | set(ends[:-1][-5:]) | set(bench.random.sample(ends[:-1], 8))
            chosen |= {bench.random.randrange(len(whole)) for _ in range(8 * bench.scale)}
            for cut in sorted(chosen):
                path.write_bytes(whole[:cut])
                out = bench.good(*CUBE, *points, *more, "--resume", path, "--quiet")
                bench.check(out == b"" and path.read_bytes() == whole, f"{points[1:]} {more}: continued from byte {cut}")


def alterations(row, moved):
    """Altered rows that no run writes in its place."""
    fields = row.rstrip(b"\n").split(b",")
    word = 20

    def put(*changes):
        new = list(fields)
        for k, value in changes:
            new[k] = value
        return b",".join(new) + b"\n"
    yield "another time", put((0, b"977/3"))
    yield "another y", put((1, b"977"))
    yield "no cell", put((7, b"x"))
    yield "a column more", row[:-1] + b",1\n"
    yield "a column less", row.rpartition(b",")[0] + b"\n"
    yield "NUL bytes", bytes(len(row) - 1) + b"\n"
    yield "a comment", b"# " + row
    yield "a row less", b""
    yield "a row more", row + row
    if not fields[8]:
        yield "a role alone", put((8, b"hidden"))
        yield "a shift alone", put((21, b"1"))
        return
    yield "another role", put((8, b"contacts"))
    yield "a theta of its own", put((9, b"+" if not fields[9] else b""))
    yield "another trimmed", put((14, b"no" if fields[14] == b"yes" else b"yes"))
    yield "another status", put((15, b"meets" if fields[14] == b"yes" else b"trimmed_far"))
    yield "no near_in" if fields[18] else "a near_in", put((18, b"" if fields[18] else b"1/2"))
    yield "no decimal of near" if fields[17] else "a decimal of near", put((17, b"" if fields[17] else b"0.5"))
    yield "a word of no run", put((word, b"BB"))
    yield "a word with another end", put((word, b"OBO" if b"I" in fields[word] else b"OBI"))
    if moved:
        yield "another shift", put((21, b"977/5"))


def check_kept(bench):
    """Every alteration of a kept row is refused and changes nothing."""
    for points in sites(bench, 60):
        head, rows, _ = split(bench.good(*CUBE, *points))
        for at in bench.random.sample(range(len(rows) - 5), 12 * bench.scale):
            for what, row in alterations(rows[at], "--snap" in points):
                content = b"".join(head + rows[:at] + [row] + rows[at + 1:at + 4])
                path = bench.file("altered.csv", content)
                status, out, err = bench.run(*CUBE, *points, "--resume", path, "--quiet")
                bench.check(status == 3 and out == b"" and err.count(b"graze: ") == 1 and path.read_bytes() == content,
                            f"row {at + 1} has {what}", rows[at], status, err)
    by_place = bench.file("place.csv", b"time,x,y,z\n" + b"".join(
        b",".join([r.split(b",")[k] for k in (0, 4, 5, 6)]) + b"\n" for r in split(bench.good(*CUBE, *sites(bench, 30)[0]))[1]))
    whole = bench.good(*CUBE, by_place)
    head, rows, _ = split(whole)
    path = bench.file("kept.csv", b"".join(head + rows[:9]))
    bench.good(*CUBE, by_place, "--resume", path, "--quiet")
    bench.check(path.read_bytes() == whole, "by x, y, z")
    moved = rows[3].split(b",")
    content = b"".join(head + rows[:3] + [b",".join(moved[:4] + [b"977"] + moved[5:])] + rows[4:9])
    path = bench.file("kept.csv", content)
    status, _, err = bench.run(*CUBE, by_place, "--resume", path, "--quiet")
    bench.check(status == 3 and path.read_bytes() == content and b"this run's: expected a table of this run" in err, "another x", status, err)


if __name__ == "__main__":
    run_checks(__doc__, [check_threads, check_shards, check_resume, check_kept])
