"""The codes of the benchmark: where each comes from, how it is asked, and at which settings.

SPDX-License-Identifier: CC0-1.0
"""
import os
import shutil
import subprocess
import sys

from tables import BadInput, read_table

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
CANDIDATES = os.path.join("cases", "candidates")
ROUNDING = 1e-9  # of a rigid motion's poses
OURS = ["{program}", "{parameter}", "{solid}", "{motion}", "{points}", "{out}"]


def output(command):
    return subprocess.run(command, check=False, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout


def run_or_raise(command):
    done = subprocess.run(command, check=False, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode:
        raise BadInput(f"{' '.join(command)}: status {done.returncode}: {done.stdout.strip()}")


def compile_c(source, folder):
    made = os.path.join(folder, os.path.basename(source) + ".o")
    run_or_raise(["cc", "-std=c11", "-D_POSIX_C_SOURCE=200809L", "-O2", "-c", "-o", made, source])
    return made


class Code:
    """How a code is had and asked.

    settings: (words for the table, what stands for {parameter}, which poses it reads or None). installed: a path, or a
    program, that is there where it is; package: Debian's, whose version is told. sources are compiled if there are any.
    """

    def __init__(self, name, settings, command, sources=(), flags=(), libraries=(), **more):
        self.name, self.settings, self.command = name, settings, command
        self.sources = [os.path.join(ROOT, source) for source in sources]
        self.flags, self.libraries = list(flags), list(libraries)
        self.asked = None  # some of the settings
        self.package, self.installed = more.get("package"), more.get("installed")
        self.ending, self.lacks = more.get("ending", ".csv"), more.get("lacks", lambda folder, scene: None)

    def there(self):
        return not self.installed or os.path.exists(self.installed) or bool(shutil.which(self.installed))

    def version(self, graze):
        if self.package:
            return output(["dpkg-query", "-W", "-f", "${Version}", self.package])
        return output([graze, "--version"]).partition("\n")[0]

    def told(self):
        """The command as words for a reader."""
        return " ".join(self.command).replace(sys.executable, "python3").replace(ROOT + os.sep, "")

    def compile(self, folder):
        """The program, compiled unless it is newer than its sources."""
        program = os.path.join(folder, self.name)
        sources = [s for s in self.sources if s.endswith((".c", ".cpp"))]
        if not sources or os.path.exists(program) and all(os.path.getmtime(s) < os.path.getmtime(program) for s in self.sources):
            return program
        objects = [compile_c(source, folder) if source.endswith(".c") else source for source in sources]
        run_or_raise(["c++", "-std=c++17", *self.flags, "-o", program + ".part", *objects, *self.libraries])
        os.replace(program + ".part", program)
        return program


def candidate(*names):
    return [os.path.join(CANDIDATES, name) for name in names]


def not_rigid(folder, _):
    """Why distances in the solid's own space say nothing."""
    for row in read_table(os.path.join(folder, "poses-101.csv"))[1]:
        m = [[float(row[f"m{i}{j}"]) for j in range(3)] for i in range(3)]
        if any(abs(sum(m[i][k] * m[j][k] for k in range(3)) - (i == j)) > ROUNDING for i in range(3) for j in range(3)):
            return "the motion is not rigid"
    return None


def not_straight(_, scene):
    return None if scene.get("straight") else "the motion is not straight"


PLAIN = candidate("scene.c", "motion.c", "scene.h")
CODES = [
    Code("sampled", [("101 times", "100", None), ("1001 times", "1000", None)], OURS, candidate("sampled.c") + PLAIN, ["-O2"], ["-lyajl", "-lm"]),
    Code("sampled_sdf", [("101 times", "101", None), ("1001 times", "1001", None)], OURS, candidate("sampled_sdf.c") + PLAIN, ["-O2"],
         ["-lyajl", "-lm"], lacks=not_rigid),
    Code("ei_double", [("ε = 1e-6", "1e-6", None), ("ε = 1e-9", "1e-9", None)], OURS, candidate("ei_double.c") + PLAIN, ["-O2"], ["-lyajl", "-lm"]),
    Code("openvdb", [("101 poses, 1/64", "64", "101"), ("101 poses, 1/128", "128", "101"), ("1001 poses, 1/128", "128", "1001")],
         ["{program}", "{poses}", "{parameter}", "{solid}", "{out}"], candidate("openvdb.cpp") + PLAIN, ["-O2", "-DNDEBUG"],
         ["-lopenvdb", "-ltbb", "-lyajl", "-lm"], package="libopenvdb-dev", installed="/usr/include/openvdb/openvdb.h", ending=".off"),
    Code("openscad", [("101 poses", "", "101"), ("1001 poses", "", "1001")],
         [sys.executable, os.path.join(ROOT, *candidate("openscad.py")), "{poses}", "{solid}", "{out}"], candidate("openscad.py"),
         package="openscad", installed="openscad", ending=".off"),
    Code("minkowski", [("exact", "", None)],
         [sys.executable, os.path.join(ROOT, *candidate("minkowski.py")), "{program}", "{solid}", "{motion}", "{points}", "{out}"],
         ["tests/agree/minkowski.cpp", "tests/agree/legs.h", "tests/agree/shells.h", *candidate("minkowski.py")], ["-O1", "-frounding-math"],
         ["-lmpfr", "-lgmp"], package="libcgal-dev", installed="/usr/include/CGAL/Nef_polyhedron_3.h", lacks=not_straight),
    Code("graze", [("exact, itself", "", None)], ["{graze}", "classify", "{solid}", "{motion}", "{points}", "--quiet", "--output", "{out}"]),
]


def chosen(text):
    """Codes by name, each with the settings of that name's numbers; all of them where none is named."""
    asked = {}
    for name, _, number in (word.partition(":") for word in text.split(",")):
        code = next((code for code in CODES if code.name == name), None)
        if not code or number and number not in map(str, range(1, len(code.settings) + 1)):
            raise BadInput(f"--codes: {name}{':' if number else ''}{number}; expected some of --list")
        asked.setdefault(code, set()).update([int(number) - 1] if number else range(len(code.settings)))
    for code, numbers in asked.items():
        code.asked = [setting for k, setting in enumerate(code.settings) if k in numbers]
    return list(asked)
