#!/usr/bin/env python3
# suite
"""Things that only people can give stand in RELEASE.md and nowhere else: each stand-in is in the files that its row names, in no other,
and no other file says that something is missing. CITATION.cff and codemeta.json are whole and name the same things; what copyright
and licence says, .reuse/dep5, the heads of files and LICENSES/, agrees.

The words by which a file says so are those of PLACEHOLDER; a name of the domains that are reserved for examples is one.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import fnmatch
import json
import os
import re
import subprocess
import sys

from programs import ROOT, check, checks, options, read, same

PAGE = "RELEASE.md"
PLACEHOLDER = re.compile(r"example\.(?:org|com|net|invalid)|\b(?:TBD|TBA|FIXME|TODO)\b|[Zz]enodo|0000-000\d|10\.5281/|"
                         r"\b(?:not|to be) (?:yet )?(?:given|assigned|minted|named) (?:yet|later|by people|by hand)")
# This suite quotes them, as rules of writing quote TODO; inputs of the fuzzer are bytes; licences are other people's texts.
QUOTED = {PAGE, "tests/install/release.py"}
OTHERS = ("tests/fuzz/corpus/", "LICENSES/", "src/output/page/three/")
CFF_KEYS = {"cff-version", "message", "type", "title", "version", "license", "abstract", "authors", "keywords", "references"}
DOI = re.compile(r"10\.\d{4,}/\S+")


def tracked():
    """Files of the tree; where git does not know it, all but what is built."""
    try:
        listed = subprocess.run(["git", "ls-files"], cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, check=True).stdout.split("\n")
    except (OSError, subprocess.CalledProcessError):
        paths = (os.path.relpath(os.path.join(top, name), ROOT) for top, _, names in os.walk(ROOT) for name in names)
        listed = [path for path in paths if not re.match(r"build[/-]|\.git/|.*__pycache__", path)]
    return [name for name in listed if name and not name.startswith(OTHERS)]


def texts(names):
    found = {}
    for name in names:
        try:
            found[name] = read(name)
        except (UnicodeDecodeError, FileNotFoundError):
            continue  # a compressed file; one that is taken away and not committed
    return found


def missing(page):
    """Rows of the table: what is missing, its stand-in or '', the files in which it stands."""
    lines = re.search(r"^\| missing .*\n\|[-|]+\|\n((?:\|.*\n)+)", page, re.M)[1].splitlines()
    rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in lines]
    return [(what, stand_in.strip("`") if stand_in != "none" else "", re.findall(r"`([^`]+)`", places)) for what, stand_in, places in rows]


def stand_ins(found):
    rows = missing(found[PAGE])
    for word in ("names", "address for", "address of the repository", "tag", "DOI"):
        check(any(word in what for what, _, _ in rows), f"{PAGE}: no row for {word}")
    known = [stand_in for _, stand_in, _ in rows if stand_in]
    for _, stand_in, places in rows:
        if not stand_in:
            same(places, [], f"{PAGE}: a thing without a stand-in stands nowhere")
            continue
        # The collective name is also that of a copyright line, and of a sentence: a place is where it is an author's.
        holders = [name for name, text in found.items() if stand_in in text and name not in QUOTED]
        same(sorted(holders), sorted(places), f"files with {stand_in}")
    for name, text in found.items():
        if name in QUOTED:
            continue
        for stand_in in known:
            text = text.replace(stand_in, "")
        said = PLACEHOLDER.search(text)
        check(said is None, f"{name}: `{said and said[0]}` says that something is missing; expected a row of {PAGE}")


def as_data(path):
    """A YAML file as Python's values, by Debian's python3-yaml."""
    code = "import json, sys, yaml; json.dump(yaml.safe_load(open(sys.argv[1], encoding='utf-8')), sys.stdout, default=str)"
    for python in (sys.executable, "/usr/bin/python3"):
        done = subprocess.run([python, "-c", code, path], cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False)
        if done.returncode == 0:
            return json.loads(done.stdout)
    check(False, f"{path}: {done.stderr}")
    return None


def citation():
    """Keys and values that the format 1.2.0 asks for, a DOI of each article, the libraries, and the same of codemeta.json."""
    data, meta = as_data("CITATION.cff"), json.loads(read("codemeta.json"))
    if data is None:
        return
    same(set(data) - {"doi", "date-released", "repository-code"}, CFF_KEYS, "keys of CITATION.cff")
    check(len(data["abstract"].split()) > 60, "an abstract")
    for reference in data["references"]:
        lacking = {"type", "title", "authors"} - set(reference)
        check(not lacking, f"CITATION.cff: {reference.get('title')} lacks {lacking}")
        if reference["type"] in ("article", "conference-paper"):
            check(DOI.fullmatch(reference.get("doi", "")), f"CITATION.cff: no DOI of {reference['title']}")
    software = {one["title"] for one in data["references"] if one["type"] == "software"}
    same(software, {"CGAL", "GMP", "MPFR", "FLINT"}, "software in CITATION.cff")
    check(software <= set(meta["softwareRequirements"]), "codemeta.json requires the same software")
    same((meta["version"], meta["license"].rsplit("/", 1)[1], [one["name"] for one in meta["author"]]),
         (data["version"], data["license"], [one["name"] for one in data["authors"]]), "codemeta.json and CITATION.cff")
    ours = {one["name"]: one.get("identifier", "").removeprefix("https://doi.org/") for one in meta["referencePublication"]}
    theirs = {one["title"]: one.get("doi", "") for one in data["references"] if one["title"] in ours}
    same(ours, theirs, "papers of codemeta.json")
    check(set(data["keywords"]) == set(meta["keywords"]), "keywords")


def licences(found):
    """The last stanza of .reuse/dep5 that matches a file has the licence that its head names; each licence has its text."""
    stanzas = [(re.search(r"^Files: ((?:.*)(?:\n .*)*)", part, re.M)[1].split(), re.search(r"^License: (.*)", part, re.M)[1])
               for part in read(".reuse", "dep5").split("\n\n")[1:]]
    names = sorted(name for _, name in stanzas)
    for name in set(names):
        check(len(read("LICENSES", name + ".txt")) > 900, name)
    heads = 0
    for path, text in found.items():
        named = re.search(r"SPDX-License-" r"Identifier: ([\w.-]+)", text[:1500])
        if named is None or path in QUOTED:
            continue
        heads += 1
        wanted = [licence for patterns, licence in stanzas if any(fnmatch.fnmatch(path, pattern) for pattern in patterns)][-1]
        same(named[1], wanted, f"licence in the head of {path} and in .reuse/dep5")
    check(heads > 900, f"{heads} files with a licence in their head")


def main():
    options(__doc__)
    found = texts(tracked())
    check(len(found) > 1500, f"{len(found)} files")
    stand_ins(found)
    citation()
    licences(found)
    checks.finish()


if __name__ == "__main__":
    main()
