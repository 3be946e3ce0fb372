"""The pages and metadata of the dataset: README.md, columns.json, datapackage.json (Frictionless), croissant.json (MLCommons 1.0),
SHA256SUMS, made of the files that are there. SPDX-License-Identifier: CC0-1.0
"""
import csv
import fnmatch
import functools
import gzip
import hashlib
import io
import json
import os
import re
import subprocess
import sys

from tables import ROOT, TIME, column_type

AUTHORS = "The Graze authors"
URL = "https://example.org/graze.git"
TITLE = "Points classified exactly against swept solids"
DESCRIPTION = ("Points in and around the sets that moving solids sweep, each with its exact answer: inside, on the boundary or outside, how often and in which "
               "way the boundary meets it, an enclosure of its signed distance, and a certificate that proves the rows; and pairs of such solids with their exact first contacts. Most points are hard by construction: "
               "contacts with faces, edges and vertices, near misses, slides. Scenes are exact: solids of binary64 coordinates, piecewise rational motions.")
CC0 = "https://creativecommons.org/publicdomain/zero/1.0/"
KEYWORDS = ["swept volume", "point membership classification", "exact computation", "signed distance", "benchmark", "computational geometry"]
# Files that describe the others; a package does not list itself.
ABOUT = {"README.md", "LICENSE", "SHA256SUMS", "croissant.json", "datapackage.json"}
MEDIA = {".csv": "text/csv", ".json": "application/json", ".npy": "application/octet-stream", ".off": "text/plain", ".wkt": "text/plain",
         ".txt": "text/plain", ".md": "text/markdown", ".jsonl": "application/jsonl", ".tar": "application/x-tar"}
CROISSANT_TYPES = {"number": "sc:Float", "integer": "sc:Integer", "string": "sc:Text"}
CONTEXT = {
    "@language": "en", "@vocab": "https://schema.org/", "sc": "https://schema.org/", "cr": "http://mlcommons.org/croissant/",
    "rai": "http://mlcommons.org/croissant/RAI/", "dct": "http://purl.org/dc/terms/", "conformsTo": "dct:conformsTo",
    "data": {"@id": "cr:data", "@type": "@json"}, "examples": {"@id": "cr:examples", "@type": "@json"}, "dataType": {"@id": "cr:dataType", "@type": "@vocab"},
    **{name: "cr:" + name for name in ("citeAs", "column", "extract", "field", "fileProperty", "fileObject", "fileSet", "format", "includes", "isLiveDataset",
                                        "jsonPath", "key", "md5", "parentField", "path", "recordSet", "references", "regex", "repeated", "replace", "separator",
                                        "source", "subField", "transform")}}
# Kinds of files: pattern (the first that fits counts), contents, origin.
ORIGINS = [
    ("benchmark.csv.gz", "all rows of all scenes in one table, without lines that begin with #", "joined of `scenes/*/golden.csv.gz`"),
    ("cases.csv.gz", "all rows of all golden cases in one table", "joined of `cases/*/expected.csv`"),
    ("columns.json", "each column of any table: meaning, type, unit, values", "of the program's table of columns and its page on formats"),
    ("hashes.txt", "SHA-256 of the answers of each scene that are the same on every machine", "`golden.py --record`"),
    ("scenes/*/solid.off", "the solid", "`cases/benchmark/scenes.py`, in rational arithmetic, rounded once to binary64"),
    ("scenes/*/motion.json", "the motion, exactly", "`cases/benchmark/scenes.py`"),
    ("scenes/*/poses-*.csv", "the motion at evenly spread times, as matrices of binary64", "`cases/benchmark/scenes.py`"),
    ("scenes/*/scene.json", "name, family, seed, diagonal, deviation of the poses", "`cases/benchmark/scenes.py`"),
    ("scenes/*/points.csv.gz", "the points", "`graze generate --plain --representable binary64 --coordinates decimal`"),
    ("scenes/*/golden.csv.gz", "the answers", "`graze classify --topo --sdf 1e-6r --boundary-distance`"),
    ("scenes/*/golden.npy", "the same as a numpy array", "of `golden.csv.gz`: numbers as the nearest double, texts as bytes"),
    ("*/certificate.txt.gz", "a proof of the rows, for `graze-check`", "`graze certify`; verified when it was packed"),
    ("cases/*/certificate.txt.*", "solid or motion in the form that the certificate is of", "`graze classify --certify`"),
    ("cases/*/solid.*", "the solid", "by hand, or by a program of the repository"),
    ("cases/*/motion.json", "the motion", "by hand"),
    ("cases/*/points.csv", "the points", "by hand"),
    ("cases/*/expected.csv", "the answers", "derived by hand or by a second method, as the case's README.md tells"),
    ("cases/*/golden.csv.gz", "the answers with the head of the table", "`graze classify`, which agrees with `expected.csv`"),
    ("cases/*/distances.csv", "signed distances in closed form", "derived by hand, in the case's README.md"),
    ("cases/*/README.md", "what the case shows, and the derivation of each row", "by hand"),
    ("contacts/pairs.csv", "pairs of solids, one of them moving, by the names of their files, and what is known of them", "`cases/contacts/pairs.py`"),
    ("contacts/solids.tar.gz", "the solids of the pairs, OFF", "`cases/contacts/pairs.py`, in rational arithmetic; coordinates are binary64"),
    ("contacts/motions.tar.gz", "the motions of the pairs, exactly", "`cases/contacts/pairs.py`"),
    ("contacts/golden.csv.gz", "verdict, word, time and cells of the first contact of each pair", "of `golden.jsonl.gz`, beside what is known by construction"),
    ("contacts/golden.jsonl.gz", "all contacts of each pair, one JSON object a line", "`graze collide --list pairs.csv --format jsonl`"),
    ("contacts/README.md", "families of the pairs, and other programs judged by them", "by hand"),
    ("contacts/hashes.txt", "SHA-256 of the answers about each family", "`cases/contacts/golden.py --record`"),
]
README = """# {title}

{description}

Version {version}, {rows} rows of {scenes} scenes, {cases} golden cases with {case_rows} rows, first contacts of {pairs} pairs of solids. Public domain, [CC0 1.0](LICENSE).

## To load it

```python
import pandas
rows = pandas.read_csv("benchmark.csv.gz", float_precision="round_trip", low_memory=False)
print(rows.groupby("family").pmc.value_counts())
```

`columns.json` says what each column means. `numpy.load("scenes/NAME/golden.npy")` has one scene as a structured array, without a parser. The tables
`golden.csv.gz` have a head of lines that begin with `#`: `pandas.read_csv(..., comment="#")`. Coordinates of the scenes are decimals that a binary64 holds
exactly; those of golden cases may be ratios. In `contacts`, `tar -xzf solids.tar.gz` and `tar -xzf motions.tar.gz` lay the files where `pairs.csv` names them.

## Files

| files | what they are | how they came to be |
|---|---|---|
{table}

## To verify it

`sha256sum -c SHA256SUMS`. A certificate proves its rows without Graze: `zcat` the table and the certificate of a scene, then `graze-check solid.off motion.json certificate.txt golden.csv`.
`make dataset` in the repository makes all of it again, in 1,400 seconds of CPU. All files are the same bytes on every machine but for four columns: `sdf_low`, `sdf_high`, `sdf_t` and `boundary_low`
are proved bounds that come from floating-point code, and another compiler may find others. `hashes.txt` has the hashes of what is the same.
`datapackage.json` (Frictionless) and `croissant.json` (MLCommons Croissant 1.0) name every file with size and SHA-256, and the columns of tables with their types.
"""


@functools.cache
def scene_words():
    """name: what it is, of all scenes of the benchmark, in their order."""
    sys.path.insert(0, os.path.join(ROOT, "cases", "benchmark"))
    import scenes  # pylint: disable=import-outside-toplevel
    return {name: words for name, (_, words, *_) in scenes.SCENES.items()}


def version():
    with open(os.path.join(ROOT, "include", "graze", "version.h"), encoding="utf-8") as file:
        return re.search(r'define GRAZE_VERSION "(.*)"', file.read())[1]


def released():
    """The date of the newest version in CHANGELOG.md, or None."""
    with open(os.path.join(ROOT, "CHANGELOG.md"), encoding="utf-8") as file:
        found = re.search(r"^## \S+ - (\d{4}-\d\d-\d\d)$", file.read(), re.M)
    return found[1] if found else None


def listed(out):
    """Paths of all files, relative to the dataset, in order."""
    found = [os.path.relpath(os.path.join(top, one), out) for top, _, names in os.walk(out) for one in names]
    return sorted(one for one in found if not one.endswith(".part"))


def fields_of(path, rows, names, described):
    """Schema of the columns of a table: name, type, description, values."""
    is_pose, exact, of = "/poses-" in path, path.startswith(("scenes/", "benchmark")), "contacts" if path.startswith("contacts/") else None
    found = []
    for k, name in enumerate(names):
        values = [row[k] for row in rows]
        if is_pose:
            entry = {"name": name, "type": "number", "description": TIME if name == "t" else f"entry {name[1:]} of the matrix, row and column from 0"}
        else:
            known = described[name, of]
            kind = known["type"] if of else "integer" if name == "id" and exact else column_type(name, "number" if exact else "string")
            entry = {"name": name, "type": kind, "description": known["meaning"]}
            if known["unit"]:
                entry["unit"] = known["unit"]
            if known["values"]:
                entry["constraints"] = {"enum": [int(one) for one in known["values"]] if kind == "integer" else known["values"]}
        if not all(values):
            entry["missing"] = sum(not one for one in values)
        found.append(entry)
    return found


def resource(out, path, described):
    """One entry of datapackage.json."""
    with open(os.path.join(out, path), "rb") as file:
        data = file.read()
    entry = {"name": re.sub(r"[^a-z0-9._-]", "-", path.lower()), "path": path, "bytes": len(data), "hash": "sha256:" + hashlib.sha256(data).hexdigest()}
    inner, is_packed = (path[:-3], True) if path.endswith(".gz") else (path, False)
    ending = os.path.splitext(inner)[1]
    if is_packed:
        data = gzip.decompress(data)
        entry |= {"compression": "gz", "unpacked": {"bytes": len(data), "hash": "sha256:" + hashlib.sha256(data).hexdigest()}}
    entry |= {"format": ending[1:], "mediatype": MEDIA.get(ending, "application/octet-stream")}
    entry["description"] = next((what for pattern, what, _ in ORIGINS if fnmatch.fnmatchcase(path, pattern)), None)
    if ending == ".csv":
        lines = [line for line in data.decode().splitlines() if line and not line.startswith("#")]
        names, *rows = csv.reader(io.StringIO("\n".join(lines)))
        entry |= {"profile": "tabular-data-resource", "encoding": "utf-8", "rows": len(rows), "dialect": {"delimiter": ",", "commentChar": "#"},
                  "schema": {"fields": fields_of(path, rows, names, described), "missingValues": [""]}}
    elif ending == ".jsonl":
        entry["rows"] = data.count(b"\n")
    elif ending == ".npy":
        entry["rows"] = int(re.search(rb"'shape': \((\d+),\)", data[:20000])[1])
    return entry


def datapackage(out, columns):
    described = {(one["name"], one["folder"]): one for one in columns}
    resources = [resource(out, path, described) for path in listed(out) if path not in ABOUT]
    nameless = [one["path"] for one in resources if one["description"] is None]
    if nameless:
        raise OSError(f"{nameless[0]}: a file that no row of ORIGINS describes")
    package = {"profile": "data-package", "name": "graze-dataset", "title": TITLE, "description": DESCRIPTION, "version": version(), "homepage": URL,
               "licenses": [{"name": "CC0-1.0", "path": CC0, "title": "CC0 1.0 Universal"}], "keywords": KEYWORDS,
               "contributors": [{"title": AUTHORS, "role": "author"}], "resources": resources}
    return package | ({"created": released()} if released() else {})


def croissant(out, package):
    """Every file as a FileObject, and a RecordSet for each table that a reader takes without a dialect."""
    def digest(path):
        with open(os.path.join(out, path), "rb") as file:
            return hashlib.sha256(file.read()).hexdigest()

    objects = [{"@type": "cr:FileObject", "@id": one["path"], "name": one["path"], "description": one["description"], "contentUrl": one["path"],
                "contentSize": f"{one['bytes']} B", "encodingFormat": one["mediatype"], "sha256": one["hash"][7:]} for one in package["resources"]]
    objects.append({"@type": "cr:FileObject", "@id": "datapackage.json", "name": "datapackage.json", "description": "the same files, with the columns of every table",
                    "contentUrl": "datapackage.json", "contentSize": f"{os.path.getsize(os.path.join(out, 'datapackage.json'))} B",
                    "encodingFormat": "application/json", "sha256": digest("datapackage.json")})
    sets = []
    for one in package["resources"]:
        if one["path"] not in ("benchmark.csv.gz", "cases.csv.gz", "contacts/pairs.csv"):
            continue
        name = os.path.basename(one["path"]).split(".")[0]
        # A whole number that may be empty is a float to readers.
        kinds = {field["name"]: "number" if field["type"] == "integer" and "missing" in field else field["type"] for field in one["schema"]["fields"]}
        sets.append({"@type": "cr:RecordSet", "@id": name, "name": name, "description": one["description"],
                     "field": [{"@type": "cr:Field", "@id": f"{name}/{field['name']}", "name": field["name"], "description": field["description"],
                                "dataType": CROISSANT_TYPES[kinds[field["name"]]],
                                "source": {"fileObject": {"@id": one["path"]}, "extract": {"column": field["name"]}}} for field in one["schema"]["fields"]]})
    dataset = {"@context": CONTEXT, "@type": "sc:Dataset", "conformsTo": "http://mlcommons.org/croissant/1.0", "name": "graze-dataset", "alternateName": TITLE,
               "description": DESCRIPTION, "license": CC0, "url": URL, "version": version(), "keywords": KEYWORDS, "isLiveDataset": False,
               "creator": {"@type": "sc:Organization", "name": AUTHORS}, "citeAs": f"{AUTHORS}: {TITLE}. Dataset of Graze {version()}, {URL}", "distribution": objects, "recordSet": sets}
    return dataset | ({"datePublished": released()} if released() else {})


def readme(out, package):
    paths = [one["path"] for one in package["resources"]]
    rows = {one["path"]: one["rows"] for one in package["resources"] if "rows" in one}
    table = [f"| `{pattern}` | {what} | {how} |" for pattern, what, how in ORIGINS if any(fnmatch.fnmatchcase(path, pattern) for path in paths)]
    return README.format(title=TITLE, description=DESCRIPTION, version=version(), table="\n".join(table), rows=f"{rows['benchmark.csv.gz']:,}", pairs=f"{rows['contacts/pairs.csv']:,}",
                         scenes=len(os.listdir(os.path.join(out, "scenes"))), cases=len(os.listdir(os.path.join(out, "cases"))), case_rows=rows["cases.csv.gz"])


def as_json(value):
    return json.dumps(value, indent=1, ensure_ascii=False) + "\n"


def texts(out, columns):
    """(path, text) of each page and file of metadata; the next one is made when the last one is written."""
    with open(os.path.join(ROOT, "LICENSES", "CC0-1.0.txt"), encoding="utf-8") as file:
        yield "LICENSE", file.read()
    with open(os.path.join(ROOT, "cases", "benchmark", "hashes.txt"), encoding="utf-8") as file:
        yield "hashes.txt", file.read()
    yield "columns.json", as_json(columns)
    package = datapackage(out, columns)
    yield "datapackage.json", as_json(package)
    yield "croissant.json", as_json(croissant(out, package))
    yield "README.md", readme(out, package)
    yield "SHA256SUMS", subprocess.run(["sha256sum", *(path for path in listed(out) if path != "SHA256SUMS")], cwd=out, stdout=subprocess.PIPE,
                                       text=True, check=True).stdout
