"""Pictures and binary tables against graze classify.

SPDX-License-Identifier: GPL-3.0-or-later
# suite

An SVG picture says where its cells are, in exact numbers. The centre of every cell is computed here and
classified by `graze classify` on its own, and must have the colour of its class, in the PNG too; in space the region about
the centre has it. Marks are counted against the counts that [EI] prints. VTK and npy files are read by small readers of this file, and must
hold what the CSV table holds. The committed picture must be what `make pictures` draws.
"""
import ast
import csv
import io
import json
import os
import re
import shutil
import struct
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
import zlib

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

import harness  # noqa: E402
from exact import Fraction as F, to_double  # noqa: E402
from harness import ROOT, Checks, options  # noqa: E402

SVG = "{http://www.w3.org/2000/svg}"
COLOURS = {"regular": "#56b4e9", "fold": "#e69f00", "fold_boundary": "#009e73", "boundary": "#d55e00",
           "exterior": "#ffffff", "in": "#56b4e9", "on": "#d55e00", "out": "#ffffff"}
RECTANGLE = re.compile(r"M([\d.]+) ([\d.]+)H([\d.]+)V([\d.]+)H\1z")
ENVIRONMENT = dict(os.environ)
checks = Checks()
check = checks.holds


def excuse_fonts(folder):
    """Memory that fontconfig, behind cairo, keeps until the end is no leak of ours under a sanitizer."""
    path = os.path.join(folder, "suppressions")
    with open(path, "w", encoding="utf-8") as file:
        file.write("leak:libfontconfig\n")
    ENVIRONMENT["LSAN_OPTIONS"] = f"suppressions={path}:print_suppressions=0"


def run(graze, *arguments, text=None):
    return harness.run([graze, *arguments], 300, text=False, input=text, env=ENVIRONMENT)


def files(name):
    folder = os.path.join(ROOT, "cases", name)
    solid = next(f for f in sorted(os.listdir(folder)) if f.startswith("solid."))
    return [os.path.join(folder, f) for f in (solid, "motion.json", "points.csv")]


def table(graze, *arguments, text=None):
    """The rows of a table as dictionaries."""
    done = run(graze, "classify", *arguments, text=text)
    lines = [line for line in done.stdout.decode().splitlines() if not line.startswith("#")]
    return list(csv.DictReader(lines))


# ---------------------------------------------------------------------------------- pictures

def group(root, name):
    return next((g for g in root.iter(SVG + "g") if g.get("class") == name), None)


def rings(path):
    """The polygons of a path of M, L, H, V and z, as lists of pixels."""
    out = []
    for verb, numbers in re.findall(r"([MLHVz])([-\d. ]*)", path.get("d")):
        n = [float(v) for v in numbers.split()]
        if verb == "M":
            out.append([])
        if verb != "z":
            at = out[-1][-1] if out[-1] else None
            out[-1].append((n[0], at[1]) if verb == "H" else (at[0], n[0]) if verb == "V" else tuple(n))
    return out


class Cells:
    """The layout an SVG picture states for its cells, and the rectangles or regions it draws."""

    def __init__(self, root):
        g = group(root, "cells")
        self.section = [[F(n) for n in g.get(name).split()] for name in ("data-origin", "data-u", "data-v")
                        if g.get(name)]
        self.axes = [("uv" if self.section else "xyz").index(a) for a in g.get("data-axes").split()]
        self.count = [int(n) for n in g.get("data-count").split()]
        self.low = [F(n) for n in g.get("data-low").split()]
        self.side = F(g.get("data-side"))
        self.frame = [int(n) for n in g.get("data-frame").split()]
        self.parts = int(g.get("data-parts"))
        self.colour, self.part = {}, {}
        for path in g.iter(SVG + "path"):
            if not path.get("shape-rendering"):
                self.paint(path)
                continue
            for run in RECTANGLE.findall(path.get("d")):
                self.fill(self.colour, 1, [float(n) for n in run], path.get("fill"))
        for path in group(root, "parts").iter(SVG + "path"):
            for run in RECTANGLE.findall(path.get("d")):
                self.fill(self.part, self.parts, [float(n) for n in run], path.get("fill"))

    def centre(self, i, j, parts=1):
        point = list(self.low)
        point[self.axes[0]] += (i + F(1, 2)) * self.side / parts
        point[self.axes[1]] += (j + F(1, 2)) * self.side / parts
        if self.section:
            return [o + point[0] * u + point[1] * v for o, u, v in zip(*self.section)]
        return point

    def pixel(self, i, j):
        """The middle of a cell on the picture."""
        x, y, width, height = self.frame
        return (x + (i + .5) * width / self.count[0], y + height - (j + .5) * height / self.count[1])

    def paint(self, path):
        """Give the cells whose centres are in a region its colour."""
        sides = [pair for ring in rings(path) for pair in zip(ring, ring[1:] + ring[:1])]
        for j in range(self.count[1]):
            _, y = self.pixel(0, j)
            places = [a + (y - b) / (d - b) * (c - a) for (a, b), (c, d) in sides if (b < y) != (d < y)]
            for i in range(self.count[0]):
                if sum(x < self.pixel(i, j)[0] for x in places) % 2:
                    self.colour[i, j] = path.get("fill")

    def fill(self, colours, parts, box, colour):
        """Give cells of the grid that is `parts` times as fine, whose centres are in the box, a colour."""
        x, y, width, height = self.frame
        along, up = width / self.count[0] / parts, height / self.count[1] / parts
        for j in range(round((y + height - box[3]) / up), round((y + height - box[1]) / up)):
            for i in range(round((box[0] - x) / along), round((box[2] - x) / along)):
                check((i, j) not in colours, "two colours on one cell", i, j)
                colours[i, j] = colour

    def split(self):
        """The cells that have a neighbour, also across a corner, of another colour."""
        for i in range(self.count[0]):
            for j in range(self.count[1]):
                around = {self.colour.get((u, v), "#ffffff") for u in range(max(i - 1, 0), min(i + 2, self.count[0]))
                          for v in range(max(j - 1, 0), min(j + 2, self.count[1]))}
                if len(around) > 1:
                    yield i, j


def read_png(path):
    """(width, height, rows of RGB bytes) of an 8 bit RGB or RGBA image."""
    with open(path, "rb") as file:
        data = file.read()
    at, packed = 8, b""
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + size]
        if kind == b"IHDR":
            width, height, depth, colour = struct.unpack(">IIBB", body[:10])
        if kind == b"IDAT":
            packed += body
        at += 12 + size
    step = {2: 3, 6: 4}[colour]
    raw, rows, above = zlib.decompress(packed), [], bytes(width * step)
    for y in range(height):
        start = y * (width * step + 1)
        kind, line = raw[start], bytearray(raw[start + 1:start + 1 + width * step])
        for x in range(len(line)):
            left, up = line[x - step] if x >= step else 0, above[x]
            corner = above[x - step] if x >= step else 0
            guess = left + up - corner
            paeth = min((left, up, corner), key=lambda v: abs(guess - v))
            line[x] = (line[x] + (0, left, up, (left + up) // 2, paeth)[kind]) & 255
        rows.append(bytes(line))
        above = line
    return width, height, step, rows


def check_png(path, cells, want, name):
    width, height, step, rows = read_png(path)
    alike = other = 0
    palette = {bytes.fromhex(c[1:]) for c in COLOURS.values()}
    for (i, j), colour in want.items():
        x, y = (int(2 * v) for v in cells.pixel(i, j))
        got = rows[y][step * x:step * x + 3]
        alike += got == bytes.fromhex(colour[1:])
        other += got != bytes.fromhex(colour[1:]) and got in palette
    # Outlines, marks and names cover some cells; a mark may have the colour of a class.
    check(alike > .8 * len(want), name, "cells of the PNG in their colour:", alike, "of", len(want))
    check(other <= .02 * len(want), name, "cells of the PNG in another class's colour:", other)
    return width, height


def check_parts(graze, cells, name, options, column):
    """Each part of a cell at a border has the class of its own centre, no other cell has parts."""
    n, split = cells.parts, list(cells.split())
    places = [(i * n + u, j * n + v) for i, j in split for u in range(n) for v in range(n)]
    check(n % 2 == 1 and n > 1 and split, name, "parts", n, len(split))
    check(set(cells.part) <= set(places), name, "parts of cells at no border", set(cells.part) - set(places))
    solid, motion, _ = files(name)
    text = "".join(",".join(map(str, cells.centre(i, j, n))) + "\n" for i, j in places)
    rows = table(graze, solid, motion, "-", *options, text=text.encode())
    check(len(rows) == len(places), name, "rows", len(rows))
    for (i, j), row in zip(places, rows):
        got = cells.part.get((i, j), cells.colour.get((i // n, j // n), "#ffffff"))
        check(got == COLOURS[row[column]], name, "part", i, j, got, "is not", row[column])


def check_cells(graze, folder, name, grid, options, unsweep=False, png=False):
    solid, motion, points = files(name)
    drawn = {}
    for kind in ("svg", "png"):
        drawn[kind] = os.path.join(folder, f"{name}.{kind}")
        # Reading a PNG here is slow; without points it is small.
        operands = [solid, motion] if png else [solid, motion, points]
        done = run(graze, "draw", *operands, "--grid", str(grid), *options, "-o", drawn[kind])
        if not check(done.returncode == 0, name, kind, done.stderr.decode()):
            return
    root = ElementTree.parse(drawn["svg"]).getroot()
    cells = Cells(root)
    places = [(i, j) for j in range(cells.count[1]) for i in range(cells.count[0])]
    text = "".join(",".join(map(str, cells.centre(i, j))) + "\n" for i, j in places)
    scene_options = ["--operation", "unsweep"] if unsweep else []
    rows = table(graze, solid, motion, "-", *scene_options, text=text.encode())
    check(len(rows) == len(places), name, "rows", len(rows))
    want = {p: COLOURS[row["pmc" if unsweep else "class"]] for p, row in zip(places, rows)}
    check(len(set(want.values())) > 1, name, "cells of one colour only")
    for place, colour in want.items():
        got = cells.colour.get(place, "#ffffff")
        check(got == colour, name, "cell", place, "centre", *map(str, cells.centre(*place)), got, "is not", colour)
    if group(root, "parts").find(SVG + "path") is not None:
        check_parts(graze, cells, name, scene_options, "pmc" if unsweep else "class")
    if png:
        size = check_png(drawn["png"], cells, want, name)
        check(size == (2 * int(root.get("width")), 2 * int(root.get("height"))), name, "size of the PNG", size)


def text_box(text):
    """What a text covers at least: x0, y0, x1, y1. Letters of the fonts in use are no narrower than this."""
    size = float(text.get("font-size"))
    width = sum(.63 if c.isdigit() else .25 if c in "ijlI.,:;|!'()[]- tfr" else .5 for c in text.text) * size
    x, y = float(text.get("x")), float(text.get("y"))
    x -= {"middle": width / 2, "end": width}.get(text.get("text-anchor"), 0)
    return x, y - .6 * size, x + width, y


def check_texts(root, name):
    """No text covers another, none leaves the picture."""
    texts = [t for t in root.iter(SVG + "text") if t.text]
    boxes = [text_box(t) for t in texts]
    check(len(texts) > 8, name, "texts", len(texts))
    for k, (x0, y0, x1, y1) in enumerate(boxes):
        inside = x0 >= 0 and y0 >= 0 and x1 <= float(root.get("width")) and y1 <= float(root.get("height"))
        check(inside, name, repr(texts[k].text), "leaves the picture", boxes[k])
        for m in range(k):
            u0, v0, u1, v1 = boxes[m]
            check(x1 <= u0 or u1 <= x0 or y1 <= v0 or v1 <= y0, name, repr(texts[k].text), "covers",
                  repr(texts[m].text))


BOX = """OFF
8 6 0
0 0 0\n{0} 0 0\n{0} {1} 0\n0 {1} 0\n0 0 {2}\n{0} 0 {2}\n{0} {1} {2}\n0 {1} {2}
4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7
"""


def square(x, y, side):
    corners = [(x, y), (x + side, y), (x + side, y + side), (x, y + side), (x, y)]
    return "POLYGON((" + ",".join(f"{u} {v}" for u, v in corners) + "))"


def check_layout(graze, folder):
    """Texts keep apart where panels are narrow and numbers long; what is not shown is said."""
    long = "12345678901234567891/100000000000000000000"
    scenes = [("narrow.off", BOX.format(1, 9, 1), ["1/2*t", "0", "0"], ["--plane", f"z={long}"]),
              ("flat.off", BOX.format(1, 1, 40), ["t", "0", "0"], []),
              ("far.wkt", square(1000000, 5000000, 1), ["3*t", "0"], ["-p", "1000002,5000001/2"]),
              ("tiny.wkt", square(0, 0, F(1, 10 ** 7)), ["3/10000000*t", "0"], ["-p", "1/5000000,0"]),
              ("huge.wkt", square(0, 0, 10 ** 30), [f"{3 * 10 ** 30}*t", "0"], [])]
    seen = {}
    for name, solid, way, options in scenes:
        path = os.path.join(folder, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(solid)
        with open(path + ".json", "w", encoding="utf-8") as file:
            json.dump({"dimension": len(way), "pieces": [{"t": ["0", "1"], "transform": {"translate": way}}]}, file)
        done = run(graze, "draw", path, path + ".json", "--grid", "36", *options, "-o", path + ".svg")
        if check(done.returncode == 0, name, done.stderr):
            root = ElementTree.parse(path + ".svg").getroot()
            check_texts(root, name)
            seen[name] = [t.text for t in root.iter(SVG + "text")]
    # 0.12345678901234567891 is cut after ten digits, and no equality is claimed of the rest.
    check("The sweep by class in the plane z ≈ 0.1234567890" in seen["narrow.off"], "a long plane", seen["narrow.off"])
    check("1e-7" in seen["tiny.wkt"] and "1.5e-7" in seen["tiny.wkt"], "powers of ten", seen["tiny.wkt"])
    check("1e30" in seen["huge.wkt"], "powers of ten", seen["huge.wkt"])
    # 5000001/2 is not within 10^6 of the square's ordinate.
    check(any("1 of 1 points outside the picture" in t for t in seen["far.wkt"]), "a point outside", seen["far.wkt"])


def check_marks(graze, folder):
    """[EI] Figure 4: (2, 0), (8, 1), (2, 4), (6, 1), (2, 2); all contacts are in the frame."""
    path = os.path.join(folder, "marks.svg")
    run(graze, "draw", *files("figure4"), "--grid", "10", "-o", path)
    marks = list(group(ElementTree.parse(path).getroot(), "trajectories"))
    kinds = [(e.get("fill"), e.get("stroke")) for e in marks]
    check(kinds.count(("#222222", "#ffffff")) == 2 + 8 + 2 + 6 + 2, "marks of intersections", kinds)
    check(kinds.count(("#ffffff", "#d55e00")) == 0 + 1 + 4 + 1 + 2, "marks of tangencies", kinds)


def check_text(graze, folder):
    """What XML gives a meaning, and what is no character, in names and the title."""
    solid, motion, _ = files("figure4")
    path = os.path.join(folder, "text.svg")
    rows = b"x,y,id\n1,1,\"<a&b>\"\n2,1,\xff\xc3\xa9\x01\n"
    done = run(graze, "draw", solid, motion, "-", "--grid", "4", "--title", "a < b & \"c\"", "-o", path, text=rows)
    check(done.returncode == 0, "names of all kinds", done.stderr)
    texts = [t.text for t in ElementTree.parse(path).getroot().iter(SVG + "text")]
    for want in ("a < b & \"c\"", "<a&b>", "?é?"):
        check(want in texts, "the text", repr(want), "among", texts)


def check_without_png(graze, folder):
    """The program where its PNG library is not: it says so before it draws, and SVG goes on."""
    with open(graze, "rb") as file:
        if file.read(2) == b"#!":  # mutate.py's script in front of a program that has its library beside it
            return
    alone = os.path.join(folder, "alone")
    os.mkdir(alone)
    program = shutil.copy(graze, alone)
    solid, motion, _ = files("figure4")
    picture = os.path.join(alone, "picture")
    for kind in (".png", ".pdf"):
        done = run(program, "draw", solid, motion, "--grid", "4", "-o", picture + kind)
        check(done.returncode == 5 and b"PNG and PDF pictures need libgraze-png-" in done.stderr and b"libcairo2-dev" in done.stderr,
              "no PNG library", kind, done.returncode, done.stderr)
    check(run(program, "draw", solid, motion, "--grid", "4", "-o", picture + ".svg").returncode == 0, "SVG alone")
    check(sorted(os.listdir(alone)) == ["graze", "picture.svg"], "files of the program alone", os.listdir(alone))


def check_pictures(graze, folder):
    """What `make pictures` draws is well-formed, and the committed pictures are among it."""
    out = os.path.join(folder, "pictures")
    done = harness.run([os.path.join(ROOT, "cases", "pictures.sh"), graze, out], 600, text=False, env=ENVIRONMENT)
    check(done.returncode == 0, "pictures.sh", done.stderr.decode())
    names = sorted(os.listdir(out))
    for figure in ("3", "4", "5-regular", "7", "10", "12a", "12b"):
        check(f"figure{figure}.svg" in names and f"figure{figure}.png" in names, "figure", figure)
    for name in names:
        if name.endswith(".svg"):
            root = ElementTree.parse(os.path.join(out, name)).getroot()
            check_texts(root, name)
            notes = [t.text for t in root.iter(SVG + "text") if t.text.startswith("no room")]
            check(not notes, name, notes)
    for name in ("sampling.svg", "words.svg"):
        with open(os.path.join(ROOT, "cases", name), "rb") as old, open(os.path.join(out, name), "rb") as new:
            check(old.read() == new.read(), f"cases/{name} is not what make pictures draws")


# ------------------------------------------------------------------------------ binary tables

CODES = {"pmc": ["", "in", "on", "out"],
         "class": ["", "regular", "fold", "fold_boundary", "boundary", "exterior"]}


def code(column, value):
    """The number a name has in a file."""
    if column in CODES:
        return CODES[column].index(value)
    return 0 if value == "ext" else int(value)


def first_occurrence(values):
    order = {}
    return [order.setdefault(v, len(order)) for v in values]


class Vtk:
    """A legacy VTK file, binary: head, geometry, columns."""

    def __init__(self, data):
        self.file = io.BytesIO(data)
        self.head = [self.line() for _ in range(3)]
        self.words, self.columns, self.texts = {}, {}, {}
        rows, line = 0, self.line()
        while line:
            word, *rest = line.split()
            if word == "POINTS":
                self.points = self.numbers(3 * int(rest[0]), "d")
            elif word == "CELLS":
                self.cells = self.numbers(int(rest[1]), "i")
            elif word == "CELL_TYPES":
                self.types = self.numbers(int(rest[0]), "i")
            elif word == "FIELD":
                for _ in range(int(rest[1])):
                    name, one, length, kind = self.line().split()
                    check(name.endswith("_texts") and (one, kind) == ("1", "unsigned_char"), "field", name, one, kind)
                    texts = bytes(self.numbers(int(length), "B")).decode()
                    check(texts.endswith("\n"), "a line end after texts")
                    self.texts[name[:-len("_texts")]] = texts.split("\n")[:-1]
            elif word == "POINT_DATA":
                rows = int(rest[0])
            elif word == "SCALARS":
                check(self.line() == "LOOKUP_TABLE default", "lookup table of", rest[0])
                self.columns[rest[0]] = self.numbers(rows, rest[1][0])
            else:
                self.words[word] = rest
            line = self.line()

    def line(self):
        return self.file.readline().decode().rstrip("\n")

    def numbers(self, count, kind):
        size = struct.calcsize(kind)
        values = struct.unpack(f">{count}{kind}", self.file.read(size * count))
        check(self.file.read(1) == b"\n", "a line end after numbers")
        return list(values)


def check_columns(name, rows, columns, texts):
    """Columns of a file against the rows of the table; `texts` turns a text column into what is there."""
    for column in rows[0]:
        if column in "xyz":
            continue
        values = [row[column] for row in rows]
        if column in CODES or column in ("definition", "case", "i", "t"):
            want = [code(column, v) for v in values]
        elif column != "word" and all(re.fullmatch(r"[-+]?[\d./]+(e-?\d+)?", v) for v in values):
            want = [to_double(v) for v in values]
        else:
            want = texts(values)
        check(columns.get(column) == want, name, "column", column, columns.get(column, [])[:5], want[:5])


def check_vtk(graze, solid, motion, name, options, text=None):
    rows = table(graze, solid, motion, *options, text=text)
    done = run(graze, "classify", solid, motion, *options, "--format", "vtk", text=text)
    vtk = Vtk(done.stdout)
    dimension = 3 if "z" in rows[0] else 2
    points = [[F(row[a]) for a in "xyz"[:dimension]] + [F(0)] * (3 - dimension) for row in rows]
    check(vtk.head[0] == "# vtk DataFile Version 3.0" and vtk.head[2] == "BINARY", name, vtk.head)
    if "--grid" in options:
        check(vtk.words["DATASET"] == ["STRUCTURED_POINTS"], name, vtk.words)
        size = [int(n) for n in vtk.words["DIMENSIONS"]]
        origin, step = ([float(n) for n in vtk.words[w]] for w in ("ORIGIN", "SPACING"))
        for r, point in enumerate(points):
            place = (r % size[0], r // size[0] % size[1], r // size[0] // size[1])
            got = [o + s * k for o, s, k in zip(origin, step, place)]
            check(all(abs(g - to_double(p)) < 1e-9 for g, p in zip(got, point)), name, "row", r, got, point)
    else:
        check(vtk.words["DATASET"] == ["UNSTRUCTURED_GRID"], name, vtk.words)
        check(vtk.points == [to_double(v) for p in points for v in p], name, "points")
        check(vtk.types == [1] * len(rows), name, "types")
        check(vtk.cells == [v for r in range(len(rows)) for v in (1, r)], name, "cells")
    check_columns(name, rows, vtk.columns, first_occurrence)
    texts = [c for c in rows[0] if c == "word" or c in vtk.texts]
    check(sorted(texts) == sorted(vtk.texts), name, "columns with texts", texts, list(vtk.texts))
    for column in texts:
        check([vtk.texts[column][n] for n in vtk.columns[column]] == [row[column] for row in rows],
              name, "texts of", column, vtk.texts[column][:5])


def check_npy(graze, solid, motion, name, options, text=None):
    rows = table(graze, solid, motion, *options, text=text)
    data = run(graze, "classify", solid, motion, *options, "--format", "npy", text=text).stdout
    check(data[:8] == b"\x93NUMPY\x03\x00", name, "magic", data[:8])
    size, = struct.unpack("<I", data[8:12])
    check((12 + size) % 64 == 0 and data[11 + size:12 + size] == b"\n", name, "length of the head", size)
    head = ast.literal_eval(data[12:12 + size].decode())
    check(head["shape"] == (len(rows),) and head["fortran_order"] is False, name, head)
    form = "<" + "".join({"f8": "d", "u4": "I"}.get(d[1:], d[2:] + "s") for _, d in head["descr"])
    check(len(data) == 12 + size + len(rows) * struct.calcsize(form), name, "length of the array")
    columns = dict(zip((n for n, _ in head["descr"]), zip(*struct.iter_unpack(form, data[12 + size:]))))
    got = {n: [v.rstrip(b"\0").decode() if isinstance(v, bytes) else v for v in c] for n, c in columns.items()}
    for n in CODES:
        got[n] = [code(n, v) for v in got[n]] if n in got else None
    for axis in "xyz":
        if axis in rows[0]:
            check(got[axis] == [to_double(row[axis]) for row in rows], name, "column", axis)
    check(list(columns) == list(rows[0]), name, "names", list(columns))
    check_columns(name, rows, got, list)


def check_far_columns(graze, solid, motion):
    """Further columns at the ends of the range of binary64 (tests/api/test_export.c derives what is nearest)."""
    fields = ["1.7976931348623158e308", "5e-324", "3e-324", "2e-324", "-1e-20000", "0.1", "1e39", "1/3"]
    points = "".join(["x,y,far\n"] + [f"1,1,{field}\n" for field in fields]).encode()
    for rounding in ("none", "binary64", "binary32"):
        options = ["-", "--round", rounding, "--limit", "digits=100000"]
        kept = [row["far"] for row in table(graze, solid, motion, *options, text=points)]
        check(kept == fields, "further columns are carried as they were", rounding, kept)
        for look in (check_vtk, check_npy):
            look(graze, solid, motion, f"far columns, {rounding}", options, text=points)
        for far in ("1e20000", "-1e20000", "1.797693134862315808e308"):
            text = points + f"1,1,{far}\n".encode()
            for form in ("vtk", "npy"):
                done = run(graze, "classify", solid, motion, *options, "--format", form, text=text)
                says = f"row {len(fields) + 1}, column far: '{far}'; expected a number that binary64 can hold"
                check(done.returncode == 3 and done.stdout == b"" and says in done.stderr.decode(), far, rounding, form,
                      done.returncode, done.stderr)
            kept = table(graze, solid, motion, *options, text=text)[-1]["far"]
            check(kept == far, "a number past the range is carried as it was", rounding, kept)


def check_tables(graze):
    thirds = b"x,y,weight,o'note\n1/3,1,1.5e-3,\"a,b\"\n-1e40,2/7,22/7,\n23,4,-.5,a\n"
    flat, moved, _ = files("figure4")
    space = files("bracket")
    for look in (check_vtk, check_npy):
        look(graze, flat, moved, "further columns", ["-"], text=thirds)
        look(graze, *space[:2], "bracket", [space[2]])
        look(graze, *space[:2], "grid in space", ["--grid", "5,4,3"])
        look(graze, flat, moved, "grid in the plane", ["--grid", "7,3", "--box", "0,0,1/3,5"])
        look(graze, *files("unsweep-figure5")[:2], "unsweep",
             [files("unsweep-figure5")[2], "--operation", "unsweep"])
    check_far_columns(graze, flat, moved)
    done = run(graze, "classify", flat, moved, "-", "--format", "npy", text=b"1,1\n2,b\n")
    check(done.returncode == 3 and done.stdout == b"", "a bad row leaves no half array", done.returncode)
    empty = run(graze, "classify", flat, moved, "-", "--format", "npy", text=b"x,y\n").stdout
    check(b"'shape': (0,)" in empty, "an array of no rows", empty[:200])


def main():
    args = options(__doc__)
    graze = args.graze
    cells = 8 if args.sanitizers else 24 * max(1, int(args.scale))  # the same code for each cell
    with tempfile.TemporaryDirectory() as folder:
        excuse_fonts(folder)
        scenes = [("figures-5-7-8", 2 * cells, [], False, True),
                  ("disk-offset", 5 * cells // 3, ["--box", "-2,-3/2,2,5/2", "--times", "9"]),
                  ("bracket", 5 * cells // 3, ["--plane", "z=3/2", "--view", "0,0,1"]),
                  ("cartridge", cells, ["--plane", "y=1/7"]),
                  ("unsweep-figure5", 5 * cells // 4, ["--operation", "unsweep"], True)]
        for scene in args.once(scenes, "cells"):
            check_cells(graze, folder, *scene)
        if args.derived:
            check_marks(graze, folder)
            check_text(graze, folder)
            check_layout(graze, folder)
            check_without_png(graze, folder)
        if args.scale >= 1 and not args.sanitizers:  # the end of the stream
            check_pictures(graze, folder)
    if args.derived:
        check_tables(graze)
    checks.finish()


if __name__ == "__main__":
    main()
