#!/usr/bin/env python3
"""The page of `make checker-page` in a headless Chromium: it proves golden cases and refutes the forged tables of tests/check.

Each golden case that has a certificate is verified as graze-check verifies it, with the same words; of every --eighth the tables in which
a column, a line or the head is changed are refuted. Files that are chosen, packed ones too, are told apart; the page says which row is not
proved, and shows it; it asks for no address. A page of graze draw is taken for a table, and becomes one that proves its own points, and
refutes them where it shows another answer; so do pages of graze draw that are given certificate and checker, and one with its certificate is verified alone. By hand, and in test-long, since it needs emscripten.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import gzip
import json
import os
import subprocess
import sys
import tempfile
import time

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "..", "check"), os.path.join(HERE, "..", "lib")]

import golden  # noqa: E402  (sets the path of the cases)
import casefile  # noqa: E402
from chromium import Chromium  # noqa: E402
from harness import ROOT, Checks, options  # noqa: E402
from lib_certificate import REFUTED, Programs, VERIFIED  # noqa: E402

PROVING = ("bracket", "figures-5-7-8", "unsweep-figure2a", "closed-seam")
KINDS = ("solid", "motion", "certificate", "table")


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


class InPage:
    """graze-check as the page runs it, called as lib_certificate's Programs are."""

    def __init__(self, browser):
        self.browser = browser

    def check(self, *files):
        texts = {}
        for kind, path in zip(KINDS, files):
            texts[kind] = read(path)
        ending = os.path.splitext(files[0])[1]
        done = self.browser.value(f"check({json.dumps(texts)}, {json.dumps(ending)})")
        said = [[line for line in done["lines"] if line.startswith("graze-check: ") == is_error] for is_error in (False, True)]
        return done["status"], *("".join(line + "\n" for line in lines) for lines in said)


def answered(browser, given, asked):
    """Files given to the page's button, and a value of the page once it has its verdict."""
    root = browser.call("DOM.getDocument")["root"]["nodeId"]
    button = browser.call("DOM.querySelector", nodeId=root, selector="#choose")["nodeId"]
    browser.value("document.getElementById('said').className = document.getElementById('said').textContent = ''")
    browser.call("DOM.setFileInputFiles", nodeId=button, files=given)
    until = time.monotonic() + 60
    while time.monotonic() < until and not browser.value("document.getElementById('said').className"):
        time.sleep(.1)
    return browser.value(asked)


def chosen(browser, tally, graze, files, folder):
    """Files given to the page's button, the table and certificate packed; then a table with a row that is wrong, and a page."""
    packed = []
    for path in files[2:]:
        with open(path, "rb") as file, gzip.open(os.path.join(folder, os.path.basename(path) + ".gz"), "wb") as out:
            out.write(file.read())
        packed.append(out.name)

    def said(given):
        return answered(browser, given, "[document.getElementById('said').className, document.getElementById('said').textContent, "
                                        "document.getElementById('row').textContent]")

    shown = said([*files[:2], *packed])
    tally.holds(shown[0] == "verified" and shown[1].startswith("verified: "), shown)
    forged = os.path.join(folder, "forged.csv")
    with open(files[3], encoding="utf-8") as file:
        lines = file.read().splitlines()
    last = len(lines) - 2
    wrong = lines[last].replace(",in,", ",out,", 1) if ",in," in lines[last] else lines[last].replace(",on,", ",in,", 1)
    wrong = wrong if wrong != lines[last] else lines[last].replace(",out,", ",in,", 1)
    with open(forged, "w", encoding="utf-8") as file:
        file.write("\n".join([*lines[:last], wrong, lines[-1]]) + "\n")
    shown = said([forged])
    tally.holds(shown[0] == "refuted" and f"table.csv:{last + 1}" in shown[1] and shown[2] == wrong, shown, wrong)
    shown, link = said([drawn(graze, files, folder)]), browser.value("[...document.querySelectorAll('#carried a')].map(e => e.download)")
    tally.holds(shown[0] == "verified" and shown[2] == "" and link == ["scene.html"], shown, link)
    tally.holds(not browser.faults(), browser.faults())


def alone(browser, tally, graze, files, folder):
    """A page that has its files is verified without them, after one that has not; a file that is given besides takes the place of its own."""
    def said(given):
        return answered(browser, given, "[document.getElementById('said').className, [...document.querySelectorAll('#files td')].map(e => e.textContent)]")

    page = drawn(graze, files, folder, "--certificate", files[2])
    shown = said([page])
    ending = os.path.splitext(files[0])[1]
    tally.equal(shown, ["verified", ["solid", "solid" + ending, "motion", "motion", "certificate", "certificate", "table", "scene.html"]], files)
    other = os.path.join(folder, "other.json")
    with open(other, "w", encoding="utf-8") as file:
        file.write(read(files[1]) + " ")
    shown = said([other])
    tally.holds(shown[0] in ("refuted", "not-checked") and "other.json" in shown[1], files, shown)
    tally.holds(not browser.faults(), browser.faults())


def drawn(graze, files, folder, *more):
    """A page of graze draw that shows the points of the table."""
    scene = os.path.join(folder, "scene.html")
    unsweep = ["--operation", "unsweep"] if "\noperation unsweep\n" in read(files[2]) else []
    subprocess.run([graze, "draw", files[0], files[1], files[3], *unsweep, "--surface", "none", "-o", scene, *more], check=True)
    return scene


def proving(browser, tally, graze, checker, files, folder):
    """The page of a scene is a table to the checker, which makes of it a page with a button, as graze draw does; an answer that is changed in it is refuted."""
    scene, own = drawn(graze, files, folder), os.path.join(folder, "own.html")
    given = [json.dumps(read(path)) for path in files[:3]]
    texts = f"{{solid: {given[0]}, motion: {given[1]}, certificate: {given[2]}}}"
    rows = browser.value(f"tableOf(sceneOf({json.dumps(read(scene))}), {given[2]})").splitlines()
    count = int(rows[-1].split()[-1])
    wanted = [line.split(",") for line in read(files[3]).splitlines() if not line.startswith("#")]
    width = len(rows[-2].split(","))
    tally.equal([line.split(",") for line in rows[-2 - count:-1]], [line[:width] for line in wanted], files, "the table of a page")
    made = browser.value(f"carry({json.dumps(read(scene))}, {texts})")
    shown = read(scene).split('"lines":', 1)[1].split("\"")[1]
    at, word, numbers, rest = shown.split("|", 3)
    wrong = "|".join([at, ("I" if word != "I" else "O"), numbers, rest])
    own_page = read(drawn(graze, files, folder, "--certificate", files[2], "--checker", checker))
    tally.equal((made.count(json.dumps(shown)), own_page.count(json.dumps(shown))), (1, 1), files, shown)
    good, bad = ("verified", f"verified: {count} rows"), ("refuted", "differs from the certificate in the word")
    for text, want in ((made, good), (own_page, good), *((page.replace(json.dumps(shown), json.dumps(wrong)), bad) for page in (made, own_page))):
        with open(own, "w", encoding="utf-8") as file:
            file.write(text)
        tally.holds(browser.open(own), files, "the page is ready")
        said = browser.value("(async () => { await document.getElementById('prove').onclick(); const e = document.querySelector('header output'); "
                             "return [e.id, e.textContent]; })()")
        tally.holds(said[0] == want[0] and want[1] in said[1], files, said, want)
        tally.holds(not browser.faults(), browser.faults())


def main():
    args = options(__doc__, ("--eighth", {"type": int, "default": 8, "help": "forged tables of every Nth case"}))
    build, tally, programs = os.path.dirname(os.path.abspath(args.graze)), Checks(), Programs(args.graze)
    subprocess.run(["make", "-s", f"B={os.path.relpath(build, ROOT)}", "checker-page"], cwd=ROOT, check=True)
    browser = Chromium()
    try:
        checker = os.path.join(build, "checker-page", "graze-check.html")
        tally.holds(browser.open(checker), "the page is ready")
        page = InPage(browser)
        with tempfile.TemporaryDirectory() as folder:
            for number, name in enumerate(casefile.names()):
                case = casefile.Case(name)
                files, table, _ = golden.certified(programs, case, folder)
                got, wanted = page.check(*files), programs.check(*files)
                tally.equal((got[0], got[1]), (VERIFIED, wanted[1]), name, got)
                if number % args.eighth == 0:
                    golden.check_tables(tally, page, case, files[:3], table)
                if name == "bracket":
                    kept = tempfile.mkdtemp(dir=folder)
                    chosen(browser, tally, args.graze, files, kept)
                if name in PROVING:
                    tally.holds(browser.open(checker), "the page is ready")
                    alone(browser, tally, args.graze, files, folder)
                    proving(browser, tally, args.graze, checker, files, folder)
                    tally.holds(browser.open(checker), "the page is ready")
        tally.holds(tally.passed > 500, f"{tally.passed} checks, {REFUTED}")
    finally:
        browser.close()
    tally.finish()


if __name__ == "__main__":
    main()
