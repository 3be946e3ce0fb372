#!/usr/bin/env python3
# suite
"""Shards merge into the bytes of one run, and what does not belong together is refused.

Every expected table is the one a single run writes; a shard's rows are every n-th of its rows.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import shlex
import shutil
import subprocess

from bench import COMMON, SECONDS, altered, random_points, run_checks, scenes, sealed, split


def check_shards(bench):
    """Parts hold every n-th row, and merge into the table of one run."""
    for name, words, points, stdin in scenes(bench):
        whole = bench.good(*words, *points, stdin=stdin)
        head, rows, _ = split(whole)
        for count in (1, 2, 3, 7, 40):
            parts = []
            for index in range(1, count + 1):
                path = bench.folder / f"part-{index}.csv"
                jobs = bench.random.choice((1, 2, 3))
                bench.good(*words, *points, "--shard", f"{index}/{count}", "--output", path, "--jobs", jobs,
                           stdin=stdin)
                its_head, its_rows, end = split(path.read_bytes())
                its_head.remove(f"# shard {index}/{count}\n".encode())
                bench.check(its_head == head, f"{name}: head of shard {index}/{count}", its_head)
                bench.check(its_rows == rows[index - 1::count], f"{name}: rows of shard {index}/{count}", its_rows)
                bench.check(end[0] == b"# rows-of-all-shards %d\n" % len(rows) and len(end) == 4 and
                            sealed([path.read_bytes()[:-len(end[2] + end[3])]], len(its_rows)) == path.read_bytes(),
                            f"{name}: end of {index}/{count}", end)
                parts.append(path)
            bench.random.shuffle(parts)
            bench.check(bench.good("merge", *parts) == whole, f"{name}: {count} shards merge into the whole")


def check_many_parts(bench):
    """More parts than a process may have open files."""
    words = ["classify", COMMON / "square.wkt", COMMON / "move2.json"]
    whole = bench.good(*words, "--grid", "12,12")
    parts = []
    for index in range(1, 61):
        parts.append(bench.folder / f"many-{index}.csv")
        bench.good(*words, "--grid", "12,12", "--shard", f"{index}/60", "--jobs", 1, "--output", parts[-1])
    few = bench.good("merge", *parts, nofile=12)
    bench.check(few == whole, "60 parts merge with 12 descriptors")


def damaged(bench, table):
    """(what was done, table) with a fault in its rows or at its end; the head is left alone."""
    head, rows, end = split(table)
    k = bench.random.randrange(len(rows))
    yield "a row is lost", b"".join(head + rows[:k] + rows[k + 1:] + end)
    yield "a row is there twice", b"".join(head + rows[:k] + [rows[k]] + rows[k:] + end)
    yield "it lost its end", b"".join(head + rows + end[:3])
    yield "it has no checksum", b"".join(head + rows + end[:2] + end[3:])
    yield "it is cut", table[:bench.random.randrange(len(b"".join(head)), len(table))]
    yield "a count is another", sealed(head + rows + end[:2], len(rows) + 1)
    yield "its count is another", sealed(head + rows[:-1] + end[:2], len(rows))
    yield "all shards have more rows", sealed(head + rows + [b"# rows-of-all-shards 9999\n", end[1]], len(rows))
    yield "its points are others", sealed(head + rows + end[:1] + [b"# points-checksum 0123456789abcdef\n"], len(rows))


def check_damage(bench):
    """Merge gives no whole table of damaged parts, nor of parts that are not one run."""
    words = ["classify", COMMON / "cube.off", COMMON / "move3.json"]
    points = bench.file("some.csv", random_points(bench.random, 90, 3))
    parts = [bench.folder / f"good-{k}.csv" for k in (1, 2, 3)]
    for k in (1, 2, 3):
        bench.good(*words, points, "--shard", f"{k}/3", "--output", parts[k - 1])

    def refused(what, *paths):
        status, out, err = bench.run("merge", *paths)
        bench.check(status == 3 and b"# complete" not in out and err.count(b"\n") == 1,
                    f"merge refuses: {what}", status, err, out[-200:])

    for turn in range(10 * bench.scale):
        at = bench.random.randrange(3)
        for what, content in damaged(bench, parts[at].read_bytes()):
            bad = bench.file("bad.csv", content)
            refused(f"{what} (part {at + 1}, turn {turn})", *(bad if k == at else parts[k] for k in range(3)))
    head, rows, end = split(parts[1].read_bytes())
    for what, row in altered(bench, rows, 3):
        bad = bench.file("bad.csv", b"".join(head + rows[:3] + [row] + rows[4:] + end))
        refused(f"row 4 has {what}", parts[0], bad, parts[2])
    refused("a gap", parts[0], parts[2])
    refused("an overlap", *parts, parts[1])
    refused("one twice and one missing", parts[0], parts[2], parts[2])
    other = bench.folder / "other.csv"
    bench.good(*words, points, "--shard", "2/3", "--folds", "combined", "--output", other)
    refused("other options", parts[0], other, parts[2])
    bench.good(*words, points, "--shard", "2/4", "--output", other)
    refused("another number of shards", parts[0], other, parts[2])
    text = points.read_bytes()
    place = text.index(b"p4,") + 3  # a row of shard 2: another point, the same number of rows
    points.write_bytes(text[:place] + b"7" + text[place:])
    bench.good(*words, points, "--shard", "2/3", "--output", other)
    refused("other points", parts[0], other, parts[2])


def check_parallel(bench):
    """The recipe for GNU parallel."""
    if not shutil.which("parallel"):
        bench.checks.skip("parallel", "GNU parallel is not installed")
        return
    points = bench.file("spread.csv", random_points(bench.random, 300, 3))
    scene = [COMMON / "cube.off", COMMON / "move3.json", points]
    whole = bench.good("classify", *scene)
    graze = shlex.quote(bench.graze)
    done = subprocess.run(f"parallel -q -j 2 {graze} classify --jobs 1 --shard {{}}/6 --resume spread-{{}}.csv "
                          f"{shlex.join(map(str, scene))} ::: 1 2 3 4 5 6 && {graze} merge spread-*.csv", shell=True, timeout=SECONDS,
                          cwd=bench.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          env=dict(os.environ, HOME=str(bench.folder)))
    bench.check(done.returncode == 0, "parallel runs six shards", done.stderr)
    bench.check(done.stdout.endswith(whole), "six shards of parallel merge into the whole", done.stdout[:300])


if __name__ == "__main__":
    run_checks(__doc__, [check_shards, check_many_parts, check_damage, check_parallel])
