#!/usr/bin/env python3
# suite
"""The dataset of cases/dataset: a small one of two scenes, or with --dataset DIR one that is there, read through its metadata alone.

Every file that datapackage.json and croissant.json name is there with the size and hash they say, no other file is there; each table
has the columns, types, values and number of rows that they say, each array the numbers of its table; columns.json has the program's
table of columns. Archives of the pairs have the files that pairs.csv names. The dataset is the same bytes when it is made again, elsewhere and
under another clock and mask, and a run that is ended by a signal leaves no program behind and is continued. Certificates prove the rows that are packed, and refuse a row that is changed.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import ast
import csv
import gzip
import hashlib
import io
import json
import os
import re
import signal
import struct
import subprocess
import sys
import tarfile
import tempfile
import time
from fractions import Fraction

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

from column_sets import column_sets  # noqa: E402
from harness import ROOT, Checks, options, run, without_leaks  # noqa: E402

MAKE = os.path.join(ROOT, "cases", "dataset", "make.py")
SCENES = ["igl-2562", "wedge-straight"]  # straight, of 12 and 16 triangles: the soonest made
APART = {"SHA256SUMS", "README.md", "LICENSE", "croissant.json", "datapackage.json"}
SHAPES = {"number": lambda field: Fraction(field) is not None, "integer": lambda field: re.fullmatch(r"-?\d+", field), "string": lambda field: True}
CROISSANT = {"sc:Float": "number", "sc:Integer": "integer", "sc:Text": "string"}
checks = Checks()


def read(*path):
    with open(os.path.join(*path), "rb") as file:
        return file.read()


def sha256(data):
    return hashlib.sha256(data).hexdigest()


def under(folder):
    return {os.path.relpath(os.path.join(top, name), folder) for top, _, names in os.walk(folder) for name in names}


def make(args, folder, name, *words, benchmark="benchmark", **environment):
    out = os.path.join(folder, name)
    done = run([sys.executable, MAKE, "--graze", args.graze, "--benchmark", os.path.join(folder, benchmark), out, *words], seconds=300,
               env=dict(without_leaks(), **environment), cwd=folder)
    return out, done


def fits(kind, field):
    try:
        return bool(SHAPES[kind](field))
    except ValueError:
        return False


def table(out, resource):
    """Rows of a table as its entry describes it, each field held to its type."""
    data = read(out, resource["path"])
    if resource.get("compression") == "gz":
        data = gzip.decompress(data)
        unpacked = resource["unpacked"]
        checks.equal((len(data), "sha256:" + sha256(data)), (unpacked["bytes"], unpacked["hash"]), resource["path"], "unpacked")
    dialect, mark = resource["dialect"], resource["dialect"]["commentChar"]
    lines = [line for line in data.decode(resource["encoding"]).splitlines() if line and not line.startswith(mark)]
    names, *rows = csv.reader(io.StringIO("\n".join(lines)), delimiter=dialect["delimiter"])
    fields = resource["schema"]["fields"]
    checks.equal(names, [field["name"] for field in fields], resource["path"], "columns")
    checks.equal(len(rows), resource["rows"], resource["path"], "rows")
    for k, field in enumerate(fields):
        values = [row[k] for row in rows]
        present = [value for value in values if value not in resource["schema"]["missingValues"]]
        wrong = [value for value in set(present) if not fits(field["type"], value)]
        checks.holds(not wrong, resource["path"], field["name"], field["type"], wrong[:3])
        allowed = {str(value) for value in field.get("constraints", {}).get("enum", present)}
        checks.holds(set(present) <= allowed, resource["path"], field["name"], set(present) - allowed)
        checks.equal(len(values) - len(present), field.get("missing", 0), resource["path"], field["name"], "empty fields")
        checks.holds(len(field["description"]) > 5, resource["path"], field["name"], field["description"])
    return names, rows


def array(data):
    """(types by name, records) of a structured array, by the format of numpy, 3.0."""
    length = 12 + struct.unpack("<I", data[8:12])[0]
    checks.equal((data[:8], length % 64), (b"\x93NUMPY\x03\x00", 0), "head of an array")
    head = ast.literal_eval(data[12:length].decode())
    form = "<" + "".join({"<f8": "d", "<u4": "I"}.get(kind) or kind.strip("|S") + "s" for _, kind in head["descr"])
    checks.equal(len(data) - length, struct.calcsize(form) * head["shape"][0], "bytes of an array")
    return dict(head["descr"]), list(struct.iter_unpack(form, data[length:]))


def same_numbers(name, out, names, rows, count):
    """An array has the nearest doubles of its table's numbers, its texts, and 0 for `ext`."""
    kinds, records = array(read(out, name))
    checks.equal((list(kinds), len(records)), (names, count), name)
    for k, (column, kind) in enumerate(kinds.items()):
        if kind == "<f8":
            wanted = [float(Fraction(row[k])) for row in rows]
        elif kind == "<u4":
            wanted = [int(row[k]) if row[k].isdigit() else 0 for row in rows]
        else:
            wanted = [row[k].encode() for row in rows]
        got = [value.rstrip(b"\0") if isinstance(value, bytes) else value for value in (record[k] for record in records)]
        checks.holds(got == wanted, name, column, next(((a, b) for a, b in zip(got, wanted) if a != b), None))


def metadata(out, scenes, pairs):
    """All of the dataset by datapackage.json; then croissant.json, columns.json and SHA256SUMS against it."""
    package, croissant = json.loads(read(out, "datapackage.json")), json.loads(read(out, "croissant.json"))
    entries = {one["path"]: one for one in package["resources"]}
    checks.equal(under(out), set(entries) | APART, "files")
    checks.equal((len({one["name"] for one in entries.values()}), package["licenses"][0]["name"]), (len(entries), "CC0-1.0"), "names, licence")
    tables = {}
    for path, entry in entries.items():
        data = read(out, path)
        checks.equal((len(data), "sha256:" + sha256(data)), (entry["bytes"], entry["hash"]), path)
        if entry.get("profile") == "tabular-data-resource":
            tables[path] = table(out, entry)
        checks.holds(("profile" in entry) == path.removesuffix(".gz").endswith(".csv"), path, "is a table")
    for path, entry in entries.items():
        if path.endswith(".npy"):
            same_numbers(path, out, *tables[path.replace(".npy", ".csv.gz")], entry["rows"])
    hashed = dict(line.split()[:0:-1] for line in read(ROOT, "cases", "benchmark", "hashes.txt").decode().splitlines() if line[0] != "#")
    wanted = {name: int(hashed[name]) for name in scenes}
    checks.equal({path.split("/")[1]: len(rows) for path, (_, rows) in tables.items() if path.endswith("/golden.csv.gz") and path.startswith("scenes/")},
                 wanted, "rows of scenes")
    checks.equal(len(tables["benchmark.csv.gz"][1]), sum(wanted.values()), "rows of all scenes")
    derived = sum(read(ROOT, "cases", name, "expected.csv").count(b"\n") - 1 for name in os.listdir(os.path.join(ROOT, "cases"))
                  if os.path.exists(os.path.join(ROOT, "cases", name, "expected.csv")))
    checks.equal(len(tables["cases.csv.gz"][1]), derived, "rows of cases")
    sums = dict(reversed(line.split("  ")) for line in read(out, "SHA256SUMS").decode().splitlines())
    checks.equal(sums, {path: sha256(read(out, path)) for path in under(out) - {"SHA256SUMS"}}, "SHA256SUMS")
    check_croissant(out, croissant, entries)
    check_columns(json.loads(read(out, "columns.json")), tables)
    check_pairs(out, entries, tables, pairs)


def check_pairs(out, entries, tables, count):
    """The archives hold the files that the pairs name and no other, the answers are those of the pairs, and fit what is known of them."""
    names, rows = tables["contacts/pairs.csv"]
    pairs = [dict(zip(names, row)) for row in rows]
    checks.equal(len(pairs), 10 * count, "pairs of ten families")
    for name, columns in (("solids", ("moving", "fixed")), ("motions", ("motion",))):
        data = gzip.decompress(read(out, "contacts", name + ".tar.gz"))
        unpacked = entries[f"contacts/{name}.tar.gz"]["unpacked"]
        checks.equal((len(data), "sha256:" + sha256(data)), (unpacked["bytes"], unpacked["hash"]), name, "unpacked")
        with tarfile.open(fileobj=io.BytesIO(data)) as archive:
            members = archive.getmembers()
            inside = {one.name: archive.extractfile(one).read() for one in members}
        checks.equal({(one.mtime, one.uid, one.gid, one.mode, one.uname) for one in members}, {(0, 0, 0, 0o644, "")}, name, "dates and owners")
        checks.equal(set(inside), {pair[column] for pair in pairs for column in columns}, name, "files of the archive")
        starts = {text[:3] if name == "solids" else b"{}" if isinstance(json.loads(text), dict) else text for text in inside.values()}
        checks.equal(starts, {b"OFF" if name == "solids" else b"{}"}, name)
    names, rows = tables["contacts/golden.csv.gz"]
    answers = [dict(zip(names, row)) for row in rows]
    lines = gzip.decompress(read(out, "contacts", "golden.jsonl.gz")).decode().splitlines()
    checks.equal(len(lines), entries["contacts/golden.jsonl.gz"]["rows"], "lines of golden.jsonl")
    objects = [json.loads(line) for line in lines]
    checks.equal([pair["id"] for pair in pairs], [one["id"] for one in answers], "answers of pairs")
    checks.equal([(one["id"], one["verdict"], one["word"]) for one in objects], [(one["id"], one["verdict"], one["word"]) for one in answers], "objects")
    for pair, answer in zip(pairs, answers):
        known = pair["known"]
        right = answer["word"].startswith(known[:-1]) if known.endswith("+") else known in ("", answer["word"])
        checks.holds(right and pair["known_first"] in ("", answer["first"]), pair, answer)
        checks.equal(bool(answer["first"]), answer["verdict"] != "clear", answer)


def check_croissant(out, croissant, entries):
    """Keys that MLCommons Croissant 1.0 asks for, files by id with their hash, fields that name a file and a column."""
    checks.equal((croissant["@type"], croissant["conformsTo"]), ("sc:Dataset", "http://mlcommons.org/croissant/1.0"), "croissant.json")
    lacking = {"@context", "name", "description", "license", "url", "version", "creator", "distribution", "recordSet"} - set(croissant)
    checks.holds(not lacking, "croissant.json lacks", lacking)
    objects = {one["@id"]: one for one in croissant["distribution"]}
    checks.equal((set(objects), len(objects)), (set(entries) | {"datapackage.json"}, len(croissant["distribution"])), "files of croissant.json")
    for path, one in objects.items():
        data = read(out, one["contentUrl"])
        checks.equal((one["@type"], one["sha256"], one["contentSize"]), ("cr:FileObject", sha256(data), f"{len(data)} B"), "croissant.json", path)
    for records in croissant["recordSet"]:
        path = records["field"][0]["source"]["fileObject"]["@id"]
        fields = entries[path]["schema"]["fields"]
        checks.equal([one["source"]["extract"]["column"] for one in records["field"]], [field["name"] for field in fields], path, "columns of croissant.json")
        checks.equal(objects[path]["encodingFormat"], "text/csv", path)
        data = read(out, path)
        checks.holds(not (gzip.decompress(data) if path.endswith(".gz") else data).startswith(b"#"), path, "a reader of Croissant knows no comments")
        for one, field in zip(records["field"], fields):
            kind = CROISSANT[one["dataType"]]
            checks.holds(kind == field["type"] or (kind, field["type"]) == ("number", "integer") and "missing" in field, path, field["name"], one["dataType"])


def check_columns(columns, tables):
    """columns.json names what the table of columns in C names, in its order, and each column of each table."""
    of = {folder: {one["name"]: one for one in columns if one["folder"] == folder} for folder in (None, "contacts")}
    checks.equal(sum(map(len, of.values())), len(columns), "columns.json names a column once")
    names = list(of[None])
    in_c = [name for names in column_sets().values() for name in names]
    checks.equal([name for name in names if name in in_c], in_c, "the table of columns")
    for path, (found, rows) in tables.items():
        described = {} if "/poses-" in path else of["contacts" if path.startswith("contacts/") else None]
        unknown = [name for name in found if described and name not in described]
        checks.holds(not unknown, path, "columns that columns.json lacks", unknown)
        for k, one in ((k, described[name]) for k, name in enumerate(found) if name in described):
            values = {row[k] for row in rows if row[k]}
            checks.holds(values <= set(one["values"] or values), path, one["name"], "values that columns.json lacks", values - set(one["values"] or values))
            kind = "number" if one["type"] == "number or ratio" else one["type"]
            checks.holds(all(fits(kind, value) for value in values), path, one["name"], "no", one["type"])
    for one in columns:
        checks.equal(set(one), {"name", "meaning", "type", "unit", "values", "folder"}, one)
        checks.holds(len(one["meaning"]) > 10 and "](" not in one["meaning"], one)


def same_as_graze(args, folder):
    """The arrays are those that graze writes itself, byte for byte: of golden cases, whose rows are few."""
    sys.path.insert(0, os.path.dirname(MAKE))
    from tables import array_bytes, split_table  # pylint: disable=import-outside-toplevel
    for name, words in (("figure4", []), ("bracket", []), ("gear", ["--sdf", "1e-3r"]), ("unsweep-figure2a", ["--operation", "unsweep", "--topo"]),
                        ("figures-5-7-8", []), ("closed-seam", ["--topo"])):
        case = os.path.join(ROOT, "cases", name)
        solid = next(one for one in os.listdir(case) if one.startswith("solid."))
        call = [args.graze, "classify", os.path.join(case, solid), os.path.join(case, "motion.json"), os.path.join(case, "points.csv"), "--quiet", *words]
        out = os.path.join(folder, "own.npy")
        text, done = run(call).stdout, run([*call, "--format", "npy", "-o", out])
        own, given = array_bytes(*split_table(text, name)[1:]), read(out)
        checks.holds(done.returncode == 0 and own == given, name, own[:600], given[:600])


def certificates(args, out, folder):
    checker = os.path.join(os.path.dirname(args.graze), "graze-check")
    for name, solid in ((f"scenes/{SCENES[0]}", "solid.off"), ("cases/figure4", "solid.wkt"), ("cases/bracket", "solid.off")):
        given = [solid, "motion.json"]
        for k, ending in enumerate((os.path.splitext(solid)[1], ".json")):
            if os.path.exists(os.path.join(out, name, "certificate.txt" + ending)):
                given[k] = "certificate.txt" + ending
        files = [os.path.join(out, name, one) for one in given]
        for one in ("certificate.txt", "golden.csv"):
            files.append(os.path.join(folder, one))
            with open(files[-1], "wb") as file:
                file.write(gzip.decompress(read(out, name, one + ".gz")))
        done = run([checker, *files], env=without_leaks())
        checks.holds(done.returncode == 0 and "verified" in done.stdout, name, done)
        with open(files[3], encoding="ascii") as file:
            text = file.read()
        with open(files[3], "w", encoding="ascii") as file:
            file.write(text.replace(",on,", ",out,", 1) if ",on," in text else text.replace(",in,", ",out,", 1))
        done = run([checker, *files], env=without_leaks())
        checks.holds(done.returncode == 1, name, "a forged row", done)


def again(args, folder, out):
    """Elsewhere the same bytes; what is lacking is made again and the rest left; a row that is changed is noticed."""
    wanted = read(out, "SHA256SUMS")
    other, done = make(args, folder, "other/dataset", *SCENES, TZ="Asia/Kathmandu", LC_ALL="C", PYTHONHASHSEED="7")
    checks.holds(done.returncode == 0 and read(other, "SHA256SUMS") == wanted, "the same bytes elsewhere", done)
    kept = os.stat(os.path.join(out, "scenes", SCENES[0], "golden.npy")).st_mtime_ns
    for path in ("cases/figure4", f"scenes/{SCENES[1]}"):
        for one in os.listdir(os.path.join(out, path)):
            os.remove(os.path.join(out, path, one))
        os.rmdir(os.path.join(out, path))
    with open(os.path.join(out, "cases.csv.gz.part"), "wb") as file:
        file.write(b"ended here")
    _, done = make(args, folder, "dataset", *SCENES)
    checks.holds(done.returncode == 0 and read(out, "SHA256SUMS") == wanted, "continued", done)
    checks.equal(os.stat(os.path.join(out, "scenes", SCENES[0], "golden.npy")).st_mtime_ns, kept, "what was whole is left")
    golden = os.path.join(folder, "benchmark", SCENES[0], "golden.csv")
    text = read(golden)
    with open(golden, "wb") as file:
        file.write(text.replace(b",on,", b",in,", 1))
    _, done = make(args, folder, "dataset", SCENES[0])
    checks.holds(done.returncode == 3 and "DIFFERS" in done.stdout and "not as they should be" in done.stderr, "a row that is changed", done)
    _, done = make(args, folder, "dataset", "nowhere")
    checks.holds(done.returncode == 3 and "nowhere: no scene of cases/benchmark; expected one of" in done.stderr, "an unknown scene", done)


def ended(args, folder, wanted):
    """A signal ends it and all that it started, in one line; the next run makes the same bytes."""
    out, benchmark = os.path.join(folder, "ended"), os.path.join(folder, "ended-scenes", "benchmark")
    words = [sys.executable, MAKE, "--graze", args.graze, "--benchmark", benchmark, out, *SCENES]
    with subprocess.Popen(words, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True, env=without_leaks(), start_new_session=True) as started:
        points = os.path.join(benchmark, SCENES[0], "points.csv.part")  # graze is at work
        for _ in range(2000):
            if os.path.exists(points) or started.poll() is not None:
                break
            time.sleep(0.01)
        started.terminate()
        said = started.communicate(timeout=60)[1]
        checks.equal((started.returncode, "Traceback" in said, "the next run continues" in said), (130, False, True), said)
        try:
            os.killpg(started.pid, 0)
            os.killpg(started.pid, signal.SIGKILL)
            checks.fail("programs that go on")
        except ProcessLookupError:
            checks.holds(True)
    done = run(words, seconds=300, env=without_leaks())
    checks.holds(done.returncode == 0 and read(out, "SHA256SUMS") == wanted, "continued after a signal", done)


def main():
    args = options(__doc__, ("--dataset", {"help": "a dataset that is there, whole"}))
    if args.dataset:
        metadata(args.dataset, sorted(os.listdir(os.path.join(args.dataset, "scenes"))), 1000)
        checks.finish()
        return
    with tempfile.TemporaryDirectory() as folder:
        out, done = make(args, folder, "dataset", *SCENES)
        if checks.holds(done.returncode == 0, done):
            metadata(out, SCENES, 10)
            ended(args, folder, read(out, "SHA256SUMS"))
            same_as_graze(args, folder)
            certificates(args, out, folder)
            again(args, folder, out)
    checks.finish()


if __name__ == "__main__":
    main()
