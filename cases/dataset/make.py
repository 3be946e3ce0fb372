#!/usr/bin/env python3
"""The dataset: the scenes of the benchmark, the golden cases and pairs of bodies, as files with metadata.

    python3 cases/dataset/make.py OUT [SCENE...]

Scenes are those of cases/benchmark/golden.py, pairs those of cases/contacts/golden.py, which are run first and continue a run that was ended; a scene or case that is
packed and whose files are the same is not packed again. Files have no dates or names in them, so each machine writes the same
bytes, but for the enclosures of distances (README.md). SPDX-License-Identifier: CC0-1.0
"""
import argparse
import gzip
import hashlib
import io
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tarfile

import metadata
from tables import ROOT, Failure, array_bytes, describe, split_table

CASES = os.path.join(ROOT, "cases")
GOLDEN, PAIRS = (os.path.join(CASES, one, "golden.py") for one in ("benchmark", "contacts"))
FEW = 10  # pairs of a family beside scenes that are named, whose answers have hashes too
STEP = "packed.txt"  # beside the folders: what each was packed of
PROGRAM = ("make.py", "tables.py")


def read(path):
    with open(path, "rb") as file:
        return file.read()


def write(path, data):
    """A file that is whole as soon as it has its name."""
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path + ".part", "wb") as file:
        file.write(data.encode() if isinstance(data, str) else data)
    os.replace(path + ".part", path)


def packed(data):
    """gzip without a date or a name."""
    out = io.BytesIO()
    with gzip.GzipFile(filename="", mode="wb", compresslevel=9, fileobj=out, mtime=0) as file:
        file.write(data)
    return out.getvalue()


def archive(folder, paths):
    """A tar of files in a folder, without owners and dates."""
    out = io.BytesIO()
    with tarfile.open(fileobj=out, mode="w", format=tarfile.USTAR_FORMAT) as made:
        for path in paths:
            data, entry = read(path), tarfile.TarInfo(f"{folder}/{os.path.basename(path)}")
            entry.size, entry.mode = len(data), 0o644
            made.addfile(entry, io.BytesIO(data))
    return out.getvalue()


def step(*command):
    """Status of a program of Python, which ends with this one, whose signal it need not get."""
    with subprocess.Popen([sys.executable, *command]) as made:
        try:
            return made.wait()
        except KeyboardInterrupt:
            made.terminate()
            made.wait()
            raise


def digest(paths):
    state = hashlib.sha256()
    for path in paths:
        state.update(os.path.basename(path).encode() + b"\0" + hashlib.sha256(read(path)).digest())
    return state.hexdigest()


class Packer:
    """Writes the dataset's folders, each only if what it is made of has changed."""

    def __init__(self, options):
        self.graze, self.out, self.benchmark = options.graze, options.out, options.benchmark
        self.check = os.path.join(os.path.dirname(options.graze), "graze-check")
        self.own = digest([os.path.join(os.path.dirname(os.path.abspath(__file__)), name) for name in PROGRAM])
        self.program = digest([self.graze])
        self.record = os.path.join(self.out, os.pardir, os.path.basename(self.out) + "-" + STEP)
        self.known = dict(line.split() for line in read(self.record).decode().splitlines()) if os.path.exists(self.record) else {}

    def folder(self, name, sources, fill):
        """Fill OUT/NAME anew unless it was packed of the same sources."""
        state, path = digest(sources) + self.own + self.program, os.path.join(self.out, name)
        if self.known.get(name) == state and os.path.isdir(path):
            return
        shutil.rmtree(path, ignore_errors=True)
        os.makedirs(path)
        fill(path)
        self.known[name] = state
        write(self.record, "".join(f"{one} {made}\n" for one, made in sorted(self.known.items())))

    def scene(self, name):
        source = os.path.join(self.benchmark, name)
        names = sorted(one for one in os.listdir(source) if not one.endswith(".part") and one != "done.txt")

        def fill(path):
            for one in names:
                large = one in ("points.csv", "golden.csv", "certificate.txt")
                data = read(os.path.join(source, one))
                write(os.path.join(path, one + ".gz" if large else one), packed(data) if large else data)
            _, columns, rows = split_table(read(os.path.join(source, "golden.csv")).decode(), name)
            write(os.path.join(path, "golden.npy"), array_bytes(columns, rows))
        self.folder(f"scenes/{name}", [os.path.join(source, one) for one in names], fill)

    def case(self, name):
        source = os.path.join(CASES, name)
        names = sorted(one for one in os.listdir(source) if not one.endswith(".py") and os.path.isfile(os.path.join(source, one)))

        def fill(path):
            for one in names:
                write(os.path.join(path, one), read(os.path.join(source, one)))
            self.golden_case(name, source, path, names)
        self.folder(f"cases/{name}", [os.path.join(source, one) for one in names], fill)

    def golden_case(self, name, source, path, names):
        """The case's table with its head, its certificate, and its distances as a table; the derived rows must be the table's."""
        page = read(os.path.join(source, "README.md")).decode()
        options = re.search(r"^options: (.*)$", page, re.M)
        solid = next(one for one in names if one.startswith("solid."))
        table, certificate = os.path.join(path, "golden.csv"), os.path.join(path, "certificate.txt")
        proved = [] if solid == "solid.csg.json" else ["--certify", certificate]
        self.run([self.graze, "classify", solid, "motion.json", "points.csv", *(options[1].split() if options else []), *proved, "--output", table, "--quiet"], source)
        _, columns, rows = split_table(read(table).decode(), name)
        _, names, derived = split_table(read(os.path.join(source, "expected.csv")).decode(), name)
        at = names.index("pmc")  # beside a certificate coordinates are in lowest terms
        if names != columns or [row[at:] for row in derived] != [row[at:] for row in rows]:
            raise Failure(f"cases/{name}: the program's rows are not those of expected.csv")
        if proved:
            beside = [next((one for one in (certificate + ending for ending in endings) if os.path.exists(one)), os.path.join(source, given))
                      for endings, given in (((".off", ".wkt"), solid), ((".json",), "motion.json"))]
            self.run([self.check, *beside, certificate, table], source)
        for one in filter(os.path.exists, (table, certificate)):
            write(one + ".gz", packed(read(one)))
            os.remove(one)
        section = re.search(r"^## Distances\n\|.*\n\|[-|]+\|\n((?:\|.*\n)+)", page, re.M)
        if section:
            cells = [[cell.strip() for cell in line.strip("|").split(" | ")][:2] for line in section[1].splitlines()]
            write(os.path.join(path, "distances.csv"), "id,s\n" + "".join(f"{one},{s}\n" for one, s in cells))

    def run(self, words, folder):
        done = subprocess.run(words, cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        if done.returncode:
            raise Failure(f"{os.path.basename(words[0])}, status {done.returncode} in {folder}: {done.stdout.strip()[-300:]}")

    def contacts(self, made):
        """Pairs of solids with their first contacts; solids and motions in archives, since they are thousands of small files."""
        own = [os.path.join(CASES, "contacts", one) for one in ("README.md", "hashes.txt")]
        inside = {one: sorted(os.path.join(made, one, name) for name in os.listdir(os.path.join(made, one))) for one in ("solids", "motions")}
        tables = [os.path.join(made, one) for one in ("pairs.csv", "golden.csv", "golden.jsonl")]

        def fill(path):
            for one in [*own, tables[0]]:
                write(os.path.join(path, os.path.basename(one)), read(one))
            for one in tables[1:]:
                write(os.path.join(path, os.path.basename(one) + ".gz"), packed(read(one)))
            for name, files in inside.items():
                write(os.path.join(path, name + ".tar.gz"), packed(archive(name, files)))
        self.folder("contacts", [*own, *tables, *inside["solids"], *inside["motions"]], fill)

    def joined(self, name, first, folders, table):
        """One table of all rows: `first` columns of each folder, and its own; columns that a table lacks are empty."""
        parts, names = [], []
        for folder, values in folders:
            path = os.path.join(self.out, folder, table)
            data = gzip.decompress(read(path)) if path.endswith(".gz") else read(path)
            _, columns, rows = split_table(data.decode(), path)
            parts.append((values, columns, rows))
            names += [column for column in columns if column not in names]
        names.sort(key=lambda one: ("x", "y", "z").index(one) if one in ("x", "y", "z") else 3)  # z behind x and y, the rest as it came
        lines = [",".join([*first, *names])]
        for values, columns, rows in parts:
            at = [columns.index(one) if one in columns else None for one in names]
            lines += [",".join([*values, *("" if k is None else row[k] for k in at)]) for row in rows]
        write(os.path.join(self.out, name), packed(("\n".join(lines) + "\n").encode()))


def case_names():
    return sorted(one for one in os.listdir(CASES) if os.path.exists(os.path.join(CASES, one, "expected.csv")))


def case_options(name):
    found = re.search(r"^options: (.*)$", read(os.path.join(CASES, name, "README.md")).decode(), re.M)
    return found[1] if found else ""


def forget(out, names):
    """Folders of scenes or cases that are no longer part of it."""
    for wing, kept in names.items():
        for one in os.listdir(os.path.join(out, wing)) if os.path.isdir(os.path.join(out, wing)) else []:
            if one not in kept:
                shutil.rmtree(os.path.join(out, wing, one))


def make(options):
    os.makedirs(options.out, exist_ok=True)
    packer = Packer(options)
    scenes = options.scenes or list(metadata.scene_words())
    unknown = [one for one in scenes if one not in metadata.scene_words()]
    if unknown:
        raise Failure(f"{unknown[0]}: no scene of cases/benchmark; expected one of scenes.py --list")
    if step(GOLDEN, "--graze", options.graze, options.benchmark, *scenes):
        raise Failure("the golden rows of the benchmark are not as they should be, see above")
    pairs = os.path.join(os.path.dirname(options.benchmark), f"contacts-{FEW}" if options.scenes else "contacts")
    if step(PAIRS, "--graze", options.graze, pairs, *(["--count", str(FEW)] if options.scenes else [])):
        raise Failure("the first contacts are not as they should be, see above")
    cases = case_names()
    forget(options.out, {"scenes": scenes, "cases": cases})
    for name in scenes:
        packer.scene(name)
    for name in cases:
        packer.case(name)
    packer.contacts(pairs)
    families = {name: json.loads(read(os.path.join(options.out, "scenes", name, "scene.json")))["family"] for name in scenes}
    packer.joined("benchmark.csv.gz", ["scene", "family"], [(f"scenes/{one}", [one, families[one]]) for one in scenes], "golden.csv.gz")
    packer.joined("cases.csv.gz", ["name", "options"], [(f"cases/{one}", [one, case_options(one)]) for one in cases], "expected.csv")
    for path, text in metadata.texts(options.out, describe(options.graze)):
        write(os.path.join(options.out, path), text)
    files, size = metadata.listed(options.out), 0
    for path in files:
        size += os.path.getsize(os.path.join(options.out, path))
    print(f"{options.out}: {len(scenes)} scenes, {len(cases)} cases, {len(files)} files, {size / 1e6:.1f} MB")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--graze", default=os.path.join(ROOT, "build", "graze"))
    parser.add_argument("--benchmark", default=os.path.join(ROOT, "build", "benchmark"), help="where golden.py makes the scenes, or has made them; pairs are made beside it")
    parser.add_argument("out", metavar="OUT")
    parser.add_argument("scenes", metavar="SCENE", nargs="*", help="these scenes of the benchmark alone, and few pairs")
    options = parser.parse_args()
    options.graze, options.out, options.benchmark = map(os.path.abspath, (options.graze, options.out, options.benchmark))
    try:
        make(options)
    except (Failure, OSError, subprocess.CalledProcessError) as error:
        print(f"make.py: {error}", file=sys.stderr)
        return 3
    except KeyboardInterrupt:
        print("make.py: ended; the next run continues", file=sys.stderr)
        return 130
    return 0


if __name__ == "__main__":
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    sys.exit(main())
