# %% [markdown]
# # From a mesh to a picture of the classes
#
# A part of L-shaped profile is turned by half a circle while it rises. Which points of a plane does it pass
# once, which more than once, which does it only touch? Every answer here is exact.
#
# Run it as it is, `python3 cases/notebook.py PICTURE.svg`, or cell by cell in an editor that knows `# %%`.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# %%
import os
import sys
from collections import Counter
from fractions import Fraction

if "__file__" in globals():
    sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "src", "python"))
import graze

# %% [markdown]
# ## The mesh
# Any .off, .obj, .ply or .stl file would do: `graze.Scene("part.stl", ...)`. Here the profile is extruded from
# z = 0 to z = 2: vertices, and for each facet the numbers of its vertices, counter-clockwise from outside.

# %%
profile = [(1, 0), (5, 0), (5, 1), (2, 1), (2, 3), (1, 3)]
n = len(profile)
vertices = [(x, y, z) for z in (0, 2) for x, y in profile]
facets = [list(reversed(range(n))), list(range(n, 2 * n))]
facets += [[k, (k + 1) % n, n + (k + 1) % n, n + k] for k in range(n)]

# %% [markdown]
# ## The motion
# Two quarter turns about the z axis, and at the same time up by 1. The turns are rational in t, hence exact.

# %%
motion = {"dimension": 3, "pieces": [{"t": ["0", "1"], "transform": {"compose": [
    {"turn": {"quarters": 2, "axis": ["0", "0", "1"]}},
    {"translate": ["0", "0", "s"]}]}}]}
scene = graze.Scene((vertices, facets), motion)
print(f"{scene.solid.facet_count} facets, first and last position meet: {scene.ends_meet}")

# %% [markdown]
# ## One point, in full
# Times of contact are Fractions, or algebraic numbers: a polynomial and the interval of its one root.

# %%
P = ("-1/2", "5/2", "1")
trace = scene.trace(P)
print(f"P = ({', '.join(P)}): {trace.verdict.class_.name.lower()}, word {trace.word}")
for contact in trace.contacts:
    cells = ", ".join(map(str, contact.cells))
    print(f"  {contact.kind} at t = {graze.decimal(contact.start, 12)}, {cells}")
time = trace.contacts[0].start
if isinstance(time, graze.AlgebraicNumber):
    low, high = time.refine(200)
    print(f"  the first is a root of {list(time.coefficients)}, here to within {float(high - low):.1e}")

# %% [markdown]
# ## A plane of points
# A grid of dyadic numbers at z = 1. The floats are taken as the exact numbers they are, so points on the
# circles and lines of the boundary are found to be on it, and none other.

# %%
STEP = Fraction(1, 16)
columns, rows = range(-88, 89), range(-56, 89)
points = [[float(i * STEP), float(j * STEP), 1.0] for j in rows for i in columns]
names = graze.class_names(scene.classify(points, jobs=None))
for name, count in Counter(names).most_common():
    print(f"  {name:14} {count}")

# %% [markdown]
# ## The picture
# Colours that the colour-blind can tell apart; equal neighbours of a row are one rectangle.

# %%
COLOURS = graze.class_colours()
UNIT = 5  # of the picture, for one step of the grid


def place(x, y):
    """Where a point of the plane is in the picture."""
    return (float(x / STEP) - columns[0]) * UNIT + UNIT / 2, (rows[-1] - float(y / STEP)) * UNIT + UNIT / 2


def outline(ring, style):
    """A closed line through points of the plane."""
    text = " ".join(f"{x:g},{y:g}" for x, y in (place(*point) for point in ring))
    return f'<polygon points="{text}" fill="none" stroke="#000" stroke-width="1.5" {style}/>'


width, height, margin = len(columns) * UNIT, len(rows) * UNIT, 150
svg = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width + margin} {height}" '
       f'width="{width + margin}" height="{height}" font-family="sans-serif" font-size="14">',
       '<rect width="100%" height="100%" fill="#fff"/>']
for j in range(len(rows)):
    line = names[j * len(columns):(j + 1) * len(columns)]
    start = 0
    for i in range(1, len(line) + 1):
        if i == len(line) or line[i] != line[start]:
            svg.append(f'<rect x="{start * UNIT}" y="{(len(rows) - 1 - j) * UNIT}" '
                       f'width="{(i - start) * UNIT}" height="{UNIT}" '
                       f'fill="{COLOURS[line[start]]}" shape-rendering="crispEdges"/>')
            start = i
svg.append(outline(profile, ""))
svg.append(outline([(-x, -y) for x, y in profile], 'stroke-dasharray="6 4"'))
x, y = place(Fraction(P[0]), Fraction(P[1]))
svg.append(f'<circle cx="{x:g}" cy="{y:g}" r="4" fill="#fff" stroke="#000" stroke-width="1.5"/>'
           f'<text x="{x + 8:g}" y="{y + 4:g}" stroke="#fff" stroke-width="3" paint-order="stroke">P</text>')
shown = [name for name in COLOURS if name in names]
for k, name in enumerate(shown):
    svg.append(f'<rect x="{width + 12}" y="{12 + 26 * k}" width="16" height="16" '
               f'fill="{COLOURS[name]}" stroke="#666"/>'
               f'<text x="{width + 36}" y="{25 + 26 * k}">{name.replace("_", " ")}</text>')
for k, (text, dash) in enumerate((("first position", ""), ("last position", 'stroke-dasharray="6 4"'))):
    y = 20 + 26 * (len(shown) + k)
    svg.append(f'<path d="M{width + 8} {y}h24" stroke="#000" stroke-width="1.5" {dash}/>'
               f'<text x="{width + 36}" y="{y + 5}">{text}</text>')
svg.append("</svg>")
picture = next((name for name in sys.argv[1:] if name.endswith(".svg")), "notebook.svg")
with open(picture, "w", encoding="utf-8") as file:
    file.write("\n".join(svg) + "\n")
print(f"wrote {picture}")
