#!/usr/bin/env python3
# suite
"""Certificates of shards merge, interrupted ones are continued, and classify --certify writes both files of one run.

Every expected certificate is the one that a single run writes by one thread, which graze-check verifies.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import signal
import subprocess
import time

from bench import COMMON, SECONDS, harness, random_points, run_checks, sealed, split

CUBE, SQUARE = [COMMON / "cube.off", COMMON / "move3.json"], [COMMON / "square.wkt", COMMON / "move2.json"]


def scenes(bench):
    """(name, the words for the scene and the points)."""
    yield "cube", [*CUBE, bench.file("points.csv", random_points(bench.random, 120 * bench.scale, 3))]
    yield "square", [*SQUARE, bench.file("flat.csv", random_points(bench.random, 40, 2)), "--folds", "combined"]
    yield "unsweep", [*SQUARE, bench.folder / "flat.csv", "--operation", "unsweep"]
    yield "contacts", [*CUBE, bench.folder / "points.csv", "--times"]
    yield "no points", [*SQUARE, bench.file("none.csv", b"x,y\n")]


EXACT = ["--coordinates", "exact"]  # as the table beside a certificate is


def plain(words):
    """The words for a table with the bytes of one beside a certificate."""
    return [word for word in words if word != "--times"] + EXACT


def cut(certificate):
    """(head, rows, end): head and end are lists of lines, a row the lines of its own in one."""
    lines = certificate.splitlines(keepends=True)
    rows, first = [], next(k for k, line in enumerate(lines) if line.startswith(b"signs ")) + 1
    last = next(k for k, line in enumerate(lines) if k >= first and line[:1].islower() and not line.startswith((b"row ", b"contact ")))
    for line in lines[first:last]:
        if line.startswith(b"row "):
            rows.append(line)
        else:
            rows[-1] += line
    return lines[:first], rows, lines[last:]


def check_whole(bench):
    """Any number of threads, and classify beside its table, write the same certificate; it is verified."""
    for name, words in scenes(bench):
        whole = bench.good("certify", *words, "--jobs", "1")
        bench.check(bench.good("certify", *words, "--jobs", "3") == whole, f"{name}: three threads")
        path = bench.file("whole.txt", whole)
        done = harness.run([bench.graze + "-check", *words[:2], path], SECONDS, env=harness.without_leaks())
        count = len(cut(whole)[1])
        bench.check((done.returncode, done.stdout) == (0, f"verified: {count} rows\n"), f"{name}: verified", done.stderr)
        beside = bench.folder / "beside.txt"
        for more in (["--format", "csv"], ["--format", "jsonl"], ["--format", "npy"], ["--topo"]):
            forms = plain(words) if more[-1] in ("csv", "--topo") else plain(words)[:-len(EXACT)]
            _, table, note = bench.run("classify", *forms, *more)
            status, both, its_note = bench.run("classify", *words, *more, "--certify", beside)
            bench.check((status, both, its_note) == (0, table, note) and beside.read_bytes() == whole, f"{name}: with a table {more}")


def check_shards(bench):
    """Certificates of shards have every n-th row, and merge into that of one run; so do the tables beside them."""
    for name, words in scenes(bench):
        whole, table = bench.good("certify", *words), bench.good("classify", *plain(words))
        head, rows, _ = cut(whole)
        for count in (1, 2, 5):
            parts, tables = [], []
            for index in range(1, count + 1):
                shard = ["--shard", f"{index}/{count}"]
                parts.append(bench.folder / f"part-{index}.txt")
                tables.append(bench.folder / f"part-{index}.csv")
                bench.good("certify", *words, *shard, "-o", parts[-1])
                alone = parts[-1].read_bytes()
                bench.good("classify", *words, *shard, "-o", tables[-1], "--certify", parts[-1])
                bench.check(parts[-1].read_bytes() == alone, f"{name}: shard {index}/{count} beside its table")
                its_head, its_rows, end = cut(alone)
                its_head.remove(f"shard {index}/{count}\n".encode())
                bench.check((its_head, its_rows) == (head, rows[index - 1::count]), f"{name}: shard {index}/{count}")
                bench.check(end[0] == b"rows-of-all-shards %d\n" % len(rows) and len(end) == 4 and
                            sealed([alone[:-len(end[2] + end[3])]], len(its_rows), b"") == alone,
                            f"{name}: end of {index}/{count}", end)
                done = harness.run([bench.graze + "-check", *words[:2], parts[-1]], SECONDS, env=harness.without_leaks())
                bench.check(done.returncode != 0, f"{name}: a shard is no certificate", done.stdout)
            bench.random.shuffle(parts)
            bench.check(bench.good("merge", *parts) == whole, f"{name}: {count} certificates merge into the whole")
            bench.check(bench.good("merge", *tables) == table, f"{name}: {count} tables merge into the whole")


def check_resumed(bench):
    """A certificate that was cut anywhere becomes that of one run."""
    for name, words in scenes(bench):
        for more in ([], ["--shard", "2/3"]):
            whole = bench.good("certify", *words, *more)
            head = len(b"".join(cut(whole)[0]))
            for at in {0, 1, head - 1, head, *(bench.random.randrange(len(whole)) for _ in range(12 * bench.scale))}:
                path = bench.file("resumed.txt", whole[:at])
                bench.good("certify", *words, *more, "--resume", path)
                bench.check(path.read_bytes() == whole, f"{name} {more}: continued from byte {at} of {len(whole)}")


def check_resumed_pair(bench):
    """Table and certificate of one interrupted run, the certificate ahead, are continued together."""
    for name, words in scenes(bench):
        whole, table = bench.good("certify", *words), bench.good("classify", *plain(words))
        head, rows, _ = split(table)
        starts = [len(b"".join(cut(whole)[0] + cut(whole)[1][:k])) for k in range(len(rows) + 1)]
        for turn in range(12 * bench.scale):
            begun = table[:bench.random.randrange(len(table))]
            count = max(0, begun.count(b"\n") - len(head))
            count = min(count, len(rows))
            ahead = bench.random.randrange(starts[count] if count else 0, len(whole) + 1) if turn else len(whole)
            paths = bench.file("both.csv", begun), bench.file("both.txt", whole[:ahead])
            bench.good("classify", *words, "--resume", paths[0], "--certify", paths[1])
            bench.check((paths[0].read_bytes(), paths[1].read_bytes()) == (table, whole), f"{name}: from {len(begun)} bytes")


def altered(row):
    """(what was done, row): a row of a sweep that no run of these points writes, by its point, its word or its form."""
    lines = row.splitlines(keepends=True)
    words = lines[0].split(b" ")
    for k, what in ((1, b"971"), (3, b"971"), (4, b"OBIBOBIBOBIBO"), (4, b"X"), (5, b"none"), (8, b"99"), (10, b"99\n"), (11, b"99\n")):
        if k < len(words) and words[k].rstrip() != what.rstrip():
            yield f"field {k} is {what}", b" ".join(words[:k] + [what] + words[k + 1:]) + b"".join(lines[1:])
    yield "a field more", lines[0][:-1] + b" 1\n" + b"".join(lines[1:])
    yield "no intervals", lines[0]
    yield "the last interval is lost", b"".join(lines[:-1])
    yield "the last interval is there twice", b"".join(lines + lines[-1:])
    yield "a blank line", lines[0] + b"\n" + b"".join(lines[1:])
    yield "a note", lines[0] + b"note\n" + b"".join(lines[1:])
    yield "another letter", lines[0] + (b"I" if words[4] != b"I" else b"O") + lines[1][1:] + b"".join(lines[2:])
    yield "a letter that is none", lines[0] + b"X" + lines[1][1:] + b"".join(lines[2:])
    yield "a letter twice", lines[0] + 2 * words[4][:1] + b" 1/1024\n" + b"".join(lines[1:])
    if not words[4].startswith(b"B"):  # BBB is an interval
        yield "a letter three times", lines[0] + 3 * words[4][:1] + b" 1/1024 1 1\n" + b"".join(lines[1:])
    yield "a fraction in a polynomial", lines[0] + words[4][:1] + b"B" + words[4][:1] + b" 1/1024 1/2 1\n" + b"".join(lines[1:])
    yield "intervals that end before the word", lines[0] + words[4][:1] + b" 1\n"
    yield "a time that is none", lines[0] + words[4][:1] + b" 1/0\n" + b"".join(lines[1:])
    yield "a polynomial where none is", b"".join(lines[:-1]) + lines[-1][:-1] + b" 1 1\n"
    yield "a polynomial of one coefficient", lines[0] + words[4][:1] + b"B" + words[4][:1] + b" 1/1024 1\n" + b"".join(lines[1:])
    yield "a row without its word", b"row 1 1 1\n" + b"".join(lines[1:])


def altered_contacts(row):
    lines = row.splitlines(keepends=True)
    for k, line in enumerate(lines):
        if line.startswith(b"contact "):
            yield "a contact is lost", b"".join(lines[:k] + lines[k + 1:])
            yield "a contact is there twice", b"".join(lines[:k] + [line] + lines[k:])
            yield "a contact is early", b"".join(lines[:k - 1] + [line, lines[k - 1]] + lines[k + 1:])
            for other in (b"contact \n", b"contact\n", line[:-1] + b" x\n", b"contact 1/1 face 0\n", line[:-1] + b" \n", line[:-1] + b" 1-\n"):
                yield f"a contact is {other}", b"".join(lines[:k] + [other] + lines[k + 1:])


def check_altered(bench):
    """A row that was changed is refused, where a certificate is continued and where parts are merged; no file changes."""
    points = bench.file("near.csv", b"".join(b"%d,%d,1\n" % (k % 7, k // 7) for k in range(28)))
    for words, changes in (([*CUBE, points], altered), ([*CUBE, points, "--times"], altered_contacts)):
        check_changes(bench, words, changes)


def check_changes(bench, words, changes):
    head, rows, _ = cut(bench.good("certify", *words))
    at = next(k for k, row in enumerate(rows) if k > 3 and row.count(b"\n") > 3 and b" 1\n" in row)
    parts = [bench.file(f"good-{k}.txt", bench.good("certify", *words, "--shard", f"{k}/2")) for k in (1, 2)]
    its_head, its_rows, its_end = cut(parts[1].read_bytes())
    place = next(k for k, row in enumerate(its_rows) if row.count(b"\n") > 3)
    for what, row in changes(rows[at]):
        begun = b"".join(head + rows[:at] + [row] + rows[at + 1:at + 9])
        path = bench.file("altered.txt", begun)
        status, _, err = bench.run("certify", *words, "--resume", path)
        bench.check(status == 3 and path.read_bytes() == begun and b"altered.txt:" in err, f"not continued: {what}", status, err)
    for what, row in changes(its_rows[place]):
        bad = bench.file("bad.txt", b"".join(its_head + its_rows[:place] + [row] + its_rows[place + 1:] + its_end))
        status, out, err = bench.run("merge", parts[0], bad)
        bench.check(status == 3 and b"complete" not in out and b"bad.txt" in err, f"not merged: {what}", status, err)
    last = b"".join(head + rows[:at] + [rows[at].replace(b"\n", b"\n" + rows[at][4:5] + b" 1/512\n", 1)])
    path = bench.file("altered.txt", last)
    status, _, err = bench.run("certify", *words, "--resume", path)
    bench.check(status == 3 and path.read_bytes() == last, "not continued: another last row", status, err)


def check_refused(bench):
    """Files that do not belong together."""
    words = next(scenes(bench))[1]
    whole, table = bench.good("certify", *words), bench.good("classify", *words, *EXACT)
    head, rows, _ = cut(whole)

    def refused(status, says, *given):
        got, out, err = bench.run(*given)
        bench.check(got == status and says in err and b"complete" not in out, f"refused: {says}", got, err, given)

    path = bench.file("done.txt", whole)
    refused(3, b"is complete with its %d rows; expected an interrupted certificate" % len(rows), "certify", *words, "--resume", path)
    begun = bench.file("begun.csv", b"".join(split(table)[0] + split(table)[1][:9]))
    fewer = bench.file("fewer.txt", b"".join(head + rows[:8]))
    bench.good("classify", *words, "--resume", begun, "--certify", fewer)
    bench.check((begun.read_bytes(), fewer.read_bytes()) == (table, whole), "a certificate behind its table is continued")
    fewer = bench.file("fewer.txt", b"".join(head + rows[:8]))
    refused(3, b"expected a certificate of this run", "certify", *words, "--folds", "combined", "--resume", fewer)
    parts = [bench.file(f"mixed-{k}", bench.good(c, *words, "--shard", f"{k}/2")) for k, c in ((1, "certify"), (2, "classify"))]
    refused(3, b"expected parts of one run", "merge", *parts)
    refused(3, b"has no line `shard i/n` in its head; expected a certificate of graze certify --shard i/n", "merge", path)
    part = parts[0].read_bytes()
    refused(3, b"does not end with `bytes-checksum` and `complete`: the run was interrupted, or an older graze made it; "
            b"graze certify --resume continues it", "merge",
            bench.file("cut.txt", part[:part.rindex(b"complete")]))
    other = bench.file("other.txt", bench.good("certify", *words, "--shard", "2/2"))
    refused(3, b"expected parts of one run", "merge", bench.file("cut.txt", part.replace(b"dimension 3\n", b"")), other)
    refused(3, b"was changed", "merge", bench.file("cut.txt", part.replace(b"\nrow ", b"\nrow 1", 1)), other)
    refused(2, b"which is written; expected another file", "classify", *words, "-o", bench.folder / "one",
            "--certify", bench.folder / "one")
    refused(2, b"which is read; expected another file", "classify", *words, "--certify", words[2])
    refused(2, b"expected no rounding", "classify", *words, "--round", "binary64", "--certify", bench.folder / "one")
    refused(2, b"was not triangulated", "classify", *words, "--triangulate", "--certify", bench.folder / "one")
    refused(2, b"expected no --output beside it", "certify", *words, "--resume", path, "-o", bench.folder / "one")
    cube = bench.file("cube.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n")
    refused(3, b"graze-check does not read it", "certify", cube, *words[1:])


def check_bad_point(bench):
    """Both files end before a row that cannot be read."""
    points = bench.file("bad.csv", b"x,y,z\n5,1,1\n5,1,2\n5,1\n2,1,1\n")
    paths = bench.folder / "bad-table.csv", bench.folder / "bad-certificate.txt"
    status, _, err = bench.run("classify", *CUBE, points, "-o", paths[0], "--certify", paths[1])
    bench.check(status == 3 and b"bad.csv:4" in err and err.count(b"\n") == 1, "the row is named once", status, err)
    good = bench.file("good.csv", b"x,y,z\n5,1,1\n5,1,2\n")
    wanted = [bench.good("classify", *CUBE, good, *EXACT), bench.good("certify", *CUBE, good)]
    for path, whole in zip(paths, wanted):
        bench.check(path.read_bytes() == whole[:whole.rindex(b"complete")].removesuffix(b"# "), f"{path.name} has two rows")


def check_signals(bench):
    """A run that is ended leaves a beginning of both files, and is continued."""
    words = ["classify", *CUBE, "--grid", "26,26,26", "--jobs", "2"]
    whole, beside = bench.folder / "grid.txt", bench.folder / "killed.txt"
    table = bench.good(*words, "--certify", whole)
    path = bench.folder / "killed.csv"
    for which in (signal.SIGINT, signal.SIGKILL):
        for left in (path, beside):
            left.unlink(missing_ok=True)
        child = subprocess.Popen([bench.graze, *map(str, words), "--resume", path, "--certify", beside],
                                 stderr=subprocess.PIPE, preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))
        end = time.monotonic() + SECONDS
        while child.poll() is None and time.monotonic() < end and not (path.exists() and path.stat().st_size > 20000):
            time.sleep(0.002)
        child.send_signal(which)
        err = child.communicate(timeout=SECONDS)[1]
        bench.check(child.returncode == -which, f"{which.name} came before the end", child.returncode)
        bench.check(table.startswith(path.read_bytes()) and whole.read_bytes().startswith(beside.read_bytes()),
                    f"{which.name} leaves the beginnings")
        if which == signal.SIGINT:
            count = path.read_bytes().count(b"\n") - len(split(table)[0])
            bench.check(b"killed.csv: has %d whole rows; the same command with --resume FILE continues a table\n" % count in err and
                        b"killed.txt: has %d whole rows; the same command with --resume FILE continues a certificate\n" % count in err,
                        "both say how far they have come", err)
        bench.good(*words, "--resume", path, "--certify", beside)
        bench.check(path.read_bytes() == table and beside.read_bytes() == whole.read_bytes(), f"after {which.name} both are whole")


if __name__ == "__main__":
    run_checks(__doc__, [check_whole, check_shards, check_resumed, check_resumed_pair, check_altered, check_refused,
                         check_bad_point, check_signals])
