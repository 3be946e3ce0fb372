#!/usr/bin/env python3
# suite
"""The record of an unfinished run (src/program/cli/formats.md, Tables): what it covers is not made again, what was changed
under it is refused, and one that does not help is left aside.

Records are written here by the form that formats.md gives, with a checksum of their own; every expected table is the one a
single run writes.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import signal
import subprocess
import time

from bench import COMMON, SECONDS, checksum, random_points, run_checks, split

CUBE = [COMMON / "cube.off", COMMON / "move3.json"]


def lines_of(points):
    """The lines of a file of points that name columns or are rows."""
    return [line for line in points.splitlines() if line.strip() and not line.startswith(b"#")]


def record(rows, points, table, certificate=b"", undecided=0, wide=0):
    """The record after `rows` rows; `table` and `certificate` are the bytes up to there."""
    sums = b"".join(line + b"\n" for line in lines_of(points)[:rows + 1]) if points is not None else None
    parts = [b"%020d %016x" % (len(data), checksum(data)) if data else b"%020d %016x" % (0, 0) for data in (table, certificate)]
    line = b"graze kept 1 rows %020d undecided %020d wide %020d points %016x table %b certificate %b" % (
        rows, undecided, wide, checksum(sums) if sums is not None else 0, *parts)
    return line + b" sum %016x\n" % checksum(line)


def begun(bench, words, points, count, more=()):
    """(path of a table with `count` rows, whole table, its bytes up to there)."""
    whole = bench.good("classify", *words, points, *more)
    head, rows, _ = split(whole)
    kept = b"".join(head + rows[:count])
    return bench.file("begun.csv", kept), whole, kept


def check_passed(bench):
    """Rows under the record are taken as they are: a record that fits an altered table proves that they are not made
    again; without it the same table is refused."""
    text = random_points(bench.random, 200, 3)
    points = bench.file("points.csv", text)
    path, whole, kept = begun(bench, CUBE, points, 120)
    companion = bench.folder / "begun.csv.kept"
    companion.write_bytes(record(120, text, kept))
    path.write_bytes(kept + split(whole)[1][120][:7])
    bench.good("classify", *CUBE, points, "--resume", path)
    bench.check(path.read_bytes() == whole and not companion.exists(), "continued behind the record, which is gone")
    head, rows, _ = split(whole)
    forged = [rows[3].replace(b",", b",1", 1)] + rows[4:120]
    other = b"".join(head + rows[:3] + forged)
    for told in (record(120, text, other), None):
        path.write_bytes(other)
        companion.unlink(missing_ok=True)
        if told:
            companion.write_bytes(told)
        status, _, err = bench.run("classify", *CUBE, points, "--resume", path)
        if told:
            bench.check(status == 0 and path.read_bytes() == other + whole[len(b"".join(head + rows[:120])):],
                        "rows under a record are not made again", status, err)
        else:
            bench.check(status == 3 and path.read_bytes() == other, "without it they are", status, err)


def check_counts(bench):
    """Positions counted before the record's end are counted in the end."""
    roofs = [COMMON.parent.parent / "examples" / "solids" / "crossed_roofs.off",
             COMMON.parent.parent / "examples" / "motions" / "roofs_54.json"]
    text = b"x,y,z\n0,0,0\n90,0,0\n0,0,0\n"
    points = bench.file("roofs.csv", text)
    path, whole, kept = begun(bench, roofs, points, 1, ["--topo", "--quiet"])
    (bench.folder / "begun.csv.kept").write_bytes(record(1, text, kept, undecided=1))
    bench.good("classify", *roofs, points, "--topo", "--quiet", "--resume", path)
    bench.check(b"\n# undecided 2\n# complete 3\n" in whole and path.read_bytes() == whole, "undecided rows are counted once")


def check_refused(bench):
    """A table, or points, that are not those of the record."""
    text = random_points(bench.random, 90, 3)
    points = bench.file("points.csv", text)
    for turn in range(12 * bench.scale):
        count = bench.random.randrange(5, 80)
        path, whole, kept = begun(bench, CUBE, points, count)
        companion = bench.folder / "begun.csv.kept"
        at = bench.random.randrange(len(b"".join(split(whole)[0])), len(kept))
        altered = kept[:at] + bytes([kept[at] ^ 1]) + kept[at + 1:]
        path.write_bytes(altered)
        companion.write_bytes(record(count, text, kept))
        status, _, err = bench.run("classify", *CUBE, points, "--resume", path)
        bench.check(status == 3 and path.read_bytes() == altered and companion.exists() and err.count(b"\n") == 1 and
                    b"its first %d rows are not those that were written" % count in err, f"byte {at} was changed", status, err)
        path.write_bytes(kept)
        lines = text.splitlines(keepends=True)
        row = bench.random.choice([k for k, line in enumerate(lines) if line.startswith(b"p") and int(line[1:line.index(b",")]) < count])
        for what, other, says in (("another point", lines[:row] + [b"q" + lines[row]] + lines[row + 1:], b"rows are of other points"),
                                  ("fewer points", lines[:4], b"more than there are points"),
                                  ("other columns", [line.replace(b"name,x,y", b"name,y,x") for line in lines], b"rows are of other points")):
            status, _, err = bench.run("classify", *CUBE, bench.file("other.csv", b"".join(other)), "--resume", path)
            bench.check(status == 3 and says in err and path.read_bytes() == kept, what, status, err)
    companion.write_bytes(b"my own notes\n")
    for words in (["--resume", path], ["--output", path]):
        status, _, err = bench.run("classify", *CUBE, points, *words)
        bench.check(status == 3 and b"begun.csv.kept: is no record of graze" in err and companion.read_bytes() == b"my own notes\n",
                    f"a file of the user's own: {words[0]}", status, err)
    status, _, err = bench.run("classify", *CUBE, companion, "--output", path)
    bench.check(status == 2 and b"which is read; expected another file" in err, "points of that name", status, err)
    companion.unlink()


def check_left_aside(bench):
    """A record that is not whole, or of a longer table, does not help: rows are made again. A new table takes an old one away."""
    text = random_points(bench.random, 60, 3)
    points = bench.file("points.csv", text)
    path, whole, kept = begun(bench, CUBE, points, 40)
    companion = bench.folder / "begun.csv.kept"
    good = record(40, text, kept)
    broken = [b"", good[:100], good[:-1].replace(b"rows 0", b"rows 1"), record(60, text, whole)]
    broken += [good[:k] + bytes([good[k] ^ 1]) + good[k + 1:] for k in bench.random.sample(range(13, len(good) - 1), 12)]
    for line in broken:
        path.write_bytes(kept)
        companion.write_bytes(line)
        bench.good("classify", *CUBE, points, "--resume", path)
        bench.check(path.read_bytes() == whole and not companion.exists(), f"left aside: {line}")
    companion.write_bytes(good)
    bench.good("classify", *CUBE, points, "--output", path)
    bench.check(path.read_bytes() == whole and not companion.exists(), "a new table takes it away")


def check_written(bench):
    """A run that is killed, or ended by a signal, leaves a record that is of its files, and the next one goes on."""
    # A record is written each second, which the run must take.
    words = ["classify", *CUBE, "--grid", "25,25,25" if bench.sanitizers else "40,40,40", "--jobs", "1"]
    whole = bench.folder / "grid.txt"
    table = bench.good(*words, "--certify", whole)
    path, beside = bench.folder / "killed.csv", bench.folder / "killed.txt"
    companion = bench.folder / "killed.csv.kept"
    for which in (signal.SIGINT, signal.SIGKILL):
        for left in (path, beside, companion):
            left.unlink(missing_ok=True)
        child = subprocess.Popen([bench.graze, *map(str, words), "--output", path, "--certify", beside],
                                 stderr=subprocess.DEVNULL, preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))
        end = time.monotonic() + SECONDS
        ready = (lambda: companion.exists()) if which == signal.SIGKILL else (lambda: path.exists() and path.stat().st_size > 20000)
        while child.poll() is None and time.monotonic() < end and not ready():
            time.sleep(0.002)
        time.sleep(0.02)
        child.send_signal(which)
        child.wait(SECONDS)
        bench.check(child.returncode == -which, f"{which.name} came before the end", child.returncode)
        told = companion.read_bytes()
        rows = int(told.split()[4])
        head, made, _ = split(table)
        kept = b"".join(head + made[:rows])
        certificate = whole.read_bytes()
        ends = int(told.split()[told.split().index(b"certificate") + 1])
        bench.check(rows > 0 and told == record(rows, None, kept, certificate[:ends]), f"{which.name} leaves a record of {rows} rows", told)
        bench.check(certificate[:ends].count(b"\nrow ") == rows, f"{which.name}: and of as many of the certificate")
        bench.good(*words, "--resume", path, "--certify", beside)
        bench.check(path.read_bytes() == table and beside.read_bytes() == certificate and not companion.exists(), f"after {which.name} both are whole")


if __name__ == "__main__":
    run_checks(__doc__, [check_passed, check_counts, check_refused, check_left_aside, check_written])
