#!/usr/bin/env python3
# suite
"""Pages of `graze draw -o scene.html` and `graze compare --page` and `graze judge --page`, by their data.

Words, classes, counts, times and cells of a page are those of `graze classify --format jsonl`; the maps of its
motion take points to the boundary of the solid at the times of contact; the surface is that of `graze boundary --sharp`.
A page with a certificate holds the files by which it is proved.
A page holds the licence of three.js and names no file or address. What the page shows is tested in a browser
(browser.py).
SPDX-License-Identifier: GPL-3.0-or-later
"""
import base64
import csv
import json
import math
import os
import re
import struct
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "boundary"))

import harness  # noqa: E402
from exact import Fraction as F, to_double  # noqa: E402
from files import read_ply  # noqa: E402
from harness import ROOT, Checks, options  # noqa: E402

CUBE = os.path.join(ROOT, "tests", "refuse", "common", "cube.off")
checks = Checks()
check = checks.holds


def case(name):
    folder = os.path.join(ROOT, "cases", name)
    solid = next(f for f in sorted(os.listdir(folder)) if f.startswith("solid."))
    return [os.path.join(folder, f) for f in (solid, "motion.json", "points.csv")]


def run(graze, *arguments, status=0):
    done = harness.run([graze, *arguments], 300)
    check(done.returncode == status, arguments, done.returncode, done.stderr)
    return done.stdout


def read_page(path):
    """(text without its data, the data)."""
    with open(path, encoding="utf-8") as file:
        text = file.read()
    found = re.findall(r'<script type="application/json" id="scene">(.*?)</script>', text, re.S)
    check(len(found) == 1, path, "scripts of data", len(found))
    return text.replace(found[0], ""), json.loads(found[0])


def numbers(text, form, size):
    data = base64.b64decode(text, validate=True)
    return struct.unpack(f"<{len(data) // size}{form}", data)


def time_of(time):
    """As in JSON Lines; a root without its decimal, which has other digits there."""
    return time if isinstance(time, str) else (time["poly"], time["lo"], time["hi"])


def page_time(text):
    """A time of a page's line: a ratio, or (decimal, polynomial, low, high)."""
    return tuple(text.split("~")) if "~" in text else text


def page_points(data):
    """For each point its line taken apart: (at, word, tone, definition, case, i, t, contacts), a contact (from, to, cells)."""
    points = data["points"]
    tones = base64.b64decode(points["tones"], validate=True)
    check(len(tones) == len(points["lines"]), "tones of points", len(tones), len(points["lines"]))
    for line, tone in zip(points["lines"], tones):
        at, word, numbers, contacts = line.split("|")[:4]
        yield (at, word, tone, *map(int, numbers.split()), [contact.split(",") for contact in contacts.split(";")] if contacts else [])


def test_places(data):
    """They are told from the centre of the box, in single precision."""
    d, box = data["dimension"], data["box"]
    places = numbers(data["points"]["places"], "f", 4)
    for k, (at, *_) in enumerate(page_points(data)):
        for i, x in enumerate(at.split()):
            off = places[k * d + i] + (box[i] + box[d + i]) / 2 - to_double(F(x))
            check(abs(off) <= 1e-6 * (box[d + i] - box[i]), "place", at, i, off)


def test_rows(data, lines, operation):
    """The points beside JSON Lines."""
    letter = {"face": "f", "edge": "e", "vertex": "v"}
    check(len(data["points"]["lines"]) == len(lines) > 0, "points", len(data["points"]["lines"]), len(lines))
    check(data["points"]["answers"] == {}, "answers of no candidate", data["points"]["answers"])
    test_places(data)
    for row, line in zip(page_points(data), map(json.loads, lines)):
        at, word, tone, definition, position, i, t, contacts = row
        check([F(x) for x in at.split()] == [F(x) for x in line["point"]], "point", at, line["point"])
        check(word == line["word"], at, word, line["word"])
        if operation == "sweep":
            want = [line["class"], 0 if line["definition"] == "ext" else line["definition"], line["case"], line["i"], line["t"]]
            check([data["tones"][tone][0], definition, position, i, t] == want, at, tone, definition, position, i, t, want)
        else:
            check(data["tones"][tone][0] == line["pmc"], at, tone, line["pmc"])
        check(len(contacts) == len(line["contacts"]), at, contacts)
        for (begin, end, says), contact in zip(contacts, line["contacts"]):
            times = [x if isinstance(x, str) else (x[1].split(" "), x[2], x[3]) for x in map(page_time, (begin, end or begin))]
            check(times == [time_of(contact["from"]), time_of(contact["to"])], at, times, contact)
            check((end == "") == (contact["from"] == contact["to"]), at, "instant", end)
            cells = [f"p{data['primitives'].index(cell)}" if kind == "primitive" else
                     letter[kind] + ("-".join(map(str, cell)) if isinstance(cell, list) else str(cell))
                     for feature in contact["features"] for kind, cell in feature.items()]
            check(says.split() == ["X" if contact["kind"] == "intersection" else "T", *cells], at, says, contact)


def test_cells(graze, data, solid, motion, operation):
    """Each cell and each part of a split one has the class of its centre; cells are split where a neighbour differs."""
    cells, column = data["cells"], "class" if operation == "sweep" else "pmc"
    (across, up), n, d = cells["count"], cells["parts"], data["dimension"]
    o, u, v = ([F(x) for x in cells["corners"][3 * k:3 * k + 3]] for k in range(3))
    tones, part = (base64.b64decode(cells[name], validate=True) for name in ("tones", "part"))
    split = numbers(cells["split"], "I", 4)
    check(len(tones) == across * up and len(part) == len(split) * n * n and n % 2 == 1, "cells", len(tones), len(part), n)

    def around(k):
        i, j = k % across, k // across
        return {tones[b * across + a] for a in range(max(i - 1, 0), min(i + 2, across)) for b in range(max(j - 1, 0), min(j + 2, up))}
    check(list(split) == [k for k in range(across * up) if len(around(k)) > 1], "the cells that are split", len(split))

    def centre(i, j, parts):
        return [o[k] + (i + F(1, 2)) / (across * parts) * (u[k] - o[k]) + (j + F(1, 2)) / (up * parts) * (v[k] - o[k]) for k in range(d)]
    asked = [(centre(k % across, k // across, 1), tones[k]) for k in range(across * up)]
    for k, cell in enumerate(split):
        for m in range(n * n):
            asked.append((centre(cell % across * n + m % n, cell // across * n + m // n, n), part[k * n * n + m]))
    text = "".join(",".join(map(str, at)) + "\n" for at, _ in asked)
    more = ["--operation", "unsweep"] if operation == "unsweep" else []
    done = harness.run([graze, "classify", solid, motion, "-", *more], 300, input=text)
    rows = list(csv.DictReader(line for line in done.stdout.splitlines() if not line.startswith("#")))
    check(len(rows) == len(asked), "rows of cells", len(rows), done.stderr)
    wrong = [(at, tone) for (at, tone), row in zip(asked, rows) if data["tones"][tone][0] != row[column]]
    # Corners are doubles here: a centre on a border may be next to it.
    check(len(wrong) <= len(asked) / 500, "cells in another class", len(wrong), "of", len(asked), wrong[:3])


def near_zero(text):
    """The decimal of a root is near a root of its polynomial, by a change of sign."""
    decimal, poly = float(text[0]), [int(c) for c in text[1].split()]
    step = abs(F(text[0])) / 10**11
    values = [sum(c * (F(text[0]) + s * step)**k for k, c in enumerate(poly)) for s in (-1, 1)]
    return values[0] * values[1] < 0 and to_double(F(text[2])) <= decimal <= to_double(F(text[3]))


def image(piece, which, t, point):
    """The image of a point under a piece's map."""
    low, high = (to_double(F(x)) for x in piece["t"])
    u, d = (t - low) / (high - low), len(point)
    entry = [sum(c * u**k for k, c in enumerate(p)) for p in (*piece[which]["entries"], piece[which]["weight"])]
    return [(entry[i * (d + 1) + d] + sum(entry[i * (d + 1) + j] * point[j] for j in range(d))) / entry[-1] for i in range(d)]


def test_motion(graze, folder):
    """A cube that turns and slides: each contact is on the cube, and `place` undoes `trace`."""
    motion, points, page = (os.path.join(folder, name) for name in ("m.json", "p.csv", "m.html"))
    with open(motion, "w", encoding="utf-8") as file:
        file.write('{"dimension": 3, "pieces": [{"t": ["0", "2"], "transform": {"translate": ["4*s", "0", "0"]}}, '
                   '{"t": ["2", "3"], "transform": {"compose": [{"rotate": {"axis": ["0", "0", "1"], "tan_half": "s"}}, '
                   '{"translate": ["4", "0", "0"]}]}}]}')
    with open(points, "w", encoding="utf-8") as file:
        file.write(run(graze, "generate", CUBE, motion, "-n", 60, "--seed", 2))
    run(graze, "draw", CUBE, motion, points, "--surface", "none", "-o", page)
    _, data = read_page(page)
    check(data["surface"] is None, "a surface that was not asked for")
    found, roots = 0, 0
    for at, *_, contacts in page_points(data):
        point = [to_double(F(x)) for x in at.split()]
        for time in [page_time(contact[0]) for contact in contacts]:
            root = not isinstance(time, str)
            roots += root
            if root:
                check(near_zero(time), "decimal of a root", time)
            t = to_double(time[0] if root else F(time))
            piece = data["motion"][0 if t <= 2 else 1]
            body = image(piece, "trace", t, point)
            off = max(abs(x - 1) for x in body) - 1
            check(abs(off) < 1e-8, at, time, "is not on the cube", body)
            check(max(abs(a - b) for a, b in zip(image(piece, "place", t, body), point)) < 1e-8, at, time, "place and trace")
            found += 1
    check(found > 50 and roots > 0, "contacts", found, roots)


def test_solid(data, path):
    """Vertices, triangles and edges of the cube."""
    with open(CUBE, encoding="utf-8") as file:
        given = [float(x) for line in file.read().splitlines()[2:10] for x in line.split()]
    check(list(numbers(data["solid"]["vertices"], "d", 8)) == given, path, "vertices")
    check(len(numbers(data["solid"]["triangles"], "I", 4)) == 36, path, "triangles")
    edges = numbers(data["solid"]["edges"], "I", 4)
    pairs = {tuple(sorted(edges[k:k + 2])) for k in range(0, len(edges), 2)}
    at = [given[3 * k:3 * k + 3] for k in range(8)]
    want = {(a, b) for a in range(8) for b in range(a + 1, 8) if sum(x != y for x, y in zip(at[a], at[b])) == 1}
    check(pairs == want and len(edges) == 24, path, "edges", pairs)


def test_fans(graze, folder, motion):
    """The cube whose faces are fans of four triangles about their middles has twelve edges."""
    with open(CUBE, encoding="utf-8") as file:
        rows = file.read().splitlines()
    at = [[F(x) for x in row.split()] for row in rows[2:10]]
    quads = [[int(x) for x in row.split()[1:5]] for row in rows[10:16]]
    middles = [[sum(at[v][k] for v in quad) / 4 for k in range(3)] for quad in quads]
    fans = [f"3 {quad[k]} {quad[(k + 1) % 4]} {8 + n}" for n, quad in enumerate(quads) for k in range(4)]
    solid, page = os.path.join(folder, "fans.off"), os.path.join(folder, "fans.html")
    with open(solid, "w", encoding="utf-8") as file:
        file.write("\n".join(["OFF 14 24 0", *(" ".join(str(x) for x in v) for v in at + middles), *fans]) + "\n")
    run(graze, "draw", solid, motion, "--surface", "none", "--grid", 4, "-o", page)
    _, data = read_page(page)
    edges = numbers(data["solid"]["edges"], "I", 4)
    check(len(edges) == 24 and max(edges) < 8, "edges of the cube in fans", edges)


def test_surface(graze, folder, data, level):
    """The surface of `graze boundary --sharp` at this level."""
    motion, ply = os.path.join(folder, "slide.json"), os.path.join(folder, "s.ply")
    run(graze, "boundary", CUBE, motion, "--depth", level, "--contacts", 300, "--sharp", "--surface", ply)
    vertices, faces = read_ply(ply)
    check(data["surface"]["level"] == level, "level", data["surface"]["level"])
    check(numbers(data["surface"]["faces"], "I", 4) == tuple(k for face in faces for k in face), "faces of the surface")
    flat, box = numbers(data["surface"]["vertices"], "f", 4), data["box"]
    middle = [(a + b) / 2 for a, b in zip(box[:3], box[3:])]
    far = max(abs(a + middle[k % 3] - to_double(b)) for k, (a, b) in enumerate(zip(flat, (x for v in vertices for x in v))))
    check(len(flat) == 3 * len(vertices) and far < 1e-6, "vertices of the surface", len(flat), far)


def test_page(graze, folder):
    """One page whole: nothing from elsewhere, texts that could end a script, the licence."""
    motion, points, page = (os.path.join(folder, name) for name in ("slide.json", "named.csv", "named.html"))
    with open(motion, "w", encoding="utf-8") as file:
        file.write('{"dimension": 3, "pieces": [{"t": ["0", "1"], "transform": {"translate": ["8*t", "0", "0"]}}]}')
    name, title = "</script><b>\\&", '</script><b>"\\&'
    with open(points, "w", encoding="utf-8") as file:
        file.write('x,y,z,id,stratum\n5,1,1,' + name + ',a\n1/3,1,2,two,b\n')
    run(graze, "draw", CUBE, motion, points, "--title", title, "-o", page, "--surface", 4)
    text, data = read_page(page)
    check(data["title"] == title and data["points"]["names"] == [name, "two"] and data["points"]["strata"] == ["a", "b"], data["points"])
    check(text.count("<script") == 3 and text.count("</script") == 3, "scripts", text.count("<script"))
    # The page's own part; the names of three.js's sources are no addresses that are asked for.
    check(not re.search(r'<(?:script|link|img|iframe)[^>]*\b(?:src|href)=|@import|url\(|\bfetch\(|WebSocket', text.split("var THREE")[0] +
                        text.rsplit("<script>", 1)[1]), "the page asks for a file")
    check("default-src 'none'" in text, "content security policy")
    with open(os.path.join(ROOT, "src", "output", "page", "three", "LICENSE"), encoding="utf-8") as file:
        check(file.read() in text, "the licence of three.js")
    check("@LICENCE@" not in text and "@THREE@" not in text and "@SCENE@" not in text and "@PROGRAM@" not in text, "marks")
    test_solid(data, page)
    test_fans(graze, folder, motion)
    test_surface(graze, folder, data, 4)


def test_arcs(graze, folder):
    """[0, 2] x [0, 1] by a quarter turn about the origin: its corner (2, 1) runs on the circle of radius sqrt 5, from y = 1 to x = -1; else the boundary
    is of edges at both ends of the motion, on x = 0, 2, -1 and y = 0, 2. Bounds are the lines' distance, 2^-13 of 3.24, and that of 32-bit floats. The area is
    5 pi/4 + 2. Beyond a limit the boundary is sampled."""
    solid, motion, page = (os.path.join(folder, name) for name in ("bar.wkt", "quarter.json", "arcs.html"))
    with open(solid, "w", encoding="utf-8") as file:
        file.write("POLYGON ((0 0, 2 0, 2 1, 0 1, 0 0))\n")
    with open(motion, "w", encoding="utf-8") as file:
        file.write('{"dimension": 2, "pieces": [{"t": ["0", "1"], "transform": {"turn": {"quarters": 1}}}]}')
    run(graze, "draw", solid, motion, "-o", page, "--grid", 4)
    _, data = read_page(page)
    low, high = data["box"][:2], data["box"][2:]
    flat = numbers(data["surface"]["vertices"], "f", 4)
    at = [tuple(flat[k + i] + (low[i] + high[i]) / 2 for i in (0, 1)) for k in range(0, len(flat), 2)]
    lines = {source: list(zip(*[iter(numbers(text, "I", 4))] * 2)) for source, text in data["surface"]["sources"].items()}
    check(sorted(lines) == ["edge", "envelope", "path"] and not lines["envelope"], "sources", sorted(lines))
    path = [at[v] for line in lines["path"] for v in line]
    check(path and all(abs(math.hypot(x, y) - 5 ** .5) < 1e-6 and x > -1 - 1e-6 and y > 1 - 1e-6 for x, y in path), "path", path[:4])
    check(len(lines["path"]) > 15, "lines of the circle", len(lines["path"]))
    check(all(any(max(abs(p[i] - c), abs(q[i] - c)) < 1e-6 for i, c in ((0, 0), (0, 2), (0, -1), (1, 0), (1, 2)))
              for p, q in ((at[a], at[b]) for a, b in lines["edge"])), "edges", lines["edge"])
    every = [line for some in lines.values() for line in some]
    check(sorted(a for a, _ in every) == sorted(b for _, b in every) == list(range(len(at))), "each vertex begins a line and ends one", len(every))
    area = sum(at[a][0] * at[b][1] - at[b][0] * at[a][1] for a, b in every) / 2
    check(0 <= 5 * math.pi / 4 + 2 - area < 3.24 / 2 ** 13 * 4, "area", area)
    run(graze, "draw", solid, motion, "-o", page, "--grid", 4, "--limit", "curve=1", "--surface", "4")
    check(read_page(page)[1]["surface"].get("level") == 4, "sampled beyond a limit")


def test_cases(graze, folder):
    page = os.path.join(folder, "case.html")
    for name, more in (("bracket", []), ("figures-5-7-8", []), ("figure2-rotation-3d", []), ("bracket", ["--operation", "unsweep"]),
                       ("combinations-2d-combined", ["--folds", "combined"]), ("curved-plate-hole", []), ("curved-parabola", [])):
        solid, motion, points = case(name)
        curved = name.startswith("curved")
        run(graze, "draw", solid, motion, points, "-o", page, *([] if curved else ["--surface", "none"]), "--grid", 40, *more)
        _, data = read_page(page)
        if "combined" not in more:
            test_cells(graze, data, solid, motion, "unsweep" if "unsweep" in more else "sweep")
        lines = run(graze, "classify", solid, motion, points, "--format", "jsonl", *more).splitlines()
        operation = "unsweep" if "unsweep" in more else "sweep"
        check(data["operation"] == operation and (data["folds"] == "combined") == ("combined" in more), name, data["operation"])
        test_rows(data, lines, operation)


def test_curved(graze, folder):
    """A shell turned about: triangles around each radius, all looking outwards. Of two undecided points the page has place and reason."""
    solid, motion, page = (os.path.join(folder, name) for name in ("s.csg.json", "m.json", "s.html"))

    def draw(d, node, *more):
        with open(solid, "w", encoding="utf-8") as file:
            json.dump({"dimension": d, "solid": node}, file)
        with open(motion, "w", encoding="utf-8") as file:
            file.write('{"dimension": %d, "pieces": [{"t": ["0", "1"], "transform": {"translate": ["t"%s]}}]}' % (d, ', "0"' * (d - 1)))
        run(graze, "draw", solid, motion, *more, "-o", page, "--grid", 8)
        return read_page(page)[1]
    data = draw(3, {"difference": [{"ball": {"radius": 2}}, {"ball": {"radius": 1}, "name": "hole"}]})
    at, faces = numbers(data["solid"]["vertices"], "d", 8), numbers(data["solid"]["triangles"], "I", 4)
    places = [at[k:k + 3] for k in range(0, len(at), 3)]
    radii = [sum(x * x for x in p) ** .5 for p in places]
    check(data["primitives"] == ["ball 0", 'ball 1 "hole"'] and data["surface"] is None, data["primitives"])
    check(all(min(abs(r - 1), abs(r - 2)) < .01 for r in radii), "radii", min(radii), max(radii))
    volume = sum(a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])
                 for a, b, c in ([places[v] for v in faces[k:k + 3]] for k in range(0, len(faces), 3))) / 6
    check(abs(volume / (4 / 3 * 3.14159265 * 7) - 1) < .01, "the volume between the spheres", volume)
    # Thirteen half-planes through the origin, which lies on all of their borders: more than the limit allows.
    few = "--limit", "work=20000"
    planes = [{"halfspace": {"normal": [str(k), str(k * k + 1)], "offset": "0"}} for k in range(1, 14)]
    body = {"intersection": [{"ball": {"radius": 1}}, *({"union": pair} for pair in zip(planes[:-1], planes[1:]))]}
    data = draw(2, body, "-p", "0,0", *few)
    _, word, _, _, place, why, pmc = data["points"]["lines"][0].split("|")
    kind, *cells = place.split(",")[2].split()
    explained = run(graze, "explain", solid, motion, "0", "0", *few)
    check("?" in word and why and why in explained and kind == "U", word, place, why, pmc)
    check(all(data["primitives"][int(cell[1:])] in explained for cell in cells), cells)
    # The trajectory (-t, 0) is inside all half-planes and the disk for 0 < t < 1, which tells pmc but not the class.
    check((word, pmc) == ("?IB", "in"), "pmc is told", word, pmc)
    check(data["tones"][base64.b64decode(data["points"]["tones"])[0]][0] == "undecided", "the tone")


def test_compare(graze, folder):
    """The wrong rows have the candidate's answer, also a missing one; the scene is that of the table's head."""
    solid, motion, points = case("figures-5-7-8")
    golden, mine, page = (os.path.join(folder, name) for name in ("golden.csv", "mine.csv", "c.html"))
    with open(golden, "w", encoding="utf-8") as file:
        file.write(run(graze, "classify", solid, motion, points, "--operation", "unsweep"))
    with open(golden, encoding="utf-8") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    wrong = {3: "in", 8: "on"}
    check(all(rows[k]["pmc"] == "out" for k in (*wrong, 11)), "rows of the case")
    with open(mine, "w", encoding="utf-8") as file:
        file.write("x,y,pmc\n" + "".join(f"{row['x']},{row['y']},{wrong.get(k, row['pmc'])}\n" for k, row in enumerate(rows) if k != 11))
    run(graze, "compare", golden, mine, "--solid", solid, "--motion", motion, "--page", page, "--show", "1", status=1)
    _, data = read_page(page)
    got = data["points"]["answers"]
    check(got == {"3": "pmc=in", "8": "pmc=on", "11": "nothing"}, "wrong rows", got)
    check(data["operation"] == "unsweep" and len(data["points"]["lines"]) == len(rows), data["operation"])


def test_judge(graze, folder):
    """The cube [0, 2]^3 along x by 8, and a box that ends at x = 11: its end is 1 outside, as is x = 10 from it."""
    motion, mesh, page = (os.path.join(folder, name) for name in ("along.json", "long.off", "judge.html"))
    with open(motion, "w", encoding="utf-8") as file:
        file.write('{"dimension": 3, "pieces": [{"t": ["0", "1"], "transform": {"translate": ["8*t", "0", "0"]}}]}')
    corners = [(x, y, z) for z in (0, 2) for y in (0, 2) for x in (0, 11)]
    faces = [(0, 2, 3), (0, 3, 1), (4, 5, 7), (4, 7, 6), (0, 1, 5), (0, 5, 4), (2, 6, 7), (2, 7, 3), (0, 4, 6), (0, 6, 2), (1, 3, 7), (1, 7, 5)]
    with open(mesh, "w", encoding="utf-8") as file:
        file.write("OFF\n8 12 0\n" + "".join("%d %d %d\n" % p for p in corners) + "".join("3 %d %d %d\n" % f for f in faces))
    run(graze, "judge", CUBE, motion, mesh, "--within", "1/4", "--no-points", "--page", page)
    _, data = read_page(page)
    box = data["box"]
    check(box[0] <= 0 and box[3] >= 11, "the mesh is in the box", box)
    centre = [(a + b) / 2 for a, b in zip(box[:3], box[3:])]
    places = numbers(data["mesh"]["vertices"], "f", 4)
    for k, p in enumerate(corners):
        check(all(abs(x + c - y) < 1e-5 for x, c, y in zip(places[3 * k:], centre, p)), "vertex", k, places[3 * k:3 * k + 3], p)
    check(numbers(data["mesh"]["faces"], "I", 4) == tuple(v for f in faces for v in f), "faces", data["mesh"]["faces"])
    for p, far in zip(corners, numbers(data["mesh"]["distances"], "d", 8)):
        check(abs(far - (p[0] == 11)) <= 1 / 256, "distance", p, far)
    check(data["points"]["names"] == ["outside", "sweep"], data["points"]["names"])
    at = [[F(x) for x in line.split("|")[0].split()] for line in data["points"]["lines"]]
    check(at[0][0] == 11 and abs(at[1][0] - 10) < F(1, 8) and all(0 <= x <= 2 for p in at for x in p[1:]), "places", data["points"]["lines"])


def test_proof(graze, folder):
    """A page with a certificate has the bytes of the files, a byte that is no text among them; files of another scene are refused."""
    solid, motion, points = (os.path.join(folder, name) for name in ("s.wkt", "m.json", "p.csv"))
    proof, checker, page = (os.path.join(folder, name) for name in ("c.txt", "k.html", "proof.html"))
    for path, content in ((solid, b"POLYGON ((0 0, 2 0, 2 1, 0 1, 0 0))\r\n"), (points, b"x,y\n1,1/2\n9,9\n2,1\n"), (checker, b"<title>graze-check</title>\xff\x00<"),
                          (motion, b'{"dimension": 2, "pieces": [{"t": ["0", "1"], "transform": {"translate": ["t", "0"]}}]}')):
        with open(path, "wb") as file:
            file.write(content)
    run(graze, "certify", solid, motion, points, "-o", proof)
    drawing = ["draw", solid, motion, points, "--surface", "none", "--certificate", proof, "-o", page]
    for more in ([], ["--checker", checker]):
        run(graze, *drawing, *more)
        held = read_page(page)[1]["proof"]
        files = {"solid": solid, "motion": motion, "certificate": proof, **({"checker": checker} if more else {})}
        check({kind: base64.b64decode(text, validate=True) for kind, text in held.items()} == {kind: open(path, "rb").read() for kind, path in files.items()}, more, held)
    run(graze, *drawing[:6], "-o", page)
    check("proof" not in read_page(page)[1], "a page without a certificate")
    run(graze, *drawing, "--operation", "unsweep", status=3)
    run(graze, *drawing, "--round", "binary64")
    run(graze, *drawing, "--checker", points, status=3)
    with open(solid, "ab") as file:
        file.write(b"\n")
    run(graze, *drawing, status=3)


def main():
    graze = options(__doc__).graze
    with tempfile.TemporaryDirectory() as folder:
        test_page(graze, folder)
        test_arcs(graze, folder)
        test_cases(graze, folder)
        test_motion(graze, folder)
        test_curved(graze, folder)
        test_compare(graze, folder)
        test_judge(graze, folder)
        test_proof(graze, folder)
    checks.finish()


if __name__ == "__main__":
    main()
