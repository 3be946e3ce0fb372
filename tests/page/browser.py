#!/usr/bin/env python3
"""Pages of `graze draw -o scene.html` in a headless Chromium, with what they say and show.

They load without an error and ask for no address. The slider moves S, to where the motion says, on the screen
too. A click on a point chooses it, and what is said of it is what `graze explain` says, line by line, once its values
are opened by clicks; before, roots are decimals. The plane is filled in the colours of the classes that `graze classify`
finds. Axes have round numbers, points their names, contacts their times; one trajectory is drawn. The theme is that
of the system until it is switched. Keys move time, points and views. On a phone one part is seen at a time and nothing
sticks out. Filters leave the right points. A page of `graze compare` opens on the first wrong row. One of 100,000
points opens on those that are `on`, says how many of them it draws, and has less than 20 MB; times of frames are printed.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import collections
import csv
import json
import os
import subprocess
import sys
import tempfile
import time

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


def open_moved(browser, graze, folder, solid, x, y, *arguments):
    """Open the page of a planar solid, WKT or a tree, that is moved from t = 0 to 1 by (x, y)."""
    paths = [os.path.join(folder, name) for name in ("moved.csg.json" if solid.startswith("{") else "moved.wkt", "moved.json", "moved.html")]
    motion = {"dimension": 2, "pieces": [{"t": [0, 1], "transform": {"translate": [x, y]}}]}
    for path, text in zip(paths, (solid, json.dumps(motion))):
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
    run(graze, "draw", *paths[:2], *arguments, "-o", paths[2])
    opened(browser, paths[2])


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
            out.append(" ".join(line.split()))
    return out


def said(browser):
    """The lines of the panel, as they are seen."""
    texts = browser.value("[...document.querySelectorAll('#says .line')].map(e => e.innerText.replace('▸', ''))")
    return [" ".join(text.split()) for text in texts]


def open_values(browser):
    browser.value("document.querySelectorAll('#says .value:not(.open)').forEach(e => e.click())")


def test_clicks(browser, graze, folder, name):
    """Each point that can be seen is clicked on; all are asked for by number."""
    solid, motion, points = case(name)
    page = os.path.join(folder, "case.html")
    run(graze, "draw", solid, motion, points, "-o", page)
    opened(browser, page)
    rows = table(run(graze, "classify", solid, motion, points))
    words = browser.value("Array.from({length: graze.count}, (_, k) => graze.point(k).word)")
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
        check(any(f"Its word is {row['word']}." in line for line in said(browser)), name, at, "no word", row["word"], said(browser))
        check(not any("the one root of" in line for line in said(browser)), name, at, "a root is not closed", said(browser))
        want = sections(run(graze, "explain", solid, motion, *at))
        open_values(browser)
        missing = collections.Counter(want) - collections.Counter(said(browser))
        check(not missing, name, at, "does not say", list(missing), said(browser))
    check(clicked >= min(3, len(rows)), name, "clicks that hit", clicked, "of", len(rows))


def test_root(browser, graze, folder):
    """A point that a turning cube meets at roots: a decimal, and at a click the polynomial and its interval."""
    cube = os.path.join(ROOT, "tests", "refuse", "common", "cube.off")
    motion, page = os.path.join(folder, "turn.json"), os.path.join(folder, "root.html")
    with open(motion, "w", encoding="utf-8") as file:
        file.write('{"dimension": 3, "pieces": [{"t": ["0", "1"], "transform": {"rotate": {"axis": ["0", "0", "1"], "tan_half": "t"}}}]}')
    run(graze, "draw", cube, motion, "-p", "1,5/2,1", "--surface", "none", "-o", page)
    opened(browser, page)
    # The corner (2, 2) has radius sqrt 8 > |P|; P enters through x = 2 or y = 2 in the turned cube: at a root.
    values = browser.value("[...document.querySelectorAll('#says .value')].map(e => e.textContent)")
    check(values and all(text.startswith("≈ 0.") for text in values), "closed roots", values, said(browser))
    check(any("have points in common" in line for line in said(browser)), "S at both ends", said(browser))
    x, y = browser.value("(r => [r.x + r.width / 2, r.y + r.height / 2])(document.querySelector('#says .value').getBoundingClientRect())")
    browser.click(x, y)
    shown = browser.value("document.querySelector('#says .value').innerText")
    check("the one root of" in shown and "*t" in shown and "between" in shown, "an opened root", shown)


def test_late(browser, graze, folder):
    """A minute of the year 2023: the cube that moves by 8 along x in it passes (5, 1, 1) from 60 * 3/8 s to 60 * 5/8 s
    after t0; it comes to (1, 5/2, 1) while it turns too, at roots."""
    cube = os.path.join(ROOT, "tests", "refuse", "common", "cube.off")
    motion, page = os.path.join(folder, "late.json"), os.path.join(folder, "late.html")
    with open(motion, "w", encoding="utf-8") as file:
        file.write('{"dimension": 3, "pieces": [{"t": ["1700000000", "1700000060"], "transform": {"translate": ["8/60*(t - 1700000000)", "0", "0"]}}]}')
    run(graze, "draw", cube, motion, "-p", "5,1,1", "--surface", "none", "-o", page)
    opened(browser, page)
    slide_to(browser, .5)
    check(browser.value("document.getElementById('clock').innerText") == "t − t0 = 30", "the clock", browser.value("document.getElementById('clock').innerText"))
    check("t0 = 1700000000" in browser.value("document.getElementById('remark').innerText"), "t0 is named")
    check("t0 + 22.5" in browser.value("document.getElementById('says').innerText"), "the time line", said(browser))
    labels = [text for text, *_ in browser.value(f"{WRITTEN}('standing')")]
    check("t − t0 = 22.5" in labels and "t − t0 = 37.5" in labels, "times of contacts", labels)
    open_values(browser)
    check(any("1700000022.5" in line for line in said(browser)), "an opened time", said(browser))
    with open(motion, "w", encoding="utf-8") as file:
        file.write('{"dimension": 3, "pieces": [{"t": ["1700000000", "1700000060"], "transform": {"rotate": {"axis": ["0", "0", "1"], '
                   '"tan_half": "1/60*(t - 1700000000)"}}}]}')
    run(graze, "draw", cube, motion, "-p", "1,5/2,1", "--surface", "none", "-o", page)
    opened(browser, page)
    # The point comes down to y = 2 in the cube: 5/2 cos a - sin a = 2 with u = tan(a/2), at x = cos a + 5/2 sin a < 2.
    value = browser.value("document.querySelector('#says .value').textContent")
    u = float(value.replace("≈ t0 + ", "")) / 60
    check(value.startswith("≈ t0 + ") and abs(2.5 * (1 - u * u) - 2 * u - 2 * (1 + u * u)) < 1e-10, "a root", value, u)


COLOUR = """(where => { const c = document.createElement('canvas'), v = graze.space; v.draw(); c.width = v.canvas.width; c.height = v.canvas.height;
  const x = c.getContext('2d'); x.drawImage(v.canvas, 0, 0); const at = v.canvas.getBoundingClientRect();
  return where.map(([a, b]) => { const [u, w] = v.spot([a, b, 0]), p = x.getImageData(Math.round(u * c.width / at.width), Math.round(w * c.height / at.height), 1, 1).data;
  return '#' + [...p.slice(0, 3)].map(k => k.toString(16).padStart(2, '0')).join(''); }); })"""


def test_fill(browser, graze, folder):
    """The U of the figures: places of the plane away from all lines have the colour of their class, on the screen."""
    solid, motion, _ = case("figures-5-7-8")
    page = os.path.join(folder, "fill.html")
    run(graze, "draw", solid, motion, "-o", page)
    opened(browser, page)
    for box in ("show-solid", "show-sweep"):
        browser.value(f"document.getElementById('{box}').click()")
    low_x, low_y, high_x, high_y = browser.value("JSON.parse(document.getElementById('scene').textContent).box")
    places = [(k * 1.3 + .37, m * .7 - 2.81) for k in range(20) for m in range(11)]
    text = "".join(f"{x:.2f},{y:.2f}\n" for x, y in places)
    near = "".join(f"{x + u:.2f},{y + v:.2f}\n" for x, y in places for u in (-.06, .06) for v in (-.06, .06))
    rows = [row["class"] for row in table(harness.run([graze, "classify", solid, motion, "-"], 300, input=text + near).stdout)]
    sure = [k for k in range(len(places)) if set(rows[len(places) + 4 * k:len(places) + 4 * k + 4]) == {rows[k]}]
    where = [[places[k][0] - (low_x + high_x) / 2, places[k][1] - (low_y + high_y) / 2] for k in sure]
    colours = {"regular": "#56b4e9", "fold": "#e69f00", "exterior": browser.value("getComputedStyle(document.documentElement).getPropertyValue('--paper').trim()")}
    got = browser.value(f"{COLOUR}({where})")
    check(len({rows[k] for k in sure}) >= 3 and len(sure) > 100, "classes", len(sure))
    for k, colour in zip(sure, got):
        off = max(abs(int(colour[i:i + 2], 16) - int(colours[rows[k]][i:i + 2], 16)) for i in (1, 3, 5))
        check(off <= 3, places[k], rows[k], colour)


WRITTEN = """(name => { const texts = [], v = graze[name], own = CanvasRenderingContext2D.prototype.fillText;
  CanvasRenderingContext2D.prototype.fillText = function (text, x, y) { texts.push([text, x, y]); return own.call(this, text, x, y); };
  v.draw(); CanvasRenderingContext2D.prototype.fillText = own; return texts; })"""


def test_texts(browser, graze, folder):
    """Axes, names and times are written where they belong; of trajectories the chosen point's alone is drawn."""
    for name in ("figures-5-7-8", "bracket"):
        solid, motion, points = case(name)
        page = os.path.join(folder, "texts.html")
        run(graze, "draw", solid, motion, points, "-o", page)
        opened(browser, page)
        written = browser.value(f"{WRITTEN}('space')")
        texts = {text for text, *_ in written}
        with open(points, encoding="utf-8") as file:
            names = [row["id"] for row in csv.DictReader(file)]
        check({"x", "y"} <= texts and len(texts & {"0", "5", "10"}) >= 2, name, "axes", texts)
        check(len(texts & set(names)) >= .4 * len(names) and names[0] in texts, name, "names", texts)
        for k, label in enumerate(names[:8]):
            spot = browser.value(f"graze.space.spot(graze.pixelOf && graze.point({k}).place.map((x, i) => x - (b => (b[i] + b[i + b.length / 2]) / 2)"
                                 "(JSON.parse(document.getElementById('scene').textContent).box)).concat([0]).slice(0, 3))")
            near = [1 for text, x, y in written if text == label and abs(x - spot[0]) < 160 and abs(y - spot[1]) < 40]
            check(near or label not in texts, name, label, "is written elsewhere", spot)
        times = [text for text, *_ in browser.value(f"{WRITTEN}('standing')") if text.startswith("t = ")]
        check(times, name, "times of contacts")
        for k in (0, 1):
            browser.value(f"graze.choose({k})")
            parts = browser.value("graze.trails.children.length")
            most = browser.value(f"(p => p.word.length + p.contacts.length)(graze.point({k}))")
            check(0 < parts <= most, name, "one trajectory", parts, most)
        for part, words in (("#classes", "regular"), ("#signs", "inside S")):
            box = browser.value(f"(r => [r.left, r.top, r.right, r.bottom])(document.querySelector('{part}').getBoundingClientRect())")
            check(0 <= box[0] < box[2] <= 1400 and 0 <= box[1] < box[3] <= 800, name, "the legend is in sight", part, box)
            check(words in browser.value(f"document.querySelector('{part}').innerText"), name, part)


def brightness(browser):
    colour = browser.value(f"{COLOUR}([[1e-9, 1e-9]])")[0]
    paper = browser.value("getComputedStyle(document.body).backgroundColor")
    return sum(int(x) for x in paper[4:-1].split(",")) / 3, colour


def test_theme_and_keys(browser, graze, folder):
    solid, motion, points = case("figures-5-7-8")
    page = os.path.join(folder, "keys.html")
    run(graze, "draw", solid, motion, points, "-o", page)
    for system in ("light", "dark"):
        browser.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": system}])
        opened(browser, page)
        light, _ = brightness(browser)
        check((light > 200) == (system == "light") and (light < 60) == (system == "dark"), "the theme of the system", system, light)
        before = pixels(browser, "space")
        browser.value("document.getElementById('theme').click()")
        other, _ = brightness(browser)
        check((other > 200) == (system == "dark") and pixels(browser, "space") != before, "the theme is switched", system, other)
    browser.call("Emulation.setEmulatedMedia", features=[])
    opened(browser, page)

    def clock():
        return browser.value("document.getElementById('clock').textContent")
    check(browser.value("graze.chosen()") == 0 and clock() == "t = 0", "the page opens on", browser.value("graze.chosen()"), clock())
    browser.key("ArrowRight")
    check(clock() == "t = 0.02", "one hundredth of the motion", clock())
    browser.key(".")
    check(clock() == "t = 0.2", "the next contact", clock())  # P1, (10, 1): the front at 6 + 20 t
    browser.key("End")
    check(clock() == "t = 2", "the end", clock())
    browser.key("n")
    check(browser.value("graze.chosen()") == 1, "the next point", browser.value("graze.chosen()"))
    before = pixels(browser, "space")
    browser.key("+")
    check(pixels(browser, "space") != before, "nearer")
    browser.key("f")
    check(pixels(browser, "space") == before, "fit")
    browser.key("?")
    check(browser.value("document.getElementById('keys').getBoundingClientRect().width") > 100, "the keys are shown")


def check_names(browser, name):
    """No name lies beneath the legend, the title or the button; some are written."""
    parts, names = browser.value("""(box => [[...document.querySelectorAll('#world-view > :not(canvas)')].map(e => e.getBoundingClientRect())
      .map(r => [r.left, r.top - box.top, r.right, r.bottom - box.top]), graze.space.labels.written])(graze.space.canvas.getBoundingClientRect())""")
    check(len(parts) == 3 and len(names) > 6, name, "parts and names", parts, names)
    for text, (x0, y0, x1, y1) in names:
        check(0 <= x0 < x1 <= 400, name, text, "leaves the page", x0, x1)
        for u0, v0, u1, v1 in parts:
            check(x1 <= u0 or u1 <= x0 or y1 <= v0 or v1 <= y0, name, text, "is beneath a part", (x0, y0, x1, y1), (u0, v0, u1, v1))


def test_narrow(browser, graze, folder):
    """400 pixels wide: the legend is closed at first, and open it has no names beneath."""
    browser.call("Emulation.setDeviceMetricsOverride", width=400, height=760, deviceScaleFactor=1, mobile=True)
    for name in ("curved-parabola", "bracket"):
        page = os.path.join(folder, "narrow.html")
        run(graze, "draw", *case(name), "-o", page)
        opened(browser, page)
        check(not browser.value("document.querySelector('#world-view .legend').open"), name, "the legend is open")
        check_names(browser, name)
        browser.value("new Promise(done => { document.querySelector('#world-view summary').click(); setTimeout(() => requestAnimationFrame(done), 100); })")
        check(browser.value("document.querySelector('#world-view .legend').open"), name, "the legend is closed")
        check_names(browser, name)
    browser.call("Emulation.setDeviceMetricsOverride", width=1400, height=800, deviceScaleFactor=1, mobile=False)


def test_beside(browser, graze, folder):
    """A point 1 above the box of a sweep 3 high and 12 wide is in sight, one 100 above is not."""
    open_moved(browser, graze, folder, "POLYGON ((0 0, 4 0, 4 3, 0 3, 0 0))", "8*t", "0", "-p", "6,4", "-p", "6,103", "-p", "6,1")
    top = browser.value("graze.space.canvas.getBoundingClientRect().top")
    seen = [browser.value(f"graze.pixelOf({k})")[1] - top > 6 for k in range(3)]
    check(seen == [True, False, True], "points in sight", seen)


def test_phone(browser, graze, folder):
    solid, motion, points = case("bracket")
    page = os.path.join(folder, "phone.html")
    run(graze, "draw", solid, motion, points, "-o", page)
    browser.call("Emulation.setDeviceMetricsOverride", width=390, height=800, deviceScaleFactor=2, mobile=True)
    opened(browser, page)
    visible = "['world-view', 'body-view', 'says'].filter(id => getComputedStyle(document.getElementById(id)).visibility === 'visible')"
    for k, name in enumerate(("world-view", "body-view", "says")):
        browser.value(f"document.querySelectorAll('#tabs button')[{k}].click()")
        check(browser.value(visible) == [name], "the part that is seen", name, browser.value(visible))
        wide, high = browser.value("[document.documentElement.scrollWidth, document.documentElement.scrollHeight]")
        check(wide <= 390 and high <= 800, "the page sticks out", wide, high)
        box = browser.value("(r => [r.left, r.top, r.right, r.bottom])(document.getElementById('time').getBoundingClientRect())")
        check(box[2] - box[0] > 100 and box[3] <= 800, "the slider", box)
    browser.value("document.querySelectorAll('#tabs button')[0].click()")
    x, y, _ = browser.value("graze.pixelOf(5)")
    browser.click(x, y)
    check(browser.value("graze.chosen()") >= 0, "a tap chooses")
    browser.call("Emulation.setDeviceMetricsOverride", width=1400, height=800, deviceScaleFactor=1, mobile=False)


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
        got = browser.value("graze.shown()")
        check(got == [k for k, row in enumerate(rows) if row["class"] == name], "class", name, len(got))
    browser.value("document.querySelectorAll('#classes input').forEach(b => b.checked = true)")
    for name in sorted({row["stratum"] for row in rows}):
        browser.value(f"(e => {{ e.value = '{name}'; e.dispatchEvent(new Event('change')); }})(document.getElementById('strata'))")
        got = browser.value("graze.shown()")
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
    check(f"The candidate says pmc={wrong[7]}." in said(browser), said(browser))
    browser.value("(e => { e.value = 'wrong'; e.dispatchEvent(new Event('change')); })(document.getElementById('wrong'))")
    check(browser.value("graze.shown()") == [7, 31], browser.value("graze.shown()"))
    browser.value("document.getElementById('next').click()")
    check(browser.value("graze.chosen()") == 31, "the next wrong row", browser.value("graze.chosen()"))
    browser.value("(e => { e.value = 'all'; e.dispatchEvent(new Event('change')); })(document.getElementById('wrong'))")
    (right, small), (bad, large), _ = browser.value("graze.sizes()")
    check((right, bad) == (len(rows) - 2, 2) and large >= 3 * small, "wrong points are large, right ones small", right, small, bad, large)
    named = {text for text, *_ in browser.value(f"{WRITTEN}('space')")}
    check({"8", "32"} <= named and not {str(k) for k in range(41, len(rows) + 1)} & named, "names of wrong rows alone", named)


def test_loading(browser, graze, folder):
    """Before the script has run the page says so, over all else; then no longer."""
    solid, motion, points = case("figures-5-7-8")
    page = os.path.join(folder, "loading.html")
    run(graze, "draw", solid, motion, points, "--grid", 20, "-o", page)
    top = "(e => e && [e.innerText, e === document.elementFromPoint(innerWidth / 2, innerHeight / 2)])(document.getElementById('loading'))"
    browser.call("Emulation.setScriptExecutionDisabled", value=True)
    browser.call("Page.navigate", url="file://" + page)
    until = time.monotonic() + 60
    while browser.value("location.pathname + document.readyState") != page + "complete" and time.monotonic() < until:
        time.sleep(.05)
    check(browser.value(top) == ["loading", True], "without a script", browser.value(top))
    browser.call("Emulation.setScriptExecutionDisabled", value=False)
    opened(browser, page)
    check(browser.value(top) is None, "with the script", browser.value(top))


def test_rings(browser, graze, folder):
    """A disk in the hole of a ring, 1 < r < 2 and r < 1/2, is filled where it is solid."""
    ring = '{"dimension": 2, "solid": {"union": [{"difference": [{"ball": {"radius": 2}}, {"ball": {"radius": 1}}]}, {"ball": {"radius": "1/2"}}]}}'
    open_moved(browser, graze, folder, ring, "8*t", "0", "--grid", 20)
    paper, filled = browser.value("['paper', 'solid'].map(n => getComputedStyle(document.documentElement).getPropertyValue('--' + n).trim())")
    for radius, want in ((0, filled), (.4, filled), (.75, paper), (1.2, filled), (1.8, filled), (2.2, paper)):
        for way in ((1, 0), (0, 1), (-.6, .8)):
            got = browser.value(COLOUR.replace("graze.space", "graze.standing") + f"([{[radius * x for x in way]}])")[0]
            off = max(abs(int(got[k:k + 2], 16) - int(want[k:k + 2], 16)) for k in (1, 3, 5))
            check(off <= 3, "the colour at", radius, way, got, want)


def test_slides(browser, graze, folder):
    """The U: (6, 3) slides along two edges between vertices, (6, 1) crosses, slides along one and crosses again."""
    open_moved(browser, graze, folder, "POLYGON ((0 0, 4 0, 4 3, 3 3, 3 1, 1 1, 1 3, 0 3, 0 0))", "8*t", "0", "-p", "6,3", "-p", "6,1", "--grid", 20)
    for k, want in enumerate((["Sv", "Sv", "Te", "Sv", "Sv", "Te"], ["Xe", "Sv", "Sv", "Te", "Xe"])):
        browser.value(f"graze.choose({k})")
        got = browser.value("graze.trails.children.map(e => e.name).filter(Boolean)")
        check(got == want, "signs of the trajectory", k, got, want)


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
    check(browser.value("[0, 1].map(k => frames[0].graze.point(k).word)") == ["OBIBO", "O"], "words in the frame")
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
    check(size < 20_000_000, "bytes of the page", size)
    opened(browser, page)
    triangles = browser.value("graze.sweep.children[0].geometry.index.count / 3")
    check(triangles >= 200_000, "triangles", triangles)
    check(browser.value("graze.count") == 100_000, "points")
    rows = table(run(graze, "classify", cube, motion, points))
    on = [k for k, row in enumerate(rows) if row["pmc"] == "on"]
    check(browser.value("graze.shown()") == on and browser.value("graze.chosen()") == on[0], "the page opens on", len(on))
    drawn = browser.value("graze.drawn()")
    count = browser.value("document.getElementById('count').innerText")
    check(5000 < len(drawn) <= 20_000 and set(drawn) <= set(on), "points that are drawn", len(drawn))
    check(f"{len(on):,} of 100,000 points" in count and f"{len(drawn):,} of these are drawn" in count, "what is said", count)
    frames = sorted(browser.value("graze.frame()") for _ in range(8))
    print("frames:", *(f"{x:.0f} ms" for x in frames))
    check(frames[0] < 20000, "milliseconds of the fastest frame: a page that hangs; speed is no test's matter", frames)


def test_judge(browser, graze, folder):
    """A mesh in the colours of distances stands where the surface would, and hides by its box."""
    cube = os.path.join(ROOT, "tests", "refuse", "common", "cube.off")
    motion, page = os.path.join(folder, "judge.json"), os.path.join(folder, "judge.html")
    with open(motion, "w", encoding="utf-8") as file:
        file.write('{"dimension": 3, "pieces": [{"t": ["0", "1"], "transform": {"translate": ["8*t", "0", "0"]}}]}')
    run(graze, "judge", cube, motion, cube, "--within", "1/2", "--no-points", "--page", page)
    opened(browser, page)
    check(browser.value("!document.getElementById('distances').hidden"), "no scale")
    check(browser.value("document.getElementById('sweep-name').textContent") == "mesh", "the box is not named")
    check(browser.value("graze.sweep.children.length") == 1, "things in place of the sweep")
    before = pixels(browser, "space")
    browser.value("document.getElementById('show-sweep').click()")
    check(pixels(browser, "space") != before, "the mesh is not seen")


def test_arcs(browser, graze, folder):
    """A square moved along a leg, askew: two arcs are paths of vertices, the others edges at the ends of the motion, each in its colour and named."""
    open_moved(browser, graze, folder, "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))", "3*t", "t")
    groups = browser.value("graze.sweep.children[0].children.map((lines) => [lines.geometry.index.count / 2, lines.material.color.getHexString()])")
    check(groups == [[2, "0072b2"], [4, "d55e00"], [0, "cc79a7"]], "lines by source", groups)
    name = browser.value("document.getElementById('sweep-name').innerText")
    check(name == "boundary of the sweep · path of a vertex · edge at one time", "sources are named", name)
    before = pixels(browser, "space")
    browser.value("document.getElementById('show-sweep').click()")
    check(pixels(browser, "space") != before, "the arcs are not seen")


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
            for name in ("bracket", "figures-5-7-8", "curved-plate-hole"):
                test_clicks(browser, args.graze, folder, name)
                shoot(name)
            for test in (test_loading, test_rings, test_slides, test_root, test_late, test_fill, test_texts, test_theme_and_keys, test_phone, test_narrow, test_beside):
                test(browser, args.graze, folder)
                shoot(test.__name__)
            test_filters(browser, args.graze, folder)
            shoot("filters")
            test_compare(browser, args.graze, folder)
            shoot("compare")
            test_arcs(browser, args.graze, folder)
            shoot("arcs")
            test_judge(browser, args.graze, folder)
            shoot("judge")
            test_notebook(browser, args.graze, folder)
            shoot("notebook")
            test_size(browser, args.graze, folder)
            shoot("size")
    finally:
        browser.close()
    checks.finish()


if __name__ == "__main__":
    main()
