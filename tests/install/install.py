#!/usr/bin/env python3
"""# suite: installs into a temporary folder and uses what is there as others would.

SPDX-License-Identifier: GPL-3.0-or-later

`make install DESTDIR=... PREFIX=/opt/graze`: the files, the symbols both libraries show, a C and a C++ program
built with pkg-config and with CMake, man pages, completion; then `make uninstall`, after which only what was
there before is left. `make deb`: the package's dependencies and what lies in it.
"""
import json
import os
import re
import shutil
import sys
import tempfile

from pages import check_all, public_functions
from programs import ROOT, check, checks, options, output, read, run, same

HERE = os.path.dirname(os.path.abspath(__file__))
PREFIX = "/opt/graze"
PARTS = "version core report generate compare convert draw boundary certify topo contact envelope grid distance curved pair judge solid outline".split()
# c(t) = P - (8t, 0, 0): at y = z = 1 it enters the cube [0, 2]^3 at x = 2 and leaves it at x = 0; at z = 2 it
# slides along the top; at y = 3 it passes by. Without its last facet the cube is open.
C_OUTPUT = "regular OBIBO\nboundary OBO\nexterior O\nrefused\n7\n"
# This motion in the plane, past the square [0, 2]^2.
CXX_OUTPUT = "in\non\nout\nrefused\n"


WARNINGS = ["-Wall", "-Wextra", "-pedantic", "-Werror"]


def version_of_header():
    return re.search(r'#define GRAZE_VERSION "(.*)"', read("include", "graze", "version.h"))[1]


def files_under(folder):
    return {os.path.relpath(os.path.join(path, name), folder)
            for path, folders, names in os.walk(folder) for name in names + folders
            if name in names or os.path.islink(os.path.join(path, name))}


def check_tree(root, version):
    files = {name for name in files_under(root) if not name.startswith(("share/graze/", "share/man/", "lib/python3/dist-packages/graze"))}
    mpi = {"bin/graze-mpi"} if shutil.which("mpicc") else set()
    png = {f"lib/libgraze-png-{version}.so"} if os.path.exists("/usr/include/cairo/cairo.h") else set()
    same(files, mpi | png | {"bin/graze", "bin/graze-check", "include/graze.h", "include/graze.hpp", "include/graze/testing.hpp", *(f"include/graze/{name}.h" for name in PARTS), "lib/libgraze.a", "lib/libgraze.so", "lib/libgraze.so.0",
                 f"lib/libgraze.so.{version}", "lib/pkgconfig/graze.pc", "lib/cmake/graze/grazeConfig.cmake",
                 "lib/cmake/graze/grazeConfigVersion.cmake", "share/bash-completion/completions/graze",
                 "share/doc/graze/README.md", "share/doc/graze/CHANGELOG.md", "share/doc/graze/CITATION.cff",
                 "share/doc/graze/LICENSE", "share/doc/graze/LICENSE.three", "share/doc/graze/formats.md", "share/doc/graze/semantics.md", "share/doc/graze/glossary.md"}, "files installed")
    for name in ("libgraze.so", "libgraze.so.0"):
        same(os.path.basename(os.path.realpath(f"{root}/lib/{name}")), f"libgraze.so.{version}", name)
    check(not any("__pycache__" in name for name in files_under(root)), "no compiled Python is installed")
    installed = output([f"{root}/bin/graze", "cases", "--folder", f"{root}/share/graze/cases"])
    same(installed, output([f"{root}/bin/graze", "cases", "--folder", "cases"]), "golden cases installed")
    same(installed, output([f"{root}/bin/graze", "cases"], "/"), "the golden cases are found where they were installed")
    if png: # found by the installed program, which is not in the build folder
        picture = os.path.join(root, "picture.png")
        output([f"{root}/bin/graze", "draw", "cases/figure4/solid.wkt", "cases/figure4/motion.json", "--grid", "4", "-o", picture],
               ASAN_OPTIONS="detect_leaks=0") # fontconfig keeps its own until the end
        with open(picture, "rb") as file:
            check(file.read(8) == b"\x89PNG\r\n\x1a\n", "a PNG picture of the installed program")
        os.remove(picture)
    page = os.path.join(root, "page.html")
    output([f"{root}/bin/graze", "draw", "cases/figure4/solid.wkt", "cases/figure4/motion.json", "-o", page])
    check(os.path.getsize(page) > 500_000, "a page of the installed program, with three.js")
    os.remove(page)
    for name in ("graze.pc", "grazeConfig.cmake", "grazeConfigVersion.cmake"):
        folder = "pkgconfig" if name.endswith(".pc") else "cmake/graze"
        with open(f"{root}/lib/{folder}/{name}", encoding="utf-8") as file:
            check(re.search("@[A-Z_]+@", file.read()) is None, f"{name} is filled in")


def symbols(path, *options):
    """Defined symbols with their letters, as nm gives them."""
    return {tuple(line.split()[-2:]) for line in output(["nm", "--defined-only", *options, path]).splitlines()
            if len(line.split()) >= 3}


def check_symbols(root, build):
    public = {("T", name) for name in public_functions()}
    same(symbols(f"{root}/lib/libgraze.so", "-D"), public, "symbols of the shared library")
    same(symbols(f"{root}/lib/libgraze.a", "-g"), public, "symbols of the static library")
    check(("T", "context_fail") in symbols(os.path.join(build, "libgraze.a"), "-g"),
          "context_fail, which consumer.c has too, is one of Graze's inner functions")
    dynamic = output(["objdump", "-p", f"{root}/lib/libgraze.so"])
    same(re.findall(r"SONAME +(\S+)", dynamic), ["libgraze.so.0"], "soname")


def check_python(root):
    """The module is whole and takes the library installed beside it."""
    module = f"{root}/lib/python3/dist-packages"
    same(files_under(f"{module}/graze"), {name for name in os.listdir(os.path.join(ROOT, "src", "python", "graze"))
                                         if name != "__pycache__"}, "files of the Python module")
    info = f"graze-{version_of_header()}.dist-info"
    same(files_under(f"{module}/{info}"), {"METADATA", "entry_points.txt"}, "what pip and pytest read")
    code = ("import importlib.metadata as m; found = m.distribution('graze'); "
            "print(found.version, *[(e.group, e.value) for e in found.entry_points])")
    same(output([sys.executable, "-c", code], root, PYTHONPATH=module, PYTHONDONTWRITEBYTECODE="1"),
         f"{version_of_header()} ('pytest11', 'graze.pytest_plugin')\n", "the entry point of pytest")
    # The second row of cases/bracket, and the library that is loaded.
    code = ("import graze, re; c = 'share/graze/cases/bracket/'; s = graze.Scene(c + 'solid.off', c + 'motion.json'); "
            "print(s.trace(['3/5', '29/5', '3/2']).word); "
            "print(*sorted(set(re.findall(r'/\\S*/libgraze\\S*', open('/proc/self/maps').read()))))")
    got = output([sys.executable, "-c", code], root, PYTHONPATH=module, PYTHONDONTWRITEBYTECODE="1")
    same(got, f"OBO\n{os.path.realpath(root)}/lib/libgraze.so.{version_of_header()}\n", "the Python module")


def needs_graze(program):
    return "libgraze" in output(["objdump", "-p", program])


def build_and_run(command, program, want, shared, library_path=""):
    if run(command)[2] != 0:
        check(False, f"{command}: {run(command)[1]}")
        return
    same(output([program], LD_LIBRARY_PATH=library_path), want, " ".join(command))
    same(needs_graze(program), shared, f"{' '.join(command)} asks for the shared library")


def check_pkg_config(root, stage, folder, version):
    environment = {"PKG_CONFIG_PATH": f"{root}/lib/pkgconfig", "PKG_CONFIG_SYSROOT_DIR": stage}
    same(output(["pkg-config", "--modversion", "graze"], **environment), version + "\n", "version of graze.pc")
    flags = output(["pkg-config", "--cflags", "--libs", "graze"], **environment).split()
    check("-lstdc++" not in flags, f"the shared library needs no more than itself and GMP: {flags}")
    static = output(["pkg-config", "--static", "--cflags", "--libs", "graze"], **environment).split()
    static = ["-l:libgraze.a" if flag == "-lgraze" else flag for flag in static]
    for compiler, source, standard, want in (("gcc", "consumer.c", "c11", C_OUTPUT),
                                             ("g++", "consumer.cpp", "c++17", CXX_OUTPUT)):
        program = os.path.join(folder, "program")
        start = [compiler, f"-std={standard}", *WARNINGS, os.path.join(HERE, source), "-o", program]
        build_and_run(start + flags, program, want, True, f"{root}/lib")
        build_and_run(start + static, program, want, False)


def check_example(root, stage, folder):
    """The program at the head of graze.h, with README's cube that moves by 8 along x."""
    head = re.search(r"^ \* Example\n \*\n(.*?)^ \* cases/", read("include", "graze.h"), re.M | re.S)[1]
    code = "".join(re.sub(r"^ \* {0,5}", "", line) + "\n" for line in head.splitlines())
    scene = {"example.c": code,
             "cube.off": "OFF\n8 6 0\n0 0 0\n2 0 0\n2 2 0\n0 2 0\n0 0 2\n2 0 2\n2 2 2\n0 2 2\n"
                         "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n",
             "move.json": '{"dimension": 3, "pieces": [{"t": [0, 1], "transform": {"translate": ["8*t", 0, 0]}}]}'}
    for name, text in scene.items():
        with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
            file.write(text)
    program = os.path.join(folder, "example")
    flags = output(["pkg-config", "--cflags", "--libs", "graze"], PKG_CONFIG_PATH=f"{root}/lib/pkgconfig",
                   PKG_CONFIG_SYSROOT_DIR=stage).split()
    output(["gcc", "-std=c11", *WARNINGS, os.path.join(folder, "example.c"), "-o", program, *flags])
    same(output([program], folder, LD_LIBRARY_PATH=f"{root}/lib"), "in regular\non boundary\n", "the example of graze.h")


def check_cmake(root, folder, version):
    wanted = ".".join(version.split(".")[:2])
    output(["cmake", "-S", HERE, "-B", folder, f"-DCMAKE_PREFIX_PATH={root}", f"-DWANTED={wanted}"])
    complaint, status = run(["cmake", "--build", folder])[1:]
    if not check(status == 0, f"cmake: {complaint}"):
        return
    for name, want, shared in (("consumer_c", C_OUTPUT, True), ("consumer_cpp", CXX_OUTPUT, True),
                               ("consumer_static", C_OUTPUT, False)):
        same(output([os.path.join(folder, name)]), want, f"{name} by CMake")
        same(needs_graze(os.path.join(folder, name)), shared, f"{name} asks for the shared library")


def check_citable(graze, version):
    """One version everywhere; a table names it, its contract and the hashes of what it was made of."""
    named = output([graze, "--version"])
    check(re.fullmatch(rf"graze {re.escape(version)}\n" + "".join(
        rf"{name} \d+(\.\d+)+\S*\n" for name in ("GMP", "MPFR", "FLINT", "yajl", "CGAL")), named), named)
    citation = read("CITATION.cff")
    check(f"\nversion: {version}\n" in citation, f"CITATION.cff is of version {version}")
    same(json.loads(read("codemeta.json"))["version"], version, "version of codemeta.json")
    for title in ("Classifying points for sweeping solids", "The dual of sweep"):
        check(f"title: {title}\n" in citation, f"CITATION.cff names {title}")
    same(re.search(r"^## (.*)", read("CHANGELOG.md"), re.M)[1], "1.0.0 - unreleased", "newest section of CHANGELOG.md")
    scene = [f"cases/bracket/{name}" for name in ("solid.off", "motion.json", "points.csv")]
    head = output([graze, "classify", *scene])
    check(f"graze {version}" in head and "contract 1" in head, "a table names version and contract")
    for path in scene[:2]:
        digest = output(["sha256sum", path]).split()[0]
        check(digest in head, f"a table holds the hash of {path}")


def check_uninstall(make, stage, root):
    neighbour = f"{root}/share/man/man1/grazeland.1"
    with open(neighbour, "w", encoding="utf-8"):
        pass
    output([*make, "uninstall", f"DESTDIR={stage}", f"PREFIX={PREFIX}"])
    same(files_under(stage), {os.path.relpath(neighbour, stage)}, "files left")
    left = [path for path, _, _ in os.walk(root) if path != root and os.path.basename(path) == "graze"]
    same(left, [], "folders left")


def check_blanks(make, stage):
    """A path with a blank is refused, not taken for two paths, the first of them removed."""
    kept = stage.split()[0]
    os.mkdir(kept)
    for goal in ("install", "uninstall"):
        for words in ([f"DESTDIR={stage}"], [f"PREFIX={stage}"], [f"PREFIX={kept}", f"DATADIR={stage}"]):
            complaint, status = run([*make, goal, *words])[1:]
            check(status == 2 and "right is a path without blanks" in complaint, f"{goal} {words}: {status} {complaint}")
    same(os.listdir(kept), [], "nothing is made beside it")
    os.rmdir(kept)


def check_deb(make, folder, version):
    package = os.path.join(ROOT, output([*make, "deb"]).splitlines()[-1])
    fields = dict(line.split(": ", 1) for line in output(["dpkg-deb", "-f", package]).splitlines()
                  if re.match(r"[A-Z][\w-]+: ", line))
    same((fields["Package"], fields["Version"]), ("graze", version), "name and version of the package")
    output(["dpkg-deb", "-x", package, folder])
    depends = {item.split()[0] for item in fields["Depends"].split(", ")}
    program = f"{folder}/usr/bin/graze"
    for library, path in re.findall(r"(\S+) => (/\S+)", output(["ldd", program])):
        if library not in re.findall(r"NEEDED +(\S+)", output(["objdump", "-p", program])):
            continue
        # Packages know a library by its path with or without /usr, which are the same folder.
        candidates = (path, os.path.realpath(path), re.sub("^/usr", "", os.path.realpath(path)))
        owners = {line.split(":")[0] for name in candidates for line in run(["dpkg", "-S", name])[0].splitlines()}
        check(owners & depends, f"{library} of {sorted(owners)} is among {sorted(depends)}")
    check(f"graze {version}\n" in output([program, "--version"]), "the packaged program runs")
    cases = f"{folder}/usr/share/graze/cases"
    table = output([program, "classify", *(f"{cases}/bracket/{name}" for name in
                                           ("solid.off", "motion.json", "points.csv"))])
    same([line for line in table.splitlines() if not line.startswith("#")],
         read("cases", "bracket", "expected.csv").splitlines(), "the packaged program's rows of the bracket")
    packed = files_under(folder)
    for name in ("doc/graze/copyright", "doc/graze/changelog.gz", "man/man1/graze.1.gz", "man/man3/graze.3.gz"):
        check(f"usr/share/{name}" in packed, f"the package lacks {name}")
    sums = output(["dpkg-deb", "-I", package, "md5sums"]).split()[1::2]
    same(set(sums), {name for name in packed if not os.path.islink(f"{folder}/{name}")}, "files with a sum")


def main():
    args = options(__doc__)
    build = os.path.relpath(os.path.dirname(args.graze), ROOT)
    make = ["make", "-s", f"B={build}"]
    version = version_of_header()
    with tempfile.TemporaryDirectory() as folder:
        stage, root = f"{folder}/stage", f"{folder}/stage{PREFIX}"
        for name in ("work", "cmake", "deb"):
            os.mkdir(os.path.join(folder, name))
        output([*make, "install", f"DESTDIR={stage}", f"PREFIX={PREFIX}"])
        check_tree(root, version)
        check_all(f"{root}/bin/graze", root, f"{folder}/work")
        check_citable(f"{root}/bin/graze", version)
        if not args.sanitizers:  # a library that needs a runtime of its own
            check_symbols(root, os.path.join(ROOT, build))
            check_pkg_config(root, stage, f"{folder}/work", version)
            check_example(root, stage, f"{folder}/work")
            check_python(root)
            check_cmake(root, f"{folder}/cmake", version)
            check_deb(make, f"{folder}/deb", version)
        check_uninstall(make, stage, root)
        same(run([*make, "install", f"DESTDIR={stage}", "PREFIX=here"])[2], 2, "a PREFIX that is no full path")
        check_blanks(make, f"{folder}/two words")
        shutil.rmtree(stage)
    checks.finish()


if __name__ == "__main__":
    main()
