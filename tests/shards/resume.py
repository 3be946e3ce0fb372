#!/usr/bin/env python3
# suite
"""Interrupted tables are continued without losing or repeating a row; a table or receipt of another run is refused
and left as it was. Every expected table is the one a single run writes.

SPDX-License-Identifier: GPL-3.0-or-later
"""

from bench import COMMON, altered, random_points, run_checks, scenes, split


def cuts(bench, table):
    """Places at which a table may have been cut off: in the head, at its end, in rows, between rows, at the end."""
    lines = [0]
    for line in table.splitlines(keepends=True):
        lines.append(lines[-1] + len(line))
    chosen = {0, 1, len(table) - 1} | set(lines[:-1][-5:]) | set(bench.random.sample(lines[:-1], min(8, len(lines) - 1)))
    chosen |= {bench.random.randrange(len(table)) for _ in range(12 * bench.scale)}
    return sorted(chosen)


def check_resume(bench):
    """A table that was cut anywhere is continued to the bytes of one run."""
    for name, words, points, stdin in scenes(bench):
        for more in ([], ["--shard", "2/3"]):
            whole = bench.good(*words, *points, *more, stdin=stdin)
            path = bench.folder / "resumed.csv"
            path.unlink(missing_ok=True)
            for cut in [None] + cuts(bench, whole):
                if cut is not None:
                    path.write_bytes(whole[:cut])
                out = bench.good(*words, *points, *more, "--resume", path, stdin=stdin)
                bench.check(out == b"" and path.read_bytes() == whole, f"{name} {more}: continued from byte {cut}")


def check_resume_refusals(bench):
    """A file that cannot be continued is refused, and stays as it was."""
    words = ["classify", COMMON / "cube.off", COMMON / "move3.json"]
    text = random_points(bench.random, 50, 3)
    points = bench.file("begun.csv", text)
    whole = bench.good(*words, points)
    head, rows, _ = split(whole)
    half = b"".join(head + rows[:20]) + b"1,2"

    def refused(what, says, content, *more, status=3):
        path = bench.file("refused.csv", content)
        seen, out, err = bench.run(*words, *more, "--resume", path)
        bench.check(seen == status and out == b"" and err.count(b"\n") == 1 and path.read_bytes() == content and
                    says in err, f"resume refuses and changes nothing: {what}", seen, err)

    other = b"expected a table of this run"
    refused("a complete table", b"is complete with its 50 rows", whole, points)
    refused("other options", b"`# folds combined` is this run's", half, points, "--folds", "combined")
    refused("a shard of it", b"`# shard 1/2` is this run's", half, points, "--shard", "1/2")
    refused("other columns", b"`x,y,z,pmc", half, bench.file("plain.csv", b"0,0,0\n" * 50))
    refused("no table", other, b"hello\nworld\n", points)
    refused("half a line of text", other, b"hello", points)
    refused("half another head", other, half[:half.index(b"# ends-meet")].replace(b"# round none", b"# round nine"), points)
    refused("a head of another version", other, half.replace(b"# graze ", b"# graze 9"), points)
    lines = text.splitlines(keepends=True)
    place = next(k for k, line in enumerate(lines) if line.startswith(b"p19,"))
    refused("another point at the last row", b"expected a table of this run that was not changed", half,
            bench.file("moved.csv", b"".join(lines[:place] + [b"p19,99,99,99,x\n"] + lines[place + 1:])))
    refused("fewer points than rows", b"has more than the 19 rows for which there are points", half,
            bench.file("fewer.csv", b"".join(lines[:place])))
    refused("its own points", b"which is read; expected another file", text, bench.folder / "refused.csv", status=2)


def refuse_kept(bench, run, name, head, rows):
    """Every alteration of a kept row is refused and changes nothing, and what is not altered is continued."""
    for turn in range(3 * bench.scale):
        kept = bench.random.randrange(3, len(rows))
        at = bench.random.randrange(kept - 1)
        for what, row in altered(bench, rows, at):
            content = b"".join(head + rows[:at] + [row] + rows[at + 1:kept]) + bench.random.choice((b"", b"1,"))
            path = bench.file("altered.csv", content)
            status, out, err = run(path)
            bench.check(status == 3 and out == b"" and err.count(b"graze: ") == 1 and path.read_bytes() == content and
                        b"altered.csv" in err, f"{name}: row {at + 1} of {kept} has {what}", status, err)


def check_kept_rows(bench):
    """The rows that a table has already are those of the points, whatever their number."""
    words = ["classify", COMMON / "cube.off", COMMON / "move3.json"]
    text = b"x,y,z,n,note\n" + b"".join(b"%d/3,%d,1/2,%d,\"a, %d\"\n" % (7 * k % 60 - 9, k % 4 - 1, k, k) for k in range(60))
    points = bench.file("kept.csv", text)
    for more in ([], ["--operation", "unsweep"], ["--folds", "combined", "--shard", "2/3"]):
        head, rows, _ = split(bench.good(*words, points, *more))
        run = lambda path: bench.run(*words, points, *more, "--resume", path)
        refuse_kept(bench, run, f"{more}", head, rows)
        path = bench.file("whole.csv", b"".join(head + rows[:10]))
        bench.good(*words, points, *more, "--resume", path)
        bench.check(path.read_bytes() == bench.good(*words, points, *more), f"{more}: unaltered, it is continued")
    head, rows, _ = split(bench.good(*words, points))
    lines = text.splitlines(keepends=True)
    begun = b"".join(head + rows[:20])
    for what, line in (("another point in row 2", b"5,5,5,1,\"a, 1\"\n"),
                       ("another note in row 2", lines[2].replace(b"a, 1", b"a, 2")),
                       ("row 2 away", b"")):
        path = bench.file("begun.csv", begun)
        other = bench.file("others.csv", b"".join(lines[:2] + [line] + lines[3:]))
        status, out, err = bench.run(*words, other, "--resume", path)
        bench.check(status == 3 and out == b"" and b"expected a table of this run that was not changed" in err and
                    path.read_bytes() == begun, f"the points have {what}", status, err)


def check_kept_grid(bench):
    """Kept rows of a grid, whose points no file has; three coordinates and two."""
    for words in (["classify", COMMON / "cube.off", COMMON / "move3.json", "--grid", "4,3,5"],
                  ["classify", COMMON / "square.wkt", COMMON / "move2.json", "--grid", "6,7", "--shard", "1/2"]):
        head, rows, _ = split(bench.good(*words))
        refuse_kept(bench, lambda path: bench.run(*words, "--resume", path), words[-1], head, rows)


def check_receipts(bench):
    """A receipt changes no byte of a table, and serves for nothing but what it was written for."""
    receipt, cube, move = bench.folder / "receipt.txt", COMMON / "cube.off", COMMON / "move3.json"
    for solid, motion, options in ((cube, move, []), (COMMON / "square.wkt", COMMON / "move2.json", []),
                                   (cube, move, ["--round", "binary32"]), (cube, move, ["--triangulate"])):
        bench.good("check", "--receipt", receipt, solid, motion, *options)
        words = ["classify", solid, motion, *options, "--grid", "5,5,5" if solid == cube else "5,5"]
        bench.check(bench.good(*words, "--receipt", receipt) == bench.good(*words), f"a receipt changes nothing: {options}")
    bench.good("check", "--receipt", receipt, cube, move)
    content = receipt.read_bytes()
    turned = bench.file("turned.off", cube.read_bytes() + b"\n")
    slower = bench.file("slower.json", move.read_bytes() + b"\n")

    def refused(what, says, solid=cube, motion=move, *more):
        status, out, err = bench.run("classify", solid, motion, "--grid", "5,5,5", "--receipt", receipt, *more)
        bench.check(status == 3 and out == b"" and says in err, f"the receipt is refused: {what}", status, err)

    refused("another solid", b"turned.off: is not the file that was validated", turned)
    refused("another motion", b"this run has `motion-sha256", cube, slower)
    refused("another rounding", b"this run has `round binary64`", cube, move, "--round", "binary64")
    refused("another way to cut facets", b"this run has `triangulate yes`", cube, move, "--triangulate")
    for k in bench.random.sample(range(len(content)), 40):
        receipt.write_bytes(content[:k] + bytes([content[k] ^ 1]) + content[k + 1:])
        refused(f"byte {k} is another", b"expected a receipt as graze check")
    receipt.write_bytes(content[:-9])
    refused("it is cut", b"expected a receipt as graze check")
    receipt.unlink()
    crossed = bench.file("crossed.off", cube.read_bytes().replace(b"2 2 2", b"2 2 -1"))
    status, _, _ = bench.run("check", "--receipt", receipt, crossed, move)
    bench.check(status == 1 and not receipt.exists(), "there is no receipt for an illegal solid", status)


if __name__ == "__main__":
    run_checks(__doc__, [check_resume, check_resume_refusals, check_kept_rows, check_kept_grid, check_receipts])
