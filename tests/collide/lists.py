#!/usr/bin/env python3
# suite
"""`graze collide --list`: rows by hand, as a process for each pair has them, with options, faults, threads, shards, --resume.

A unit cube goes by 5 - t along x, or stands; another is at the origin. Their faces meet at t = 4, their interiors until t = 6: word OBIBO.
Beside it by 1 they never meet; at clearance 1/2 the first time is 7/2. It is inside a room from -2 to 8 until it touches the wall at t = 7,
and leaves it at the end, t = 8. With the other one moving along by (1 - t) it is 4 away at all times. SPDX-License-Identifier: GPL-3.0-or-later
"""
import csv
import io
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import threading
import time
from fractions import Fraction

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

from harness import ROOT, Checks, options, run  # noqa: E402

sys.path[:0] = [os.path.join(ROOT, "cases", name) for name in ("contacts", "benchmark")]

import golden  # noqa: E402

FACETS = ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3))
HEAD = "id,moving,motion,fixed,motion_of_fixed,clearance,inside,verdict,weight\n"
# Fields of the list; word, first contact and status with the options' defaults; word with --first; why there is no answer.
ROWS = [
    ('"a, b",solids/one.off,go.json,solids/one.off,,,,x,1', "OBIBO", "4", 1, "OBI", ""),
    ("aside,solids/one.off,go.json,solids/aside.off,,,,,2", "O", "", 0, "O", ""),
    ("near,solids/one.off,go.json,solids/one.off,,1/2,,,", "OBIBO", "7/2", 1, "OBI", ""),
    ("room,solids/one.off,go.json,solids/room.off,,,yes,,", "OBI", "7", 1, "OBI", ""),
    ("not inside,solids/one.off,go.json,solids/room.off,,,no,,", "IB", "0", 1, "I", ""),
    ("along,solids/one.off,go.json,solids/one.off,along.json,,,,", "O", "", 0, "O", ""),
    ("none,solids/none.off,go.json,solids/one.off,,,,,", "", "", 5, "", "none.off"),
    ("open,solids/open.off,go.json,solids/one.off,,,,,", "", "", 3, "", "open.off"),
    ("open too,solids/one.off,go.json,solids/open.off,,,,,", "", "", 3, "", "open.off"),
    ("below,solids/one.off,go.json,solids/one.off,,-1,,,", "", "", 3, "", "clearance -1: expected a number from 0 up"),
    ("word,solids/one.off,go.json,solids/one.off,,wide,,,", "", "", 3, "", "wide"),
    ("maybe,solids/one.off,go.json,solids/one.off,,,maybe,,", "", "", 3, "", "inside: maybe: expected yes or no"),
    ("empty,,go.json,solids/one.off,,,,,", "", "", 3, "", "moving: is empty; expected a file"),
    ("plane,solids/one.off,flat.json,solids/one.off,,,,,", "", "", 3, "", "expected one dimension"),
]


def off(low, high):
    corners = [(x, y, z) for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2])]
    return "OFF\n8 6 0\n" + "".join(" ".join(map(str, words)) + "\n" for words in [*corners, *((4, *facet) for facet in FACETS)])


def motion(*translate, dimension=3):
    return json.dumps({"dimension": dimension, "pieces": [{"t": [0, 8], "transform": {"translate": list(translate)}}]})


def write(folder):
    solids = folder / "solids"
    solids.mkdir()
    one = off((0, 0, 0), (1, 1, 1))
    (solids / "one.off").write_text(one)
    (solids / "aside.off").write_text(off((0, 2, 0), (1, 3, 1)))
    (solids / "room.off").write_text(off((-2, -1, -1), (8, 2, 2)))
    (solids / "open.off").write_text(one.replace("8 6 0", "8 5 0").rsplit("\n", 2)[0] + "\n")
    (folder / "go.json").write_text(motion("5 - t", 0, 0))
    (folder / "along.json").write_text(motion("1 - t", 0, 0))
    (folder / "flat.json").write_text(motion("t", 0, dimension=2))
    put(folder / "list.csv", ROWS)


def put(path, rows, head=HEAD):
    path.write_text(head + "".join(row[0] + "\n" for row in rows))


def read(text):
    return list(csv.DictReader(line for line in io.StringIO(text) if not line.startswith("#")))


def ask(graze, folder, *words, **more):
    return run([graze, "collide", "--list", *words], cwd=folder, **more)


def check_rows(checks, graze, folder):
    """The rows by hand, and with --first; carried columns, a name that the table has."""
    for first in ([], ["--first"]):
        done = ask(graze, folder, "list.csv", *first)
        rows = read(done.stdout)
        checks.equal((done.returncode, len(rows)), (3, len(ROWS)), first, done.stderr)
        checks.holds("8 of 14 rows have no answer" in done.stderr and "verdict_in" in done.stderr, done.stderr)
        checks.equal(list(rows[0]), ["id", "verdict_in", "weight", "verdict", "word", "first", "first_near", *(["next"] if first else []), "cells",
                                     "status", "message"])
        for row, (line, word, time, status, short, why) in zip(rows, ROWS):
            checks.equal((row["word"], row["first"], row["status"]), (short if first else word, time, str(status)), line, first)
            checks.holds(why in row["message"] if why else row["message"] == "", line, row["message"])
            checks.equal((row["id"], row["weight"]), (next(csv.reader([line]))[0], line.split(",")[-1]), line)
        checks.equal([rows[0]["verdict_in"], rows[1]["verdict_in"]], ["x", ""])
        checks.holds(done.stdout.endswith(f"\n# complete {len(ROWS)}\n"), done.stdout[-40:])


def check_alone(checks, graze, folder):
    """A process for each pair says the same, in both forms, and has the row's status."""
    for first in ([], ["--first"]):
        table = read(ask(graze, folder, "list.csv", *first).stdout)
        objects = [json.loads(line) for line in ask(graze, folder, "list.csv", "--format", "jsonl", *first).stdout.splitlines()]
        checks.equal(len(objects), len(ROWS))
        for (line, *_), row, found in zip(ROWS, table, objects):
            given = dict(zip(HEAD.strip().split(","), next(csv.reader([line]))))
            words = [given["moving"], given["motion"], given["fixed"], "--format", "json", *first]
            words += ["--motion-of-fixed", given["motion_of_fixed"]] if given["motion_of_fixed"] else []
            words += ["--clearance", given["clearance"]] if given["clearance"] else []
            words += ["--inside"] if given["inside"] == "yes" else []
            checks.equal(found["id"], given["id"])
            if "verdict" not in found:
                checks.equal((str(found["status"]), found["message"]), (row["status"], row["message"]), line)
                continue
            done = run([graze, "collide", *words], cwd=folder)
            alone = json.loads(done.stdout)
            checks.equal({**found, "id": ""}, {**alone, "id": ""}, line)
            checks.equal(row["status"], str(done.returncode), line)
            want = golden.row_of(json.dumps({"id": given["id"], **alone}))
            got = [row[name] for name in golden.COLUMNS]
            checks.equal(got[:4] + got[5:], want[:4] + want[5:], line)
            checks.holds(got[4] == want[4] or float(got[4]) == float(want[4]), got[4], want[4])
            checks.equal(row.get("next", ""), alone.get("next") or "", line)


def check_runs(checks, graze, folder):
    """Threads, shards, a table that is continued: the bytes of one run."""
    put(folder / "long.csv", [row for k in range(12) for row in ROWS])
    whole = ask(graze, folder, "long.csv", "--jobs", "1")
    checks.equal(whole.returncode, 3, whole.stderr)
    checks.equal(ask(graze, folder, "long.csv").stdout, whole.stdout)
    for k in (1, 2, 3):
        done = ask(graze, folder, "long.csv", "--shard", f"{k}/3", "-o", f"part{k}.csv")
        checks.equal(done.returncode, 3, done.stderr)
    done = run([graze, "merge", "part2.csv", "part1.csv", "part3.csv"], cwd=folder)
    checks.equal((done.returncode, done.stdout), (0, whole.stdout), done.stderr)
    cut = whole.stdout.split("\n")
    (folder / "begun.csv").write_text("\n".join(cut[:40]) + "\n" + cut[40][:9])
    done = ask(graze, folder, "long.csv", "--resume", "begun.csv")
    checks.equal((done.returncode, (folder / "begun.csv").read_text()), (3, whole.stdout), done.stderr)
    done = ask(graze, folder, "long.csv", "--resume", "begun.csv")
    checks.holds(done.returncode == 3 and "is complete" in done.stderr, done.stderr)
    (folder / "begun.csv").write_text("\n".join(cut[:40]) + "\n")
    done = ask(graze, folder, "long.csv", "--resume", "begun.csv", "--first")
    checks.holds(done.returncode == 3 and "# first yes" in done.stderr, done.returncode, done.stderr)
    checks.equal((folder / "begun.csv").read_text(), "\n".join(cut[:40]) + "\n")


def check_bytes(checks, graze, folder):
    """A run is ended behind four rows. Another of their files refuses the rest, one that they do not name does not."""
    put(folder / "six.csv", ROWS[:6])
    lines = (folder / "six.csv").read_text().splitlines(keepends=True)
    whole = ask(graze, folder, "six.csv").stdout
    for name, same in (("solids/aside.off", False), ("go.json", False), ("along.json", True)):
        begun, before = folder / "ended.csv", (folder / name).read_text()
        child = subprocess.Popen([graze, "collide", "--list", "-", "--resume", str(begun)], cwd=folder, stdin=subprocess.PIPE,
                                 stderr=subprocess.DEVNULL, text=True)
        child.stdin.write("".join(lines[:5]))
        child.stdin.flush()
        end = time.monotonic() + 60
        while (not begun.exists() or begun.read_text().count("\n") < whole.count("\n") - 3) and time.monotonic() < end:
            time.sleep(0.01)
        child.send_signal(signal.SIGTERM)
        child.wait()
        child.stdin.close()
        kept = begun.read_text()
        (folder / name).write_text(before + "\n")
        done = ask(graze, folder, "six.csv", "--resume", str(begun))
        if same:
            checks.equal((done.returncode, begun.read_text()), (1, whole), name, done.stderr)
        else:
            checks.equal((done.returncode, begun.read_text()), (3, kept), name)
            checks.holds("its first 4 rows are of other pairs or files" in done.stderr, done.stderr)
        (folder / name).write_text(before)
        done = done if same else ask(graze, folder, "six.csv", "--resume", str(begun))
        checks.equal((done.returncode, begun.read_text()), (1, whole), name, "as before", done.stderr)
        begun.unlink()


def check_outputs(checks, graze, folder):
    """A file that a row names, directly or by a link, is not written."""
    os.symlink("one.off", folder / "solids" / "same.off")
    put(folder / "short.csv", ROWS[:1])
    with open(folder / "short.csv", "a", encoding="utf-8") as file:
        file.write("too short\ntoo short\n")
    for name, *words in (("long.csv", "-o", "go.json"), ("long.csv", "--resume", "solids/aside.off"), ("long.csv", "-o", "solids/same.off"),
                         ("short.csv", "-o", "go.json")):
        kept = (folder / words[1]).read_bytes()
        done = ask(graze, folder, name, *words)
        checks.equal((done.returncode, (folder / words[1]).read_bytes()), (2, kept), words, done.stderr)
        checks.holds("which is read; expected another file" in done.stderr, words, done.stderr)
    (folder / "solids" / "same.off").unlink()


def check_ends(checks, graze, folder):
    """Exit status; options for all rows; a list from standard input; rows without id."""
    for rows, words, status in ((ROWS[1:2], [], 0), (ROWS[:2], [], 1), (ROWS[:3], ["--ask", "overlap"], 1), (ROWS[5:7], [], 3), ([], [], 0)):
        put(folder / "few.csv", rows)
        done = ask(graze, folder, "few.csv", *words)
        checks.equal((done.returncode, len(read(done.stdout))), (status, len(rows)), words, done.stderr)
    text = "fixed,moving,motion\n" + 2 * "solids/one.off,solids/one.off,go.json\n"
    done = ask(graze, folder, "-", "--clearance", "1/2", input=text)
    checks.equal([(row["id"], row["first"], row["word"]) for row in read(done.stdout)], [("1", "7/2", "OBIBO"), ("2", "7/2", "OBIBO")], done.stderr)
    done = ask(graze, folder, "-", "--motion-of-fixed", "along.json", input=text)
    checks.equal((done.returncode, [row["word"] for row in read(done.stdout)]), (0, ["O", "O"]), done.stderr)
    done = ask(graze, folder, "-", "--inside", input=text.replace("solids/one.off,s", "solids/room.off,s"))
    checks.equal([row["word"] for row in read(done.stdout)], ["OBI", "OBI"], done.stderr)


def check_once(checks, graze, folder):
    """A solid that several rows name is read once: it is a pipe."""
    fifo = folder / "solids" / "pipe.off"
    os.mkfifo(fifo)
    put(folder / "pipe.csv", [("solids/pipe.off,go.json,solids/pipe.off",)] * 9, "moving,motion,fixed\n")
    thread = threading.Thread(target=fifo.write_text, args=(off((0, 0, 0), (1, 1, 1)),), daemon=True)
    thread.start()
    done = ask(graze, folder, "pipe.csv", "--jobs", "4")
    checks.equal((done.returncode, [row["word"] for row in read(done.stdout)]), (1, ["OBIBO"] * 9), done.stderr)
    thread.join(1)


# The gap of both cubes is 4 - t, their depth the negative of it up to 1/2: R + ETA and R - ETA, or ETA - R below.
ERRORS = [("1/4,,", "15/4", "17/4"), (",,", "4", "4"), ("1/4,1/8,", "29/8", "33/8"), ("1/8,1/4,", "29/8", "31/8"), ("1,,no", "3", ""), ("1/4,,yes", None, "without"),
          ("-1,,", None, "below 0"), ("x,,", None, "x")]


def check_errors(checks, graze, folder):
    """The columns low and high; the option where a row has no error; those that never meet."""
    lines = [(f"{given},solids/one.off,go.json,solids/one.off",) for given, _, _ in ERRORS] + [("1/4,,,solids/one.off,go.json,solids/aside.off",)]
    put(folder / "errors.csv", lines, "motion_error,clearance,inside,moving,motion,fixed\n")
    done = ask(graze, folder, "errors.csv")
    rows = read(done.stdout)
    checks.equal((done.returncode, list(rows[0])), (3, ["id", "low", "low_near", "high", "high_near", "status", "message"]), done.stderr)
    for (given, low, high), row in zip(ERRORS, rows):
        if low is None:
            checks.holds(row["low"] == row["high"] == "" and row["status"] == "3" and row["message"], given, row)
        else:
            checks.equal((row["low"], row["high"], row["status"], row["message"]), (low, high, "1", ""), given)
            checks.equal(float(row["low_near"]), float(Fraction(low)), given)
    checks.equal((rows[-1]["low"], rows[-1]["high"], rows[-1]["status"]), ("", "", "0"))
    put(folder / "few.csv", [("solids/one.off,go.json,solids/one.off",)], "moving,motion,fixed\n")
    done = ask(graze, folder, "few.csv", "--motion-error", "1/4")
    checks.holds("\n# motion-error 1/4\n" in done.stdout and [(row["low"], row["high"]) for row in read(done.stdout)] == [("15/4", "17/4")], done.stdout)
    done = ask(graze, folder, "few.csv", "--motion-error", "1/4", "--format", "jsonl")
    checks.equal(json.loads(done.stdout)["first"]["high"], "17/4", done.stderr)


def check_many(checks, graze, folder):
    """More bytes of files than stay in memory, each file twice: in turn, and at once by threads. Cube k is wider by k on its far side."""
    many = folder / "many"
    many.mkdir()
    for k in range(9):
        (many / f"{k}.off").write_text(off((-k, 0, 0), (1, 1, 1)) + 2 ** 17 * ("#" + 78 * " " + "\n"))
    put(folder / "many.csv", [(f"solids/one.off,go.json,many/{k}.off",) for k in 2 * list(range(9))], "moving,motion,fixed\n")
    for jobs in ("1", "2"):
        done = ask(graze, folder, "many.csv", "--first", "--jobs", jobs)
        checks.equal([row["first"] for row in read(done.stdout)], 18 * ["4"], done.stderr)


def main():
    chosen, checks = options(__doc__), Checks()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        write(folder)
        for check in (check_rows, check_alone, check_runs, check_bytes, check_outputs, check_ends, check_once, check_errors, check_many):
            check(checks, chosen.graze, folder)
    checks.finish()


if __name__ == "__main__":
    main()
