#!/usr/bin/env python3
# suite
"""`import graze` after `make install` and after `pip install ./src/python`, with Debian's Python.

Under a user's own prefix the module is found with no variable set; for /usr/local it stands where Debian's Python
looks; for another prefix `make install` prints lines, which are run here. The wheel is made without a download, goes
into a virtual environment, and brings its library, which is made on all cores where it is missing.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import subprocess
import sys
import tempfile

from programs import ROOT, check, checks, options, output, run, same

PYTHON = "/usr/bin/python3" if os.path.exists("/usr/bin/python3") else sys.executable
CUBE = os.path.join(ROOT, "tests", "refuse", "common")
# The cube moves along x: at the height of its top the point is slid along (README).
CODE = ("import graze, re; s = graze.Scene('cube.off', 'move3.json'); print(s.trace([2, 1, 1]).word[0]); "
        "print(*sorted(set(re.findall(r'/\\S*/libgraze\\S*', open('/proc/self/maps').read()))))")


def imports(python, **environment):
    """Lines that CODE prints in a bare environment, or what it complained of."""
    bare = {"PATH": "/usr/bin:/bin", "PYTHONDONTWRITEBYTECODE": "1", **environment}
    done = subprocess.run([python, "-c", CODE], cwd=CUBE, env=bare, capture_output=True, text=True, timeout=120)
    return done.stdout.splitlines() if done.returncode == 0 else [done.stderr]


def installed(make, folder):
    home = os.path.join(folder, "home")
    os.mkdir(home)
    said = output([*make, "install", f"PREFIX={home}/.local"], HOME=home)
    got = imports(PYTHON, HOME=home)
    check(len(got) == 2 and got[1].startswith(f"{os.path.realpath(home)}/.local/lib/libgraze.so"), "the user's own prefix", got, said)
    check(f"export PATH={home}/.local/bin" in said and "PYTHONPATH" not in said, said)
    output([*make, "uninstall", f"PREFIX={home}/.local"], HOME=home)
    check(not any("graze" in name for _, folders, names in os.walk(home) for name in folders + names), "uninstalled")
    stage = os.path.join(folder, "stage")
    said = output([*make, "install", f"DESTDIR={stage}", "PREFIX=/usr/local"])
    looked = output([PYTHON, "-c", "import site; print(*site.getsitepackages(), sep='\\n')"]).splitlines()
    there = [path for path, _, _ in os.walk(stage) if path.endswith("-packages/graze")]
    same([os.path.dirname(path)[len(stage):] for path in there], [path for path in looked if path.startswith("/usr/local/")][:1],
         "the folder under /usr/local")
    check("export" not in said, said)
    prefix = os.path.join(folder, "other")
    said = output([*make, "install", f"PREFIX={prefix}"])
    lines = [line.strip() for line in said.splitlines() if line.strip().startswith("export ")]
    same([line.split()[1].split("=")[0] for line in lines],
         ["PATH", "LD_LIBRARY_PATH", "PKG_CONFIG_PATH", "CMAKE_PREFIX_PATH", "PYTHONPATH"], said)
    script = "\n".join([*lines, "graze --version >/dev/null && pkg-config --exists graze && exec \"$@\""])
    done = subprocess.run(["sh", "-c", script, "sh", PYTHON, "-c", CODE], cwd=CUBE, capture_output=True, text=True, timeout=120,
                          env={"PATH": "/usr/bin:/bin", "PYTHONDONTWRITEBYTECODE": "1"})
    check(done.returncode == 0 and f"{os.path.realpath(prefix)}/lib/libgraze.so" in done.stdout, "with the lines printed", done.stderr)


def checkout():
    """New and changed files in the folder that pip builds in."""
    return run(["git", "status", "--porcelain", "src/python"])[0]


def wheel(library, folder):
    place = os.path.join(folder, "venv")
    if run([PYTHON, "-m", "venv", place])[2] != 0:
        checks.skip("wheel", f"{PYTHON} makes no virtual environment")
        return
    python, before = os.path.join(place, "bin", "python"), checkout()
    _, complaint, status = run([python, "-m", "pip", "install", "--no-index", os.path.join(ROOT, "src", "python")],
                               GRAZE_LIBRARY=library, PIP_DISABLE_PIP_VERSION_CHECK="1")
    if not check(status == 0, "pip install", complaint):
        return
    got = imports(python)
    check(len(got) == 2 and got[1].startswith(os.path.realpath(place)), "the library of the wheel", got)
    shown = output([python, "-m", "pip", "show", "-f", "graze"])
    check("Version: " in shown and "graze/libgraze.so" in shown and "graze/py.typed" in shown and "graze/abi.txt" in shown and "dist-info/entry_points.txt" in shown, shown)
    output([python, "-m", "pip", "uninstall", "-y", "graze"])
    check("No module named" in imports(python)[0], "uninstalled")
    same(checkout(), before, "pip leaves nothing in the checkout")


MAKE = """#!/bin/sh
echo "$@" >>"$0.words"
echo "  compiled 20 of 400"
mkdir -p "$2/build" && echo library >"$2/build/libgraze.so"
"""


def compiled(folder):
    """Where no library is, make is run on all cores, and its lines reach a terminal though pip keeps the output."""
    tools, root = os.path.join(folder, "tools"), os.path.join(folder, "checkout")
    for path in (tools, root):
        os.mkdir(path)
    with open(os.path.join(tools, "make"), "w", encoding="utf-8") as file:
        file.write(MAKE)
    os.chmod(os.path.join(tools, "make"), 0o755)
    code = f"import wheel_backend as w; w.ROOT = {root!r}; print(w._library())"
    words = f"PYTHONDONTWRITEBYTECODE=1 {PYTHON} -c \"{code}\" >{folder}/kept 2>&1"
    done = subprocess.run(["script", "-qec", words, "/dev/null"], cwd=os.path.join(ROOT, "src", "python"), text=True, timeout=60,
                          stdin=subprocess.DEVNULL, capture_output=True,
                          env={"PATH": f"{tools}:/usr/bin:/bin", "SHELL": "/bin/sh", "MAKEFLAGS": "-j1 --jobserver-auth=3,4"})
    with open(os.path.join(folder, "kept"), encoding="utf-8") as file:
        kept = file.read()
    check(done.returncode == 0 and "b'library\\n'" in kept, "a library that is made", done.stdout, kept)
    check("compiled 20 of 400" in done.stdout and "compiled 20 of 400" in kept, "what is shown", done.stdout, kept)
    with open(os.path.join(tools, "make.words"), encoding="utf-8") as file:
        same(file.read().split()[2], f"-j{len(os.sched_getaffinity(0))}", "cores")


def main():
    args = options(__doc__)
    build = os.path.dirname(args.graze)
    if args.sanitizers:
        checks.skip("wheel", "the library is built with a sanitizer, the interpreter is not")
        checks.finish()
    with tempfile.TemporaryDirectory() as folder:
        wheel(os.path.join(build, "libgraze.so"), folder)
        compiled(folder)
        installed(["make", "-s", f"B={os.path.relpath(build, ROOT)}"], folder)
    checks.finish()


if __name__ == "__main__":
    main()
