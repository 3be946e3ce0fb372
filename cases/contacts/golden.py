#!/usr/bin/env python3
"""Exact answers for the pairs of pairs.py, and their hashes.

    python3 cases/contacts/golden.py --graze build/graze OUT [--count N] [--record]

Makes OUT/pairs.csv with its solids and motions, asks `graze collide --list` about them, and writes OUT/golden.csv and
OUT/golden.jsonl, in the order of the pairs. Pairs are not made again, and families that are whole not asked again, so that a run
that was ended is continued, unless program or makers have changed. Each family's answers are hashed and compared with hashes.txt, of its first ten pairs too; --record writes it
instead. Exit status 1: a hash differs, or an answer is not the known one.
SPDX-License-Identifier: CC0-1.0
"""
import argparse
import csv
import hashlib
import json
import os
import signal
import subprocess
import sys

import pairs

HERE = os.path.dirname(os.path.abspath(__file__))
HASHES = os.path.join(HERE, "hashes.txt")
COLUMNS = ("id", "verdict", "word", "first", "first_near", "cells")
FEW = 10  # pairs of a family that a test asks


def read_pairs(out):
    with open(os.path.join(out, "pairs.csv"), encoding="ascii", newline="") as file:
        return list(csv.DictReader(file))


def ask(graze, path):
    """The answers about the pairs of a list: the text of a JSON object on one line for each."""
    done = subprocess.run([graze, "collide", "--list", path, "--format", "jsonl", "--quiet", "--jobs", str(os.cpu_count())], check=False, stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    if done.returncode not in (0, 1):
        raise SystemExit(f"{path}: graze collide, status {done.returncode}: {done.stderr.strip()}")
    return [json.dumps(json.loads(line)) for line in done.stdout.splitlines()]


def near(time):
    return float(pairs.F(time)) if isinstance(time, str) else float(time["approx"])


def named(cell):
    """A cell as graze collide's text has it."""
    kind, number = next(iter(cell.items()))
    return f"{kind} {'-'.join(map(str, number)) if kind == 'edge' else number}"


def row_of(line):
    """The row of the table: the first contact's time exactly, a ratio or root(c0 c1 ...;a;b), a double near it, and its cells."""
    found = json.loads(line)
    first = found["first"]
    time = first and first["from"]
    text = "" if not first else time if isinstance(time, str) else f"root({' '.join(time['poly'])};{time['lo']};{time['hi']})"
    cells = "; ".join(f"{named(cell['moving'])} with {named(cell['fixed'])}" for cell in first["cells"]) if first else ""
    return [found["id"], found["verdict"], found["word"], text, repr(near(time)) if first else "", cells]


def is_known(pair, row):
    """Is the answer the one that the pair was made for?"""
    known, word = pair["known"], row[2]
    right = not known or (word.startswith(known[:-1]) if known.endswith("+") else word == known)
    return right and (not pair["known_first"] or row[3] == pair["known_first"])


def digest(rows):
    """SHA-256 of the answers; of an irrational time its polynomial and the nearest double, since any interval that holds the root will do."""
    lines = ([*row[:3], row[3].split(";")[0], *row[4:]] for row in rows)
    return hashlib.sha256("".join(json.dumps(line) + "\n" for line in lines).encode()).hexdigest()


def read_hashes():
    if not os.path.exists(HASHES):
        return {}
    with open(HASHES, encoding="ascii") as file:
        lines = [line.split() for line in file if not line.startswith("#")]
    return {(family, int(count)): digest_of for digest_of, count, family in lines}


def write_hashes(known):
    with open(HASHES, "w", encoding="ascii") as file:
        file.write("# SHA-256 of the answers about a family's first pairs, their number, the family (golden.py --record)\n")
        file.writelines(f"{digest_of} {count} {family}\n" for (family, count), digest_of in sorted(known.items()))


def make_pairs(options, families):
    """The pairs, unless they are there; the answers go with what made them."""
    made = hashlib.sha256()
    for path in [options.graze, *(os.path.join(HERE, one) for one in ("pairs.py", "../benchmark/solids.py", "../benchmark/motions.py"))]:
        with open(path, "rb") as file:
            made.update(hashlib.sha256(file.read()).digest())
    state, record = f"{options.count} {made.hexdigest()}\n", os.path.join(options.out, "made.txt")
    if os.path.exists(record):
        with open(record, encoding="ascii") as file:
            if file.read() == state:
                return
        os.remove(record)
    for family in families:
        if os.path.exists(os.path.join(options.out, f"{family}.jsonl")):
            os.remove(os.path.join(options.out, f"{family}.jsonl"))
    pairs.write(options.out, options.count, families)
    with open(record, "w", encoding="ascii") as file:
        file.write(state)


def lines_of(options, family, rows):
    """The answers about a family, from the file of an earlier run if that is whole."""
    path = os.path.join(options.out, f"{family}.jsonl")
    if os.path.exists(path):
        with open(path, encoding="utf-8") as file:
            lines = file.read().splitlines()
        if len(lines) == len(rows):
            return lines
    asked = os.path.join(options.out, f"{family}.csv")
    with open(asked, "w", encoding="ascii", newline="") as file:
        table = csv.DictWriter(file, ("id", "moving", "motion", "fixed"), extrasaction="ignore", lineterminator="\n")
        table.writeheader()
        table.writerows(rows)
    lines = ask(options.graze, asked)
    os.remove(asked)
    with open(path + ".part", "w", encoding="utf-8") as file:
        file.writelines(line + "\n" for line in lines)
    os.replace(path + ".part", path)
    return lines


def answer(options, families):
    """All lines and rows, and what is wrong with them."""
    known, everything, wrong = read_hashes(), [], []
    make_pairs(options, families)
    table = read_pairs(options.out)
    for family in families:
        asked = [pair for pair in table if pair["family"] == family]
        lines = lines_of(options, family, asked)
        rows = [row_of(line) for line in lines]
        wrong += [f"{pair['id']}: {row[2]} at {row[3]}; known: {pair['known']} at {pair['known_first']}"
                  for pair, row in zip(asked, rows) if not is_known(pair, row)]
        for count in {min(FEW, len(rows)), len(rows)}:
            if options.record:
                known[family, count] = digest(rows[:count])
            elif known.get((family, count), "") not in ("", digest(rows[:count])):
                wrong.append(f"{family}: the answers about its first {count} pairs have another hash than hashes.txt")
        everything += zip(lines, rows)
        print(f"{family}: {len(rows)} pairs", file=sys.stderr, flush=True)
    if options.record:
        write_hashes(known)
    return everything, wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("out", help="the folder")
    parser.add_argument("--graze", default="build/graze")
    parser.add_argument("--count", type=int, default=1000, help="pairs of each family (1000)")
    parser.add_argument("--record", action="store_true", help="write hashes.txt")
    options = parser.parse_args()
    options.graze = os.path.abspath(options.graze)
    everything, wrong = answer(options, list(pairs.FAMILIES))
    with open(os.path.join(options.out, "golden.jsonl"), "w", encoding="utf-8") as file:
        file.writelines(line + "\n" for line, _ in everything)
    with open(os.path.join(options.out, "golden.csv"), "w", encoding="utf-8", newline="") as file:
        rows = csv.writer(file, lineterminator="\n")
        rows.writerow(COLUMNS)
        rows.writerows(row for _, row in everything)
        file.write(f"# complete {len(everything)}\n")
    print("\n".join(wrong) or "no difference")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        main()
    except KeyboardInterrupt:
        sys.exit("golden.py: ended; the next run continues")
