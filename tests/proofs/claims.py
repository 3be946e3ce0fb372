#!/usr/bin/env python3
# suite
"""The numbers of claims: each stands once and in order, is cited somewhere, and none is cited that is not there;
each claim says whether it is machine-checked, by theorems that exist and are among the printed statements. The
index has each claim once, under its heading, with sources that cite it and exactly the suites whose rows in
tests/README.md do; src/README.md and the index count them as they are.

Needs no Coq; make proofs checks the theorems themselves.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import glob
import os
import re
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from coq import ROOT, SOURCE, Checks, harness, sources, without_comments  # noqa: E402

DOCUMENTS = ("proofs/claims.md", "proofs/filter.md", "proofs/separation.md", "proofs/topology.md", "proofs/membership.md",
             "proofs/envelope.md", "proofs/doubles.md", "proofs/distance.md", "proofs/closure.md",
             "proofs/snap.md", "proofs/cells.md", "proofs/events.md", "proofs/bricks.md", "proofs/gaps.md",
             "proofs/maps.md", "proofs/roots.md", "proofs/slabs.md", "proofs/curved.md", "proofs/surfaces.md", "proofs/collision.md",
             "proofs/dangling.md", "proofs/mesh.md", "proofs/judging.md", "proofs/flows.md",
             "proofs/outline.md")
HEADING = re.compile(r"^## C(\d+) .*?(?=^## C|^# |\Z)", re.M | re.S)
CERTIFICATE = re.compile(r"^## (K\d+) .*?(?=^## K|^# |\Z)", re.M | re.S)
# Outside proofs/ a number is cited behind the name of its document, perhaps over the end of a comment's line.
CITED = re.compile(r"(?:claims|filter|separation|topology|membership|doubles|envelope|distance|closure|snap|cells|events|bricks|gaps|maps|roots|slabs|curved|surfaces|collision|dangling|mesh|judging|flows|outline)\.md\)?,?[\s*/#]*((?:C\d+(?:[\s*/#]*(?:,|;|and|to)?[\s*/#]+(?=(?:and )?C\d)(?:and )?)?)+)")
CHECKED = re.compile(r"^\*Machine-checked:\* (.*?)(?=\n\n|\s*\Z)", re.M | re.S)
ELSEWHERE = ("src/**/*.[ch]", "src/**/*.[ch]pp", "src/**/*.md", "include/**/*.h", "tests/**/*.[ch]", "tests/**/*.py",
             "tests/**/*.cpp", "tests/**/*.h", "tests/mutants.txt", "cases/**/*.md", "*.md")


def read(path):
    with open(os.path.join(ROOT, path), encoding="utf-8") as file:
        return file.read()


def numbers(text):
    return {int(n) for n in re.findall(r"\bC(\d+)\b", text)}


def sections(checks):
    """Number -> text of the claim."""
    out = {}
    for document in DOCUMENTS:
        last = 0
        for match in HEADING.finditer(read(document)):
            number = int(match.group(1))
            checks.holds(number not in out, f"{document}: C{number} stands twice")
            checks.holds(number > last, f"{document}: C{number} comes after C{last}")
            last = number
            out[number] = match.group()
    checks.holds(sorted(out) == list(range(1, len(out) + 1)), "a number is missing", set(range(1, len(out) + 1)) - set(out))
    return out


def citations(claims):
    """Path -> numbers cited there; a claim's own section does not count for it."""
    out = {}
    for document in DOCUMENTS:
        rest = HEADING.sub("", read(document))
        out[document] = numbers(rest)
    for number, text in claims.items():
        out[f"claim C{number}"] = numbers(text) - {number}
    for path in sorted(glob.glob(os.path.join(ROOT, "proofs", "coq", "*"))):
        name = os.path.relpath(path, ROOT)
        if name.endswith((".v", ".md")):
            out[name] = numbers(read(name))
    for pattern in ELSEWHERE:
        for path in glob.glob(os.path.join(ROOT, pattern), recursive=True):
            name = os.path.relpath(path, ROOT)
            if not name.startswith("tests/proofs/"):
                out[name] = {n for group in CITED.findall(read(name)) for n in numbers(group)}
    return out


def theorems():
    """File -> names proved in it, and the names that statements.v prints."""
    proved = {name: set(re.findall(r"^\s*(?:Theorem|Lemma)\s+(\w+)", without_comments(read("proofs/coq/" + name)), re.M))
              for name in sources()}
    return proved, set(re.findall(r"^Check (\w+)\.", read("proofs/coq/statements.v"), re.M))


def check_machine(checks, number, text, proved, printed):
    found = CHECKED.findall(text)
    if not checks.holds(len(found) == 1, f"{number}: expected one line *Machine-checked:*, found {len(found)}"):
        return
    words = re.findall(r"`([^`]+)`", found[0])
    checks.holds(bool(words) or found[0] == "no.", f"{number}: expected `no.` or theorems: {found[0]}")
    file = None
    for word in words:
        if word.endswith(".v"):
            file = word
            checks.holds(file in proved, f"{number}: there is no proofs/coq/{file}")
        else:
            checks.holds(word in proved.get(file, ()), f"{number}: {file} does not prove {word}")
            checks.holds(word in printed, f"{number}: statements.v does not print {word}")


def cited_in(text):
    """The numbers of a text, those of `C24 to C27` too."""
    text = re.sub(r"[\s*]+", " ", text)
    ranges = (range(int(a), int(b) + 1) for a, b in re.findall(r"\bC(\d+) to C(\d+)\b", text))
    return numbers(text).union(*ranges)


def is_code(path):
    return path.endswith((".c", ".h", ".cpp", ".hpp")) and not path.startswith("src/check/")


def check_row(checks, number, line, claim, suites, holders):
    """A row of the index: the claim's heading and page, sources, suites, whether Coq proves it."""
    link, code, tests, coq = [cell.strip() for cell in line.strip("| \n").split(" | ")]
    page, anchor = re.fullmatch(r"\[C\d+ .*\]\(([a-z]+\.md)#([\w-]+)\)", link).groups()
    heading = re.match(r"## (.*)", claim).group(1)
    checks.equal(anchor, re.sub(r"[^\w -]", "", heading.lower()).replace(" ", "-"), f"C{number}: anchor")
    checks.holds(claim in read("proofs/" + page), f"C{number} is not proved in {page}")
    checks.holds(heading.startswith(link[1:link.index("]")]), f"C{number}: {link} is not its heading")
    named = re.findall(r"`([^`]+)`", code)
    for path in named:
        checks.holds(path in holders and number in holders[path], f"C{number}: {path} does not cite it")
    checks.equal(bool(named), any(number in found for found in holders.values()), f"C{number}: sources cite it")
    checks.equal(set(re.findall(r"`([^`]+)`", tests)), {s for s in suites if number in suites[s]}, f"C{number}: suites")
    proved = CHECKED.findall(claim)[0]
    checks.equal(coq, "no" if proved == "no." else "in part" if proved.startswith("in part") else "whole", f"C{number}")
    return coq


def check_index(checks, claims):
    suites = {name: cited_in(text) for name, text in
              re.findall(r"^\| `([\w/.]+)` \|(.*)", read("tests/README.md"), re.M)}
    found = (os.path.relpath(path, ROOT) for path in glob.glob(os.path.join(ROOT, "src", "**", "*"), recursive=True))
    holders = {path: cited_in(read(path)) for path in found if is_code(path)}
    rows = re.findall(r"^(\| \[C(\d+) .*)", read("proofs/index.md"), re.M)
    checks.equal(sorted(int(number) for _, number in rows), sorted(claims), "claims of proofs/index.md, each once")
    kinds = [check_row(checks, int(n), line, claims[int(n)], suites, holders) for line, n in rows if int(n) in claims]
    counts = str(len(claims)), str(kinds.count("whole")), str(kinds.count("in part"))
    for page, form in (("proofs/index.md", r"The (\d+) claims by subject.*: (\d+) whole and (\d+) in part"),
                       ("src/README.md", r"(\d+) claims by subject, (\d+) \[machine-checked\]\S* whole, (\d+) in part")):
        checks.equal(re.findall(form, read(page)), [counts], f"{page} counts the claims")


def main():
    harness.options(__doc__)
    checks = Checks()
    claims = sections(checks)
    checks.holds(len(claims) >= 50, f"{len(claims)} claims")
    cited = citations(claims)
    everywhere = set().union(*cited.values())
    for path, found in cited.items():
        for number in sorted(found):
            checks.holds(number in claims, f"{path}: cites C{number}, which is not there")
    for number in claims:
        checks.holds(number in everywhere, f"C{number} is cited nowhere")
    check_index(checks, claims)
    proved, printed = theorems()
    for number, text in claims.items():
        check_machine(checks, f"C{number}", text, proved, printed)
    certificate = {m.group(1): m.group() for m in CERTIFICATE.finditer(read("proofs/certificate.md"))}
    checks.holds(len(certificate) >= 14, f"{len(certificate)} claims on certificates")
    for number, text in certificate.items():
        check_machine(checks, number, text, proved, printed)
    all_proved = set().union(*proved.values())
    for name in sorted(printed):
        checks.holds(name in all_proved, f"statements.v prints {name}, which is not proved here")
    readme = read("proofs/coq/README.md")
    for name in sorted(os.listdir(SOURCE)):
        checks.holds(f"({name})" in readme or name == "README.md", f"proofs/coq/README.md does not name {name}")
    for name in re.findall(r"\]\(([\w.]+\.(?:v|txt))\)", readme):
        checks.holds(os.path.exists(os.path.join(SOURCE, name)), f"proofs/coq/README.md: there is no {name}")
    for name in set(re.findall(r"`([a-z]\w+)`", readme)) - {"coq", "coqchk"}:
        known = name in all_proved or re.search(rf"\b{name}\b", "".join(read("proofs/coq/" + f) for f in sources())
                                                + read("proofs/coq/statements.txt"))
        checks.holds(known, f"proofs/coq/README.md names {name}, which is nowhere in the proofs")
    checks.finish()


if __name__ == "__main__":
    main()
