"""The small scenes of memory.py: what each command is asked, and the files it reads.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import dataclasses
import pathlib
import struct
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
CASES = ROOT / "cases"

CORNERS = [(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (0, 0, 2), (2, 0, 2), (2, 2, 2), (0, 2, 2)]
FACES = [(3, 2, 1, 0), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]
TRIANGLES = [t for a, b, c, d in FACES for t in ((a, b, c), (a, c, d))]

# Two points, as numpy.save writes them.
HEAD = b"{'descr': '<f8', 'fortran_order': False, 'shape': (2, 2)}\n"
ARRAY = b"\x93NUMPY\x01\x00" + bytes((len(HEAD), 0)) + HEAD + struct.pack("<4d", 9, 2, 1, 1)
# A tetrahedron with a vertex of its own in each facet, one facet turned, one cut at the middle of a side, one of no area.
BROKEN = (b"OFF\n14 6 0\n" + b"0 0 0\n2 0 0\n0 2 0\n0 0 2\n" * 3 + b"1 0 0\n1 0 0\n" +
          b"3 0 1 2\n3 4 12 7\n3 13 5 3\n3 1 6 11\n3 2 8 7\n3 0 4 8\n")


def lines(rows, form):
    return "".join(form.format(*row) for row in rows)


OFF = f"OFF\n8 6 0\n{lines(CORNERS, '{} {} {}' + chr(10))}{lines(FACES, '4 {} {} {} {}' + chr(10))}"
OBJ = lines(CORNERS, "v {} {} {}\n") + lines([[i + 1 for i in f] for f in FACES], "f {} {} {} {}\n")
PLY = ("ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\n"
       "element face 6\nproperty list uchar int vertex_indices\nend_header\n"
       f"{lines(CORNERS, '{} {} {}' + chr(10))}{lines(FACES, '4 {} {} {} {}' + chr(10))}")
STL = "solid\n" + "".join("facet normal 0 0 0\nouter loop\n" + lines([CORNERS[i] for i in t], "vertex {} {} {}\n")
                          + "endloop\nendfacet\n" for t in TRIANGLES) + "endsolid\n"
WKT = "POLYGON ((0 0, 6 0, 6 4, 4 4, 4 2, 2 2, 2 4, 0 4, 0 0), (1 1, 1 3/2, 5 3/2, 5 1, 1 1))\n"
TURN = """{"dimension": 3, "pieces": [
  {"t": ["0", "1"], "transform": {"compose": [
    {"rotate": {"axis": ["0", "0", "1"], "center": ["5", "0", "0"], "tan_half": "t"}},
    {"translate": ["0", "0", "t^3"]}]}},
  {"t": ["1", "2"], "transform": {"compose": [
    {"rotate": {"axis": ["0", "0", "1"], "center": ["5", "0", "0"], "tan_half": "1"}},
    {"translate": ["t-1", "0", "1"]}]}}]}
"""
ROLL = """{"dimension": 2, "pieces": [
  {"t": ["0", "1"], "transform": {"translate": ["8*t", "t^3/3"]}},
  {"t": ["1", "2"], "transform": {"translate": ["8", "1/3+(t-1)^2*2"]}}]}
"""
POINTS2 = "id,x,y,note\na,3,1,seen\nb,9,2,\nc,7,4,x\nd,-1,0,\ne,10,1/3,t\nf,8.5,3,u\n"
POINTS3 = "x,y,z,id\n5,1,1,p\n5,1,2,q\n2,1,1,r\n5,3,1,s\n1,1,1,u\n7/2,1,0,v\n"
# Boundary points of U (a hole's corner, its notch, a side) and of the cube, two of them at the motions' breaks.
SITES2 = "id,time,bx,by\na,1/2,1,1\nb,1,4,2\nc,3/2,3,2\nd,0,0,1\n"
SITES3 = "time,bx,by,bz,id\n1/2,2,1,1,p\n1,0,0,2,q\n"
POSES = ("t,x,y,z,qw,qx,qy,qz\n0,0,0,0,1,0,0,0\n0.5,4,0,0.25,0.92387953251128674,0,0,0.38268343236508978\n"
         "1,8,0,0,0.70710678118654757,0,0,0.70710678118654757\n")
PROGRAM = "%\nG21 (mm)\nG0 X0 Y0 Z5\nG1 Z0 F9\nG3 X6 Y8 R5\nG2 X0 Y0.001 Z1 I-3 J-4 ; near\nM2\n"
MATRICES = ("m00,m01,m02,m03,m10,m11,m12,m13,m20,m21,m22,m23\n1,0,0,0,0,1,0,0,0,0,1,0\n"
            "0,-1,0,2,1,0,0,0,0,0,1,1\n")
GOLDEN_SITES = ("time,bx,by,x,y,role,trimmed,near\n1/3,1,0,2,0,contact,no,\nroot(-1 0 2;0;1),1,0,3,0,egress,yes,2/3\n"
                "1/2,0,1,4,1,hidden,yes,1/3\n# complete 3\n")
ANSWERED_SITES = "by,bx,time,role,near\n1,0,1/2,contact,1/3\n0,1,root(-1 0 2;0;1),egress,2/3\n5,5,0,hidden,\n"
NUMBERS = "libflint:libgmp"  # without them a program ends at once, as the other scenes show
SNAPPED = ("time,bx,by,cell\n" + "".join(f"1/2,{x},1,edge {k}-{k + 1}\n" for k, x in enumerate((1, 4, 5, 3)))).encode()
# Scenes of ../examples with a point that each level of a position decides.
WAYS = [("q2.wkt", "seam"), ("dd.wkt", "bent_diagonal"), ("dd.wkt", "pinch_sqrt2"), ("tt.wkt", "apex_28"), ("tt.wkt", "apex_30"),
        ("crossed_roofs.off", "roofs_51"), ("crossed_roofs.off", "roofs_52"), ("tt_prism.off", "apex_28_3"), ("tt_prism.off", "apex_29_3")]
# A bracket of most primitives, its hole's rim in the way of a point; in the plane a cusp, a disk on a plate, and the apex where 14
# half-planes meet, which is undecided below a limit.
BODY3 = """{"dimension": 3, "solid": {"difference": [{"union": [
  {"box": {"low": ["0", "0", "0"], "high": ["2", "2", "2"]}, "name": "block"},
  {"affine": {"matrix": [["1", "0", "0", "1"], ["0", "1", "0", "1"], ["0", "0", "1", "2"]], "of": {"torus":
    {"point": ["0", "0", "0"], "axis": ["0", "0", "1"], "major": "3/4", "minor": "1/4"}}}},
  {"cone": {"point": ["1", "1", "3"], "axis": ["0", "0", "-1"], "slope": "1/2", "to": "1"}}]},
  {"cylinder": {"point": ["1", "1", "0"], "axis": ["0", "0", "1"], "radius": "1/2", "from": "0", "to": "2"}}]}}
"""
CUT = ('{"dimension": 3, "solid": {"intersection": [{"halfspace": {"normal": [0, 3, 4], "offset": 25}}, '
       '{"cylinder": {"point": [0, 0, 0], "axis": [0, 0, 1], "radius": 5, "from": 0}}]}}')
PLANES = ", ".join(f'{{"union": [{{"halfspace": {{"normal": ["{k}", "{k * k + 1}"], "offset": "0"}}}}, '
                   f'{{"halfspace": {{"normal": ["{k + 1}", "{(k + 1) ** 2 + 1}"], "offset": "0"}}}}]}}' for k in range(1, 14))
BODY2 = f"""{{"dimension": 2, "solid": {{"union": [
  {{"intersection": [{{"ball": {{"radius": "1"}}}}, {PLANES}]}},
  {{"intersection": [{{"polynomial": {{"0,2": "1", "3,0": "-1"}}}}, {{"ball": {{"center": ["5", "0"], "radius": "2"}}}}]}},
  {{"polygon": {{"points": [["6", "-3"], ["8", "-3"], ["8", "-2"]]}}}}]}}}}
"""
WEDGE = ('{"dimension": 3, "solid": {"difference": [{"polygon": {"points": [[0, 0], [1, 0], [0, 1]], "extrude": [0, 1]}}, '
         '{"halfspace": {"normal": [2, 0, 1], "offset": "1/2"}}]}}')
HULL = ("// a hull\nhull() {cube(size = [1, 1, 1]); cube(size = [0, 1, 1]); multmatrix([[1, 0, 0, 2], [0, 1, 0, 1], [0, 0, 1, 0], "
        "[0, 0, 0, 1]]) {cube(size = [1, 1, 1]);}}")
ROUND = ("linear_extrude(height = 1, v = [0.6, 0, 0.8], scale = 0) {offset(delta = -0.25) {square(size = [1, 1]);}}\nlinear_extrude(height = 1) {minkowski() {polygon(points = [[0, 0], [3, 0], [1, 1], [0, 3]]); square(size = [1, 1]);}}\nlinear_extrude(height = 1) {offset(r = -0.25) {square(size = [1, 1]); sphere(r = 1);}}\nminkowski() {polyhedron(points = "
         "[[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], faces = [[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]]); sphere(r = 1);}\n"
         "rotate_extrude(angle = 30) {square(size = [1, 1]);}\nhull() {sphere(r = 1); multmatrix([[1, 0, 0, 2], [0, 1, 0, 1], [0, 0, 1, 0], "
         "[0, 0, 0, 1]]) {sphere(r = 1);}}\npolyhedron(points = [[0, 0, 0], [3, 0, 0], [0, 3, 0], [0, 0, 3], [1, 1, 1]], faces = [[0, 2, 1], "
         "[0, 1, 3], [0, 3, 2], [1, 2, 4], [2, 3, 4], [3, 1, 4]]);")
BALL = '{"dimension": %d, "solid": {"ball": {"radius": "1"}}}'
TOUCHING = """{"dimension": 3, "solid": {"difference": [
  {"torus": {"point": ["0", "0", "0"], "axis": ["0", "0", "1"], "major": "2", "minor": "1"}},
  {"cylinder": {"point": ["2", "0", "0"], "axis": ["0", "1", "0"], "radius": "1"}}]}}
"""
TOUCH = '{"dimension": 3, "pieces": [{"t": ["1/2", "1"], "transform": {"translate": ["t^2-1/2", "0", "t^2-1/2"]}}]}'
CURVED2, CURVED3 = "id,x,y\na,0,0\nb,5,1\nc,8,-2\nd,9,1/3\n", "x,y,z,id\n1,1,3,p\n5,1,2,q\n3/2,1,1,r\n2,1,9/4,s\n5,3,1,t\n"
ANSWERS = "id,x,y,pmc,class\na,3,1,in,regular\nb,9,2,out,exterior\nc,7,4,out,exterior\nd,-1,0,in,fold\n"


@dataclasses.dataclass
class Scene:
    """A command, the files of its folder, and those of them or of its output that may be begun."""
    name: str
    arguments: list
    status: int = 0
    files: dict = dataclasses.field(default_factory=dict)
    tables: tuple = ()
    opened: tuple = ()  # made before their content is, and then empty
    spared: str = ""  # libraries whose allocations do not fail

    folders = []

    def lay_out(self, folder):
        folder.mkdir()
        for name, content in self.files.items():
            (folder / name).write_bytes(content)


def shards(graze, command, solid, motion, points):
    """The tables or certificates of three shards."""
    return [subprocess.run([graze, command, "--jobs", "1", "--shard", f"{i}/3", solid, motion, points],
                           stdout=subprocess.PIPE, check=True).stdout for i in (1, 2, 3)]


def put(folder):
    """Write the files that are only read; {name: path}."""
    texts = {"cube.off": OFF, "cube.obj": OBJ, "cube.ply": PLY, "cube.stl": STL, "u.wkt": WKT, "turn.json": TURN,
             "roll.json": ROLL, "2.csv": POINTS2, "3.csv": POINTS3, "poses.csv": POSES, "matrices.csv": MATRICES, "program.nc": PROGRAM,
             "answers.csv": ANSWERS, "sites2.csv": SITES2, "sites3.csv": SITES3,
             "touching.csg.json": TOUCHING, "touch.json": TOUCH, "touch.csv": "x,y,z\n13/5,0,4/5\n", "body3.csg.json": BODY3, "cut.csg.json": CUT, "wedge.csg.json": WEDGE, "hull.csg": HULL, "round.csg": ROUND, "body2.csg.json": BODY2, "ball2.csg.json": BALL % 2, "ball3.csg.json": BALL % 3, "curved3.csv": CURVED3, "curved2.csv": CURVED2,
             "golden-sites.csv": GOLDEN_SITES, "answered-sites.csv": ANSWERED_SITES}
    place = folder / "input"
    place.mkdir()
    for name, text in texts.items():
        (place / name).write_text(text)
    return {name: str(place / name) for name in texts}


def make(graze, folder):
    """All scenes; `folder` gets the files they share."""
    at = put(folder)
    cube, turn, three = at["cube.off"], at["turn.json"], at["3.csv"]
    u, roll, two = at["u.wkt"], at["roll.json"], at["2.csv"]
    one = ["--jobs", "1"]
    golden = subprocess.run([graze, "classify", *one, u, roll, two], stdout=subprocess.PIPE, check=True).stdout
    (folder / "input" / "golden.csv").write_bytes(golden)
    golden_at = str(folder / "input" / "golden.csv")
    receipt = str(folder / "input" / "receipt")
    subprocess.run([graze, "check", cube, turn, "--receipt", receipt], stdout=subprocess.DEVNULL, check=True)
    begun = b"".join(golden.splitlines(keepends=True)[:-3])
    parts = {f"{k}.csv": text for k, text in enumerate(shards(graze, "classify", u, roll, two))}
    for motion in (turn, roll):
        subprocess.run([graze, "convert", motion, "-o", motion + ".plain.json"], check=True, stderr=subprocess.DEVNULL)
    plain_turn, plain_roll = turn + ".plain.json", roll + ".plain.json"
    exact = subprocess.run([graze, "classify", *one, "--coordinates", "exact", u, plain_roll, two], stdout=subprocess.PIPE,
                           check=True).stdout
    certificate = subprocess.run([graze, "certify", *one, u, plain_roll, two], stdout=subprocess.PIPE, check=True).stdout
    certified = certificate[:certificate.rindex(b"row ")]
    certificates = {f"{k}.txt": text for k, text in enumerate(shards(graze, "certify", u, plain_roll, two))}
    candidate = ["--candidate", f"sh -c 'cp {golden_at} $1' sh {{out}} {{points}} {{solid}} {{motion}}"]
    nef = str(ROOT / "tests" / "refuse" / "common" / "nef3" / "ring.nef3")
    yield from (Scene(f"check-{name.rsplit('.', maxsplit=1)[-1]}", ["check", at[name], turn])
                for name in ("cube.off", "cube.obj", "cube.ply", "cube.stl"))
    yield Scene("check-nef3", ["check", nef, turn])
    yield Scene("check-wkt", ["check", u, roll])
    yield Scene("check-receipt", ["check", cube, turn, "--receipt", "new"])
    yield Scene("classify", ["classify", *one, u, roll, two])
    yield Scene("classify-3", ["classify", *one, cube, turn, three])
    yield Scene("classify-jobs", ["classify", "--jobs", "2", u, roll, two, "--output", "table"], tables=("table",))
    yield Scene("classify-exact", ["classify", *one, "--no-filter", cube, turn, three, "--output", "table"],
                tables=("table",))
    yield Scene("classify-pmc", ["classify", *one, "--columns", "pmc", cube, turn, three, "--output", "table"],
                tables=("table",))
    for body, way in WAYS:
        solid, motion = ROOT / "tests/examples/solids" / body, ROOT / "tests/examples/motions" / f"{way}.json"
        yield Scene(f"topo-{way}", ["classify", *one, "--topo", "--format", "jsonl", str(solid), str(motion), "at.csv"],
                    spared=NUMBERS, files={"at.csv": b"0,0,0\n" if body.endswith("off") else b"4,1\n" if way == "seam" else b"0,0\n"})
    yield Scene("regular", ["classify", *one, "--operation", "unsweep", "--regular", "--format", "jsonl", cube, turn, three],
                spared=NUMBERS)
    yield Scene("classify-sdf", ["classify", *one, "--sdf", "1e-2r", "--boundary-distance", u, roll, two], spared=NUMBERS)
    yield Scene("classify-sdf-3", ["classify", *one, "--sdf", "1e-2r", "--boundary-distance", cube, turn, three], spared=NUMBERS)
    yield Scene("classify-decimal", ["classify", *one, "--coordinates", "decimal", "--digits", "3", u, roll, two])
    yield Scene("classify-npy-points", ["classify", *one, "--coordinates", "decimal", u, roll, "points"],
                files={"points": ARRAY})
    yield Scene("solid", ["solid", "cutter", "--diameter", "2", "--corner", "1/2", "--length", "4", "--inside", "in.off", "--outside", "made.off"])
    yield Scene("mend", ["mend", "broken.off", "-o", "made.off"], files={"broken.off": BROKEN})
    yield Scene("mend-weld", ["mend", "broken.off", "--weld", "1e-3", "-o", "made.off"], files={"broken.off": BROKEN})
    yield Scene("classify-jsonl", ["classify", *one, "--format", "jsonl", u, roll, two])
    yield Scene("classify-grid", ["classify", *one, "--grid", "4,3,2", "--receipt", receipt, cube, turn])
    yield Scene("classify-vtk", ["classify", *one, "--format", "vtk", "--grid", "4,3", u, roll, "--output", "made"],
                opened=("made",))
    yield Scene("classify-npy", ["classify", *one, "--format", "npy", u, roll, two, "--output", "made"], opened=("made",))
    yield Scene("classify-resume", ["classify", *one, "--resume", "table", u, roll, two], files={"table": begun},
                tables=("table",))
    yield Scene("contact", ["contact", *one, u, roll, at["sites2.csv"], "--output", "table"], tables=("table",))
    yield Scene("contact-jsonl", ["contact", *one, "--format", "jsonl", cube, turn, at["sites3.csv"]])
    yield Scene("contact-snap", ["contact", *one, "--snap", u, roll, "sites"], spared=NUMBERS, files={"sites": SNAPPED})
    yield Scene("envelope", ["envelope", u, roll, "--events", "e.csv", "--patches", "p.csv", "--joints", "j.csv", "--at", "1/3",
                             "--curve", "c.csv"], tables=("e.csv", "p.csv", "j.csv", "c.csv"))
    yield Scene("envelope-3", ["envelope", cube, turn, "--patches", "p.csv", "--joints", "j.csv", "-n", "3", "--points", "n.csv"],
                tables=("p.csv", "j.csv", "n.csv"))
    yield Scene("collide", ["collide", cube, turn, cube, "--motion-of-fixed", turn, "--format", "json"], 1)
    yield Scene("collide-turn", ["collide", cube, turn, cube, "--inside", "--first"], 1)
    yield Scene("collide-2", ["collide", u, roll, u], 1)
    yield Scene("collide-round", ["collide", at["ball3.csg.json"], turn, cube, "--clearance", "1/3"], 1)
    pairs = f"id,moving,motion,fixed\nx,{cube},{turn},{cube}\ny,none.off,{turn},{cube}\n".encode()
    yield Scene("collide-list", ["collide", *one, "--list", "pairs.csv", "-o", "table"], 3, files={"pairs.csv": pairs}, tables=("table",))
    yield Scene("collide-list-jsonl", ["collide", *one, "--list", "pairs.csv", "--format", "jsonl"], 3, files={"pairs.csv": pairs})
    yield Scene("collide-closest", ["collide", at["ball3.csg.json"], turn, "far.csg.json", "--closest", "4", "--motion-of-fixed", turn],
                files={"far.csg.json": b'{"dimension": 3, "solid": {"ball": {"center": [9, 0, 0], "radius": 1}}}'})
    yield Scene("collide-error", ["collide", u, roll, u, "--motion-error", "1/64", "--clearance", "1/128"], 1)
    yield Scene("outline", ["outline", u, roll, "--operation", "unsweep", "--arcs", "a.csv", "--format", "json"], tables=("a.csv",))
    yield Scene("outline-polygon", ["outline", u, roll, "--polygon", "p.wkt", "--within", "1/8"], tables=("p.wkt",))
    yield Scene("outline-beside", ["outline", u, roll, "--polygon", "p.wkt", "--within", "1/8", "--side", "inside"], tables=("p.wkt",))
    yield Scene("outline-samples", ["outline", u, plain_roll, "--samples", "s.csv", "--certify", "c.txt"], tables=("s.csv", "c.txt"))
    yield Scene("judge", ["judge", cube, turn, cube, "--within", "1r", "--count", "3", "--vertices", "v.csv"], tables=("v.csv",),
                spared=NUMBERS)
    yield Scene("judge-page", ["judge", cube, turn, cube, "--within", "1r", "--budget", "1", "--no-points", "--page", "p.html"],
                tables=("p.html",), spared=NUMBERS)
    yield Scene("judge-json", ["judge", cube, turn, cube, "--budget", "40", "--points", three, "--answers", "a.csv", "--format", "json"],
                tables=("a.csv",), spared=NUMBERS)
    yield Scene("unsweep", ["classify", *one, "--operation", "unsweep", u, roll, two])
    yield Scene("merge", ["merge", "2.csv", "0.csv", "1.csv", "--output", "table"], files=parts, tables=("table",))
    yield Scene("certify", ["certify", *one, cube, plain_turn, three, "-o", "made"], tables=("made",))
    yield Scene("certify-converts", ["certify", *one, at["cube.obj"], turn, at["2.csv"], "-o", "made"], 3,
                tables=("made.off", "made.json"))
    yield Scene("certify-times", ["certify", *one, cube, plain_turn, three, "--times", "-o", "made"], tables=("made",))
    yield Scene("certify-resume", ["certify", *one, u, plain_roll, two, "--resume", "made"], files={"made": certified}, tables=("made",))
    yield Scene("classify-certify", ["classify", *one, u, plain_roll, two, "--resume", "table", "--certify", "made"],
                files={"table": b"".join(exact.splitlines(keepends=True)[:-3]), "made": certificate},
                tables=("table", "made"))
    yield Scene("merge-certificates", ["merge", "2.txt", "0.txt", "1.txt", "--output", "made"], files=certificates, tables=("made",))
    yield Scene("explain", ["explain", cube, turn, "5", "1", "2"])
    yield Scene("explain-2", ["explain", u, roll, "9", "2"])
    yield Scene("explain-svg", ["explain", u, roll, "0", "0", "--svg", "made.svg"], spared=NUMBERS)
    yield Scene("generate", ["generate", cube, turn, "-n", "14", "--seed", "5", "--output", "points"],
                tables=("points",))
    yield Scene("generate-2", ["generate", u, roll, "-n", "14", "--seed", "5", "--representable", "binary64"])
    yield Scene("compare", ["compare", golden_at, at["answers.csv"], "--round", "binary64"], 1)
    yield Scene("compare-contacts", ["compare", at["golden-sites.csv"], at["answered-sites.csv"], "--round", "binary64"], 1)
    yield Scene("compare-contacts-json", ["compare", at["golden-sites.csv"], at["answered-sites.csv"], "--format", "json"], 1)
    yield Scene("compare-json", ["compare", golden_at, at["answers.csv"], "--format", "json", "--output", "report"], 1)
    yield Scene("validate", ["validate", *one, u, roll, "--points", two, *candidate, "--output", "report"])
    yield Scene("draw-svg", ["draw", u, roll, two, "--grid", "6", "-p", "9,2", "-p", "1,1", "-o", "made.svg"])
    yield Scene("draw-png", ["draw", u, roll, "--grid", "6", "-p", "9,2", "-o", "made.png"],
                spared="libcairo:libpixman:libfontconfig:ld-linux")
    yield Scene("draw-distance", ["draw", u, roll, "--grid", "6", "--by", "distance", "-o", "made.svg"], spared=NUMBERS)
    yield Scene("draw-page", ["draw", u, roll, "--grid", "6", "-p", "9,2", "--surface", "1", "-o", "made.html"])
    yield Scene("draw-proof", ["draw", u, plain_roll, two, "--surface", "none", "--certificate", "c.txt", "-o", "made.html"], files={"c.txt": certificate})
    yield Scene("draw-page-3", ["draw", cube, turn, "--grid", "6", "-p", "5,1,2", "--surface", "none", "-o", "made.html"])
    yield Scene("draw-3", ["draw", cube, turn, "--grid", "6", "-p", "5,1,2", "-o", "made.svg"])
    yield Scene("boundary", ["boundary", u, roll, "--depth", "4", "--coarse", "3", "--contacts", "9", "--surface",
                             "s.vtk", "--cells", "c.vtk", "--points", "p.csv"], tables=("s.vtk", "c.vtk", "p.csv"))
    yield Scene("boundary-3", ["boundary", cube, turn, "--depth", "2", "--coarse", "2", "--contacts", "9", "--middles",
                               "--surface", "s.ply"], tables=("s.ply",))
    yield Scene("boundary-stl", ["boundary", cube, turn, "--depth", "1", "--coarse", "1", "--contacts", "1",
                                 "--surface", "s.stl"], tables=("s.stl",))
    yield Scene("boundary-sharp", ["boundary", u, roll, "--depth", "4", "--coarse", "4", "--contacts", "0", "--sharp",
                                   "--surface", "s.ply"], tables=("s.ply",))
    body2, body3 = at["body2.csg.json"], at["body3.csg.json"]
    yield Scene("curved-check", ["check", body3, turn])
    yield Scene("curved", ["classify", *one, "--format", "jsonl", body2, roll, at["curved2.csv"]])
    yield Scene("curved-3", ["classify", *one, body3, turn, at["curved3.csv"]])
    yield Scene("curved-cut", ["check", at["cut.csg.json"], turn])
    yield Scene("rest", ["classify", *one, "--at-rest", "--sdf", "1e-2r", "--format", "jsonl", cube, three], spared=NUMBERS)
    yield Scene("rest-grid", ["classify", *one, "--at-rest", "--grid", "3,3,2", at["cut.csg.json"]])
    yield Scene("curved-touching", ["classify", *one, at["touching.csg.json"], at["touch.json"], at["touch.csv"]])
    yield Scene("planes-convert", ["convert", at["wedge.csg.json"]])
    yield Scene("hull-convert", ["convert", at["hull.csg"], "--smooth=5"])
    yield Scene("round-convert", ["convert", at["round.csg"], "--near-rotation", "1/100"])
    yield Scene("curved-moments", ["classify", *one, "--moments", body3, turn, at["curved3.csv"]])
    yield Scene("curved-explain", ["explain", body2, roll, "0", "0", "--limit", "work=20000"])
    yield Scene("curved-draw", ["draw", at["ball2.csg.json"], roll, "--grid", "2", "-p", "5,1", "-o", "made.svg"])
    yield Scene("curved-page", ["draw", at["ball3.csg.json"], turn, "--grid", "2", "-o", "made.html"])
    yield Scene("line", ["motion", "line", "--by", "8,0,1/3"])
    yield Scene("rotate", ["motion", "rotate", "--degrees", "37.5", "--axis", "0,0,1", "--center", "1,1,0", "--output",
                           "made", "--report", "report"])
    yield Scene("screw", ["motion", "screw", "--degrees", "100", "--axis", "0,0,1", "--pitch", "2", "--tolerance",
                          "1e-2"])
    yield Scene("joints", ["motion", "joints", "turn:90:0,0,1", "turn:-45:0,0,1:2,0,0", "slide:0,0,1", "--tolerance",
                           "1e-1", "--output", "made"])
    yield Scene("poses", ["motion", "poses", at["poses.csv"], "--output", "made"])
    yield Scene("poses-chosen", ["motion", "poses", at["poses.csv"], "--every", "2", "--scale", "1/2", "--ignore", "none",
                                 "--shortest", "--dyadic"])
    yield Scene("poses-slerp", ["motion", "poses", at["poses.csv"], "--slerp", "--tolerance", "1e-3"])
    yield Scene("gcode", ["motion", "gcode", at["program.nc"], "--output", "made"])
    yield Scene("dyadic", ["motion", "dyadic", at["roll.json"]])
    yield Scene("poses-matrices", ["motion", "poses", at["matrices.csv"]])
    yield Scene("poses-affine", ["motion", "poses", "--affine", at["matrices.csv"]])
    yield Scene("cases", ["cases", "--folder", str(CASES)])
