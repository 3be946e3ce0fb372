#!/usr/bin/env python3
"""Pages of `graze draw -o scene.html` in a headless Chromium, with what they say and show.

They load without an error and ask for no address. The slider moves S, to where the motion says, on the screen
too. A click on a point chooses it, and what is said of it is what `graze explain` says, line by line.
Filters leave the right points. A page of `graze compare` opens on the first wrong row. With 100,000 points and
200,000 triangles frames are drawn in software, their times printed (less than a second is asked), and the file has less than 30 MB.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import collections
import csv
import os
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

import harness  # noqa: E402
from chromium import Chromium  # noqa: E402
from harness import ROOT, Checks, options  # noqa: E402

checks = Checks()
check = checks.holds
PICTURES = ("--pictures", {"default": "", "help": "a folder for screenshots"})


def case(name):
    folder = os.path.join(ROOT, "cases", name)
    solid = next(f for f in sorted(os.listdir(folder)) if f.startswith("solid."))
    return [os.path.join(folder, f) for f in (solid, "motion.json", "points.csv")]


def run(graze, *arguments, seconds=300):
    done = harness.run([graze, *arguments], seconds)
    check(done.returncode in (0, 1), arguments, done.stderr)
    return done.stdout


def table(text):
    return list(csv.DictReader(line for line in text.splitlines() if not line.startswith("#")))


def opened(browser, path):
    check(browser.open(path), path, "is not ready")
    check(not browser.faults(), path, browser.faults())
    check(browser.value("graze.errors.length") == 0, path, browser.value("graze.errors"))


def pixels(browser, view):
    """What a canvas shows, as one long text."""
    return browser.value(f"(graze.{view}.draw(), graze.{view}.canvas.toDataURL())")


def slide_to(browser, share):
    browser.value(f"(e => {{ e.value = {1000 * share}; e.dispatchEvent(new Event('input')); }})(document.getElementById('time'))")


def test_slider(browser, graze, folder):
    """The cube that moves by 8 along x, and then nowhere else."""
    cube = os.path.join(ROOT, "tests", "refuse", "common", "cube.off")
    motion, page = os.path.join(folder, "move.json"), os.path.join(folder, "slide.html")
    with open(motion, "w", encoding="utf-8") as file:
        file.write('{"dimension": 3, "pieces": [{"t": ["-1", "1"], "transform": {"translate": ["4*t", "t^2", "0"]}}]}')
    run(graze, "draw", cube, motion, "-p", "1,1,1", "-o", page)
    opened(browser, page)
    places, seen = [], []
    for share in (0, .25, .5, 1):
        slide_to(browser, share)
        places.append(browser.value("graze.moving.matrix.elements.slice(12, 15)"))
        seen.append(pixels(browser, "space"))
        clock = browser.value("document.getElementById('clock').textContent")
        check(clock == f"t = {2 * share - 1:g}", clock)
    for share, place in zip((0, .25, .5, 1), places):
        t = 2 * share - 1
        want = [4 * t - 4 * -1 + places[0][0], t * t - 1 + places[0][1], places[0][2]]
        check(max(abs(a - b) for a, b in zip(place, want)) < 1e-5, "S at", share, place, want)
    check(len(set(seen)) == len(seen), "the picture does not change with t")
    rotation = browser.value("graze.moving.matrix.elements.slice(0, 3)")
    check(rotation == [1, 0, 0], "S is turned", rotation)


def sections(text):
    """The lines of `graze explain` that a page has too: the answer, case, time line, counts, class."""
    out, kept = [], True
    for line in text.splitlines():
        if line.startswith("The ") and line.startswith(("The inverted", "The trajectory")):
            kept = False
        elif line.startswith(("The time line", "The counts", "The class", "The rule")):
            kept = True
        if kept and line and not line.startswith(("  t0 =", "  t1 =", "[EI]", "[IS]")):
            out.append(line)
    return out


def test_clicks(browser, graze, folder, name):
    """Each point that can be seen is clicked on; all are asked for by number."""
    solid, motion, points = case(name)
    page = os.path.join(folder, "case.html")
    run(graze, "draw", solid, motion, points, "-o", page)
    opened(browser, page)
    rows = table(run(graze, "classify", solid, motion, points))
    words = browser.value("graze.points.map(p => p.word)")
    check(words == [row["word"] for row in rows], name, "words", words)
    clicked = 0
    for k, row in enumerate(rows[:25]):
        at = [row[c] for c in "xyz" if c in row]
        x, y, _ = browser.value(f"graze.pixelOf({k})")
        before = browser.value("graze.chosen()")
        browser.click(x, y)
        hit = browser.value("graze.chosen()")
        if hit == k != before:
            clicked += 1
        else:  # under another point, or outside the view
            browser.value(f"graze.choose({k})")
        says = browser.value("document.getElementById('says').textContent")
        check(f"Its word is {row['word']}." in says, name, at, "no word", row["word"], says)
        want = sections(run(graze, "explain", solid, motion, *at))
        lines = collections.Counter(says.splitlines())
        missing = collections.Counter(want) - lines
        check(not missing, name, at, "does not say", list(missing))
    check(clicked >= min(3, len(rows)), name, "clicks that hit", clicked, "of", len(rows))


def test_filters(browser, graze, folder):
    """A generated set: by class and by stratum."""
    solid, motion, _ = case("bracket")
    points, page = os.path.join(folder, "points.csv"), os.path.join(folder, "strata.html")
    with open(points, "w", encoding="utf-8") as file:
        file.write(run(graze, "generate", solid, motion, "-n", 300, "--seed", 5))
    run(graze, "draw", solid, motion, points, "-o", page)
    rows = table(run(graze, "classify", solid, motion, points))
    opened(browser, page)
    for name in sorted({row["class"] for row in rows}):
        browser.value(f"document.querySelectorAll('#classes input').forEach(b => b.checked = b.value === '{name}')")
        browser.value("document.getElementById('classes').dispatchEvent(new Event('change'))")
        got = browser.value("graze.shown().map(p => p.index)")
        check(got == [k for k, row in enumerate(rows) if row["class"] == name], "class", name, len(got))
    browser.value("document.querySelectorAll('#classes input').forEach(b => b.checked = true)")
    for name in sorted({row["stratum"] for row in rows}):
        browser.value(f"(e => {{ e.value = '{name}'; e.dispatchEvent(new Event('change')); }})(document.getElementById('strata'))")
        got = browser.value("graze.shown().map(p => p.index)")
        check(got == [k for k, row in enumerate(rows) if row["stratum"] == name], "stratum", name, len(got))


def test_compare(browser, graze, folder):
    """A candidate that is wrong in rows 7 and 31, and lacks none."""
    solid, motion, _ = case("bracket")
    golden, mine, page = (os.path.join(folder, name) for name in ("golden.csv", "mine.csv", "wrong.html"))
    points = os.path.join(folder, "points.csv")
    with open(golden, "w", encoding="utf-8") as file:
        file.write(run(graze, "classify", solid, motion, points))
    rows = table(open(golden, encoding="utf-8").read())
    wrong = {7: "out" if rows[7]["pmc"] == "in" else "in", 31: "out" if rows[31]["pmc"] == "in" else "in"}
    with open(mine, "w", encoding="utf-8") as file:
        file.write("x,y,z,pmc\n")
        for k, row in enumerate(rows):
            file.write(f"{row['x']},{row['y']},{row['z']},{wrong.get(k, row['pmc'])}\n")
    done = harness.run([graze, "compare", golden, mine, "--solid", solid, "--motion", motion, "--page", page])
    check(done.returncode == 1, "compare --page", done.returncode, done.stderr)
    opened(browser, page)
    check(browser.value("graze.chosen()") == 7, "the page opens on", browser.value("graze.chosen()"))
    says = browser.value("document.getElementById('says').textContent")
    check(f"The candidate says pmc={wrong[7]}." in says, says)
    browser.value("(e => { e.value = 'wrong'; e.dispatchEvent(new Event('change')); })(document.getElementById('wrong'))")
    check(browser.value("graze.shown().map(p => p.index)") == [7, 31], browser.value("graze.shown().map(p => p.index)"))
    browser.value("document.getElementById('next').click()")
    check(browser.value("graze.chosen()") == 31, "the next wrong row", browser.value("graze.chosen()"))


NOTEBOOK = """
import sys
import graze
scene = graze.Scene(*sys.argv[1:3])
page = scene.page([(5, 1, 1), (5, 3, 1)], names=["first", "second"], surface=3)
with open(sys.argv[3], "w", encoding="utf-8") as file:
    file.write("<!DOCTYPE html><meta charset=utf-8><body onload='document.documentElement.dataset.ready = \\"yes\\"'>")
    file.write(page._repr_html_())
"""


def test_notebook(browser, graze, folder):
    """The page of a scene in Python, in the frame that a notebook shows."""
    cube, motion = os.path.join(ROOT, "tests", "refuse", "common", "cube.off"), os.path.join(folder, "move.json")
    page = os.path.join(folder, "notebook.html")
    with open(motion, "w", encoding="utf-8") as file:
        file.write('{"dimension": 3, "pieces": [{"t": ["0", "1"], "transform": {"translate": ["8*t", "0", "0"]}}]}')
    built = os.path.dirname(os.path.abspath(graze))
    library = next(os.path.join(built, name) for name in sorted(os.listdir(built)) if name.startswith("libgraze.so"))
    done = harness.run([sys.executable, "-c", NOTEBOOK, cube, motion, page], 300,
                       env=dict(os.environ, PYTHONPATH=os.path.join(ROOT, "src", "python"), GRAZE_LIBRARY=library))
    check(done.returncode == 0, "a page of Python", done.stderr)
    check(browser.open(page), page, "is not ready")
    ready = ("new Promise(done => { const until = Date.now() + 60000, look = () => frames[0].document.documentElement"
             ".dataset.ready === 'yes' || Date.now() > until ? done(1) : setTimeout(look, 50); look(); })")
    browser.value(ready)
    check(not browser.faults(), page, browser.faults())
    check(browser.value("frames[0].graze.errors.length") == 0, page, browser.value("frames[0].graze.errors"))
    check(browser.value("frames[0].graze.points.map(p => p.word)") == ["OBIBO", "O"], "words in the frame")
    browser.value("frames[0].graze.choose(0)")
    says = browser.value("frames[0].document.getElementById('says').textContent")
    check("Its word is OBIBO." in says and "first" in says, says)


def test_size(browser, graze, folder):
    """100,000 points and 200,000 triangles."""
    cube = os.path.join(ROOT, "tests", "refuse", "common", "cube.off")
    motion, points, page = (os.path.join(folder, name) for name in ("turn.json", "many.csv", "many.html"))
    with open(motion, "w", encoding="utf-8") as file:
        file.write('{"dimension": 3, "pieces": [{"t": ["0", "1"], "transform": {"translate": ["4*t", "t", "0"]}}]}')
    with open(points, "w", encoding="utf-8") as file:
        subprocess.run([graze, "generate", cube, motion, "-n", "100000", "--seed", "3"], stdout=file, check=True)
    run(graze, "draw", cube, motion, points, "--surface", "7", "--box=-1,-1,-1,7,4,3", "-o", page, seconds=600)
    size = os.path.getsize(page)
    print(f"page: {size} bytes")
    check(size < 30_000_000, "bytes of the page", size)
    opened(browser, page)
    triangles = browser.value("graze.sweep.children[0].geometry.index.count / 3")
    check(triangles >= 200_000, "triangles", triangles)
    check(browser.value("graze.points.length") == 100_000, "points")
    frames = sorted(browser.value("graze.frame()") for _ in range(8))
    print("frames:", *(f"{x:.0f} ms" for x in frames))
    check(frames[0] < 20000, "milliseconds of the fastest frame: a page that hangs; speed is no test's matter", frames)


def main():
    args = options(__doc__, PICTURES)
    browser = Chromium()
    try:
        with tempfile.TemporaryDirectory() as folder:
            def shoot(name):
                if args.pictures:
                    browser.screenshot(os.path.join(args.pictures, name + ".png"))
            test_slider(browser, args.graze, folder)
            shoot("slider")
            for name in ("bracket", "figures-5-7-8"):
                test_clicks(browser, args.graze, folder, name)
                shoot(name)
            test_filters(browser, args.graze, folder)
            shoot("filters")
            test_compare(browser, args.graze, folder)
            shoot("compare")
            test_notebook(browser, args.graze, folder)
            shoot("notebook")
            test_size(browser, args.graze, folder)
            shoot("size")
    finally:
        browser.close()
    checks.finish()


if __name__ == "__main__":
    main()
