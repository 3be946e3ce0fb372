#!/usr/bin/env python3
# suite
"""Long runs and many machines: shards merge into the bytes of one run, interrupted tables are continued without
losing or repeating a row, and whatever does not belong together is refused and left as it was.

Every expected table is the one a single run writes; a shard's rows are every n-th of its rows.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import argparse
import os
import pathlib
import pty
import random
import re
import resource
import shutil
import signal
import subprocess
import tempfile
import time

COMMON = pathlib.Path(__file__).resolve().parents[1] / "refuse" / "common"
SECONDS = 300


class Bench:
    """What the checks share: the program, a folder for files, chance, and the counts."""

    def __init__(self, graze, folder, scale, seed):
        self.graze, self.folder, self.scale = graze, pathlib.Path(folder), scale
        self.random = random.Random(seed)
        self.passed = self.failed = self.skipped = 0

    def check(self, holds, what, *seen):
        self.passed, self.failed = self.passed + bool(holds), self.failed + (not holds)
        if not holds:
            print("FAILED", what, *(repr(s)[:600] for s in seen))

    def skip(self, name, reason):
        self.skipped += 1
        print(f"SKIP {name}: {reason}")

    def run(self, *words, stdin=None, limit=None):
        """(exit status, standard output, standard error) of graze."""
        done = subprocess.run([self.graze, *map(str, words)], input=stdin, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, timeout=SECONDS, preexec_fn=limit,
                              stdin=subprocess.DEVNULL if stdin is None else None)
        return done.returncode, done.stdout, done.stderr

    def file(self, name, content):
        path = self.folder / name
        path.write_bytes(content)
        return path

    def good(self, *words, **more):
        """Standard output of a run that must succeed."""
        status, out, err = self.run(*words, **more)
        self.check(status == 0 and err == b"", f"{words} succeeds", status, err)
        return out


def random_points(chance, count, dimension):
    """CSV with columns between and behind the coordinates, comments and blank lines."""
    lines = ["# made by a test", "name,x,y,z,note" if dimension == 3 else "name,x,y,note"]
    for k in range(count):
        numbers = [f"{chance.randint(-6, 24)}/{chance.choice((1, 2, 3))}" for _ in range(dimension)]
        lines.append(f"p{k}," + ",".join(numbers) + f',"a, {chance.randint(0, 9)}"')
        if chance.random() < 0.05:
            lines.append(chance.choice(("", "# between", "   ")))
    return ("\n".join(lines) + chance.choice(("", "\n"))).encode()


def split(table):
    """(head, rows, end) of a table, as lists of lines."""
    lines = table.splitlines(keepends=True)
    first = next(k for k, line in enumerate(lines) if not line.startswith(b"#")) + 1
    last = len(lines)
    while lines[last - 1].startswith(b"#"):
        last -= 1
    return lines[:first], lines[first:last], lines[last:]


def scenes(bench):
    """(name, the words of classify without POINTS, the words for the points, standard input)."""
    cube = ["classify", COMMON / "cube.off", COMMON / "move3.json"]
    square = ["classify", COMMON / "square.wkt", COMMON / "move2.json"]
    count = 700 * bench.scale
    points = random_points(bench.random, count, 3)
    flat = random_points(bench.random, 25, 2)
    yield "points", cube, [bench.file("points.csv", points)], None
    yield "pipe", cube, ["-"], points
    yield "few points", square, [bench.file("flat.csv", flat)], None
    yield "no points", square, [bench.file("none.csv", b"x,y,w\n")], None
    yield "grid", cube, ["--grid", "7,5,9"], None
    yield "plane grid", square, ["--grid", "2,3", "--folds", "combined"], None
    yield "unsweep", square, ["--grid", "9,9", "--operation", "unsweep", "--round", "binary32"], None


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
                bench.check(end[0] == b"# rows-of-all-shards %d\n" % len(rows) and
                            end[2] == b"# complete %d\n" % len(its_rows), f"{name}: end of {index}/{count}", end)
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
    few = bench.good("merge", *parts, limit=lambda: resource.setrlimit(resource.RLIMIT_NOFILE, (12, 12)))
    bench.check(few == whole, "60 parts merge with 12 descriptors")


def damaged(bench, table):
    """(what was done, table) with a fault in its rows or at its end; the head is left alone."""
    head, rows, end = split(table)
    k = bench.random.randrange(len(rows))
    yield "a row is lost", b"".join(head + rows[:k] + rows[k + 1:] + end)
    yield "a row is there twice", b"".join(head + rows[:k] + [rows[k]] + rows[k:] + end)
    yield "it lost its end", b"".join(head + rows + end[:2])
    yield "it is cut", table[:bench.random.randrange(len(b"".join(head)), len(table))]
    yield "a count is another", b"".join(head + rows + end[:2] + [b"# complete %d\n" % (len(rows) + 1)])
    yield "all shards have more rows", b"".join(head + rows + [b"# rows-of-all-shards 9999\n"] + end[1:])
    yield "its points are others", b"".join(head + rows + end[:1] + [b"# points-checksum 0123456789abcdef\n"] + end[2:])


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
        if what not in ("another x", "another last coordinate", "its neighbour"):  # only the points tell
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
    """What cannot be continued is refused, and stays as it was."""
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

    other = b"the table of another run"
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
    refused("another point at the last row", b"its last row, 20, is not what this run makes of its point", half,
            bench.file("moved.csv", b"".join(lines[:place] + [b"p19,99,99,99,x\n"] + lines[place + 1:])))
    refused("fewer points than rows", b"has 20 rows already, more than there are points", half,
            bench.file("fewer.csv", b"".join(lines[:place])))
    refused("its own points", b"is the file the points are read from", text, bench.folder / "refused.csv", status=2)


def altered(bench, rows, at):
    """(what was done, rows) where row `at`, not the last, is no longer what the run wrote; every change is one that the
    row's point or its word tells."""
    fields = rows[at].split(b",")
    word = next(k for k, f in enumerate(fields) if k > 1 and f.strip(b"\n") and not f.strip(b"IBO\n"))
    names = {b"in": b"out", b"out": b"on", b"on": b"in"}

    def put(k, value):
        return b",".join(fields[:k] + [value + b"\n" * (k == len(fields) - 1)] + fields[k + 1:])

    pmc = next(k for k, f in enumerate(fields) if f in names)
    yield "NUL bytes", bytes(len(rows[at]) - 1) + b"\n"
    yield "one NUL byte", bytes(1) + rows[at][1:]
    yield "another x", put(0, fields[0] + b"1")
    yield "an x not in lowest terms", put(0, b"2/2" if fields[0] == b"1" else fields[0] + b"/1")
    yield "another last coordinate", put(pmc - 1, b"977")
    yield "another pmc", put(pmc, names[fields[pmc]])
    for k in range(pmc + 1, word):
        yield f"another answer {k - pmc}", put(k, b"3" if fields[k] != b"3" else b"4")
    other = b"OBO" if fields[word].strip() != b"OBO" else b"OBOBO"
    if word == pmc + 1:  # of an unsweep, where pmc alone follows from the word
        other = b"O" if fields[pmc] == b"in" else b"I"
    for value in (b"", b"OO", b"BB", b"IO", b"OBX", other):
        yield f"the word {value}", put(word, value)
    yield "a column more", rows[at][:-1] + b",1\n"
    yield "a column less", rows[at].rpartition(b",")[0] + b"\n"
    yield "a blank line", b"\n"
    yield "a comment", b"# " + rows[at]
    yield "a row more", rows[at] + rows[at]
    yield "a comment more", rows[at] + b"# between\n"
    yield "a row less", b""
    yield "its neighbour", rows[at - 1 if at else at + 1]


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
        bench.check(status == 3 and out == b"" and b"right are the points the table was begun with" in err and
                    path.read_bytes() == begun, f"the points have {what}", status, err)


def check_kept_grid(bench):
    """The same for a grid, whose points no file has; three coordinates and two."""
    for words in (["classify", COMMON / "cube.off", COMMON / "move3.json", "--grid", "4,3,5"],
                  ["classify", COMMON / "square.wkt", COMMON / "move2.json", "--grid", "6,7", "--shard", "1/2"]):
        head, rows, _ = split(bench.good(*words))
        refuse_kept(bench, lambda path: bench.run(*words, "--resume", path), words[-1], head, rows)


def check_lock(bench):
    """Two runs do not write one file."""
    words = ["classify", COMMON / "square.wkt", COMMON / "move2.json", "-", "--resume", bench.folder / "held.csv"]
    first = subprocess.Popen([bench.graze, *map(str, words)], stdin=subprocess.PIPE)
    first.stdin.write(b"1,1\n")
    first.stdin.flush()
    end = time.monotonic() + SECONDS
    while not (words[-1].exists() and b"\n1,1," in words[-1].read_bytes()) and time.monotonic() < end:
        time.sleep(0.01)
    status, _, err = bench.run(*words, stdin=b"1,1\n")
    bench.check(status == 5 and b"held.csv: another run is writing it" in err, "the second run is refused", status, err)
    first.stdin.close()
    bench.check(first.wait(SECONDS) == 0 and words[-1].read_bytes().endswith(b"\n# complete 1\n"), "the first one ends")


def check_signals(bench):
    """A run that is ended in its middle leaves whole rows, and is continued."""
    words = ["classify", COMMON / "cube.off", COMMON / "move3.json", "--grid", "60,50,40", "--jobs", 2]
    whole = bench.good(*words)
    path = bench.folder / "killed.csv"
    for which in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP, signal.SIGKILL):
        path.unlink(missing_ok=True)
        ends = told = 0
        for _ in range(40):
            child = subprocess.Popen([bench.graze, *map(str, words), "--resume", path], stderr=subprocess.PIPE)
            end = time.monotonic() + bench.random.uniform(0.02, 0.2)
            size = path.stat().st_size if path.exists() else 0
            while child.poll() is None and (time.monotonic() < end or not path.exists() or path.stat().st_size <= size):
                time.sleep(0.005)
            child.send_signal(which)
            err = child.communicate(timeout=SECONDS)[1]
            if child.returncode == 0 or path.read_bytes() == whole:
                break
            ends += 1
            text = path.read_bytes()
            rows = sum(not line.startswith(b"#") for line in text.splitlines()) - 1
            ended = b"" if which == signal.SIGKILL else b"graze: ended by %s\n" % which.name.encode()
            has = (b"graze: %s: has %d whole rows; the same command with --resume FILE continues a table\n"
                   % (os.fsencode(path), rows))
            told += err == has + ended
            bench.check(child.returncode == -which and err in (ended, has + ended),
                        f"{which.name} ends it as the shell sees it, and it says so", child.returncode, err, rows)
            bench.check(which == signal.SIGKILL or text.endswith(b"\n"), f"{which.name} leaves whole rows", text[-80:])
            bench.check(whole.startswith(text), f"{which.name} leaves a beginning of the table")
        bench.check(ends > 0, f"{which.name} came before the end")
        bench.check(told > 0 or which == signal.SIGKILL, f"{which.name}: how far it came is said")
        if path.read_bytes() != whole:
            bench.good(*words, "--resume", path)
        bench.check(path.read_bytes() == whole, f"after {which.name} the table is that of one run")


def check_ignored(bench):
    """A signal that is ignored, as under nohup, does not end a run."""
    words = ["classify", COMMON / "cube.off", COMMON / "move3.json", "-", "--output", bench.folder / "nohup.csv"]
    child = subprocess.Popen([bench.graze, *map(str, words)], stdin=subprocess.PIPE, stderr=subprocess.PIPE,
                             preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
    child.stdin.write(b"1,1,1\n")
    child.stdin.flush()
    end = time.monotonic() + SECONDS
    while not (words[-1].exists() and b"\n1,1,1," in words[-1].read_bytes()) and time.monotonic() < end:
        time.sleep(0.01)
    child.send_signal(signal.SIGHUP)
    err = child.communicate(b"2,2,2\n", timeout=SECONDS)[1]
    bench.check(child.returncode == 0 and words[-1].read_bytes().endswith(b"\n# complete 2\n"),
                "nohup is heeded", child.returncode, err)


def check_full(bench):
    """Where no more can be written, whole rows stand and can be continued; a limit of the file's size, which is
    met in the middle of a write, stands for the full disk."""
    words = [bench.graze, "classify", str(COMMON / "cube.off"), str(COMMON / "move3.json"), "--grid", "30,20,20"]
    for form in ("csv", "jsonl"):
        whole = subprocess.run([*words, "--format", form], stdout=subprocess.PIPE, check=True).stdout
        for size in (200, 1000, 65536, 65537, 65536 + 4001, len(whole) - 3):
            for how in ("--output", "--resume", ">"):
                if form == "jsonl" and how == "--resume":
                    continue
                path = bench.folder / f"full-{form}-{size}-{how.strip('-')}"
                path.write_bytes(b"")
                with open(path, "wb") as file:
                    done = subprocess.run(
                        [*words, "--format", form, *([] if how == ">" else [how, str(path)])], timeout=SECONDS,
                        stdout=file, stderr=subprocess.PIPE,
                        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, size)))
                text = path.read_bytes()
                row = max(map(len, whole.splitlines())) + 1
                bench.check(done.returncode == 5 and b"writing failed: File too large" in done.stderr,
                            "a write that fails is told", form, size, how, done.returncode, done.stderr)
                bench.check(whole.startswith(text) and text[-1:] in (b"", b"\n") and size - len(text) <= row,
                            "it leaves whole lines", form, size, how, len(text), text[-80:])
                if how == "--resume":
                    bench.good(*words[1:], "--resume", path)
                    bench.check(path.read_bytes() == whole, "and is continued", size)


def on_terminal(words):
    """What a command shows on a terminal."""
    master, slave = pty.openpty()
    child = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=slave)
    os.close(slave)
    shown = b""
    while True:
        try:
            part = os.read(master, 4096)
        except OSError:  # how Linux says that nobody holds the other end
            part = b""
        if not part:
            break
        shown += part
    os.close(master)
    return child.wait(SECONDS), shown


def check_progress(bench):
    """Per cent and time left where the end is known; nothing with --quiet."""
    words = [bench.graze, "classify", COMMON / "cube.off", COMMON / "move3.json", "--jobs", "1", "--grid", "90,90,90"]
    start = time.monotonic()
    status, shown = on_terminal(words)
    elapsed = time.monotonic() - start
    form = rb"(\d+) rows, (\d+) rows/s, (\d+) %(, \d+:\d\d:\d\d left)?\s*"
    lines = [re.fullmatch(form, line) for line in shown.strip().split(b"\r")]
    bench.check(status == 0 and all(lines), "the form of progress", shown)
    if all(lines):
        rows, parts = [int(m[1]) for m in lines], [int(m[3]) for m in lines]
        bench.check(all(p == r * 100 // 90**3 for r, p in zip(rows, parts)), "per cent are those of the rows", shown)
        # The work takes no longer than the whole run.
        bench.check(int(lines[-1][2]) >= int(90**3 / elapsed), "the rate is that of the clock", elapsed, shown)
        bench.check(len(lines) <= elapsed + 1, "at most a line a second and the last", elapsed, shown)
        bench.check(rows[-1] == 90**3 and lines[-1][4] is None, "the last line is the end", shown)
        bench.check(all(m[4] for m in lines if int(m[1]) < 90**3), "before it there is time left", shown)
    status, shown = on_terminal(words[:-1] + ["20,20,20", "--quiet"])
    bench.check((status, shown) == (0, b""), "--quiet shows nothing", status, shown)


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
        refused(f"byte {k} is another", b"is no receipt of graze check")
    receipt.write_bytes(content[:-9])
    refused("it is cut", b"is no receipt of graze check")
    receipt.unlink()
    crossed = bench.file("crossed.off", cube.read_bytes().replace(b"2 2 2", b"2 2 -1"))
    status, _, _ = bench.run("check", "--receipt", receipt, crossed, move)
    bench.check(status == 1 and not receipt.exists(), "there is no receipt for an illegal solid", status)


def check_parallel(bench):
    """The recipe for GNU parallel."""
    if not shutil.which("parallel"):
        bench.skip("parallel", "GNU parallel is not installed")
        return
    points = bench.file("spread.csv", random_points(bench.random, 300, 3))
    scene = f"{COMMON / 'cube.off'} {COMMON / 'move3.json'} {points}"
    whole = bench.good("classify", *scene.split())
    done = subprocess.run(f"parallel -j 2 {bench.graze} classify --jobs 1 --shard {{}}/6 --resume spread-{{}}.csv "
                          f"{scene} ::: 1 2 3 4 5 6 && {bench.graze} merge spread-*.csv", shell=True, timeout=SECONDS,
                          cwd=bench.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          env=dict(os.environ, HOME=str(bench.folder)))
    bench.check(done.returncode == 0, "parallel runs six shards", done.stderr)
    bench.check(done.stdout.endswith(whole), "six shards of parallel merge into the whole", done.stdout[:300])


CHECKS = [check_shards, check_many_parts, check_damage, check_resume, check_resume_refusals, check_kept_rows,
          check_kept_grid, check_lock,
          check_signals, check_ignored, check_full, check_progress, check_receipts,
          check_parallel]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--graze", default="build/graze")
    parser.add_argument("--scale", type=int, default=1)
    parser.add_argument("--seed", type=int, default=1)
    words = parser.parse_args()
    print(f"seed {words.seed}")
    with tempfile.TemporaryDirectory(prefix="graze-shards-") as folder:
        bench = Bench(os.path.abspath(words.graze), folder, words.scale, words.seed)
        for check in CHECKS:
            start = time.monotonic()
            check(bench)
            print(f"{check.__name__}: {time.monotonic() - start:.1f} s")
    print(f"{bench.passed} passed, {bench.failed} failed, {bench.skipped} skipped")
    return bench.failed > 0


if __name__ == "__main__":
    raise SystemExit(main())
