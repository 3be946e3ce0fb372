#!/usr/bin/env python3
# suite
"""Does what the documents show, README.md and then src/program/cli/README.md, and compares: the commands, their
output, the links; then pages of the site that have programs in C and Python.

Works in a temporary folder into which the repository's paths are linked; build/ there is a folder of
its own that holds the program and the libraries. The blocks are taken in their order:

- `sh`: run by /bin/sh, unless it calls make or git. A `text` block next to it is what it prints, both
  streams; a line `...` there stands for any lines. It must end with status 0 unless a `text` block
  shows otherwise.

Pages are run as `make docs` runs them (src/docs/build.py), with programs compiled as strict C11 and Python without
numpy. The command in the head of cases/example.c is run as it is, as strict C11, against the static and the shared
library, and with one file after another missing: it must say so. Links must lead to a file and a heading, every command
that `graze --help` lists must be described, and README.md keeps its bounds: installation before the first command of
Graze, one picture, few and short lines.

The examples of each `--help` are typed in one folder, those of `graze --help` first. They must write the files that they
name, and do without any but those and OWN, which stand for the reader's.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "src", "docs"))

import build as site  # noqa: E402
import harness  # noqa: E402
from blocks import blocks, link_into, prints  # noqa: E402
from harness import ROOT, Checks, options  # noqa: E402

COMMANDS = "src/program/cli/README.md"
DOCUMENTS = ("README.md", COMMANDS)
PAGES = ("unit-tests", "reference-python")
MOST_LINES, WIDEST = 150, 120  # of README.md
# Options of the compiler if the libraries were built with a sanitizer.
SANITIZERS = {b"__asan_init": "address", b"__ubsan_handle": "undefined", b"__tsan_init": "thread"}
# The point fb-graze-slide of cases/bracket: its row, and the times and cells its README derives, the times
# 1/2; 11/10; [49/40, 509/320]; [119/64, 2] as decimals.
EXAMPLE_OUTPUT = r"""fold_boundary OBOBIBOB
touches at 0\.5, edge .*
crosses at 1\.1, face .*
crosses at 1\.225 to 1\.590625, face .*
touches at 1\.859375 to 2, face .*
"""
checks = Checks()
check = checks.holds


def read(*parts):
    with open(os.path.join(ROOT, *parts), encoding="utf-8") as file:
        return file.read()


def write(text, *parts):
    with open(os.path.join(*parts), "w", encoding="utf-8") as file:
        file.write(text)


class Runner:
    """Runs blocks in the folder, with the libraries of the build folder."""

    def __init__(self, folder, build):
        self.folder = folder
        with open(os.path.join(build, "libgraze.a"), "rb") as file:
            library = file.read()
        self.kinds = [kind for symbol, kind in SANITIZERS.items() if symbol in library]
        self.ran = 0

    def run(self, command, **environment):
        if "graze-check" in command:  # it keeps solid and motion until it ends
            environment["ASAN_OPTIONS"] = "detect_leaks=0"
        done = harness.run(["/bin/sh", "-c", command], 300, cwd=self.folder, stderr=subprocess.STDOUT,
                           env=dict(os.environ, **environment))
        return done.stdout, done.returncode

    def show(self, command, output, **environment):
        got, status = self.run(command, **environment)
        if output is None:
            check(status == 0, f"status {status} of\n{command}it printed\n{got}")
        else:
            check(prints(output, got), f"\n{command}should print\n{output}and prints\n{got}")

    def programs(self, command):
        """The compile command with what the library at hand needs: as it is, strict, and strict with the
        shared library."""
        if self.kinds:
            flags = f"clang -fsanitize={','.join(self.kinds)} -fsanitize-link-c++-runtime "
            command = re.sub(r"^cc ", flags, command, flags=re.M)
        strict = command.replace("-std=c11", "-std=c11 -Wall -Wextra -pedantic -Werror")
        check(strict != command, "the example is compiled as C11")
        return [command, strict, strict.replace("libgraze.a", "libgraze.so")]

    def page(self, name):
        """A page of the site, with strict C11, the library's sanitizers, and Python that finds no numpy."""
        without = os.path.join(self.folder, "build", "without")

        def change(command):
            if self.kinds and re.search(r"^python3 ", command, re.M):
                return "true"  # the interpreter cannot load a library with a sanitizer's calls
            command = self.programs(command)[1] if "-std=c11" in command else command
            return re.sub("^python3 ", f"PYTHONPATH={without}:$PYTHONPATH python3 ", command, flags=re.M)

        os.makedirs(without, exist_ok=True)
        write("raise ImportError('numpy is hidden')\n", without, "numpy.py")
        wrong = site.run_page(os.path.join(ROOT, "src", "docs", f"{name}.md"), self.folder, change)
        check(wrong == 0 or self.kinds, f"{name}.md: {wrong} blocks do not do what the page shows")

    def example_file(self):
        """cases/example.c by the command in its head."""
        head = re.search(r"^ \*   (cc .*?)\n \*\n", read("cases", "example.c"), re.M | re.S)
        if not check(head, "cases/example.c says how to compile it"):
            return
        command = re.sub(r"^ \* *", "", head[1], flags=re.M) + "\n"
        check("libgraze.a" in command, "the example is linked with libgraze.a")
        for program in self.programs(command):
            got, status = self.run(program, LD_LIBRARY_PATH="build")
            check(status == 0 and re.fullmatch(EXAMPLE_OUTPUT, got), f"cases/example.c: {status}, {got}")
        text = read("cases", "example.c")
        paths = re.findall(r'"(cases/[^"]*)"', text)
        check(len(paths) == 2, f"files that cases/example.c reads: {paths}")
        for path in paths:  # status 1 and the message of the context
            write(text.replace(path, path + ".gone"), self.folder, "build", "changed.c")
            got, status = self.run(self.programs(command.replace("cases/example.c", "build/changed.c"))[1])
            check(status == 1 and f"{path}.gone" in got, f"{path} missing: status {status}, {got}")

    def examples(self, text):
        """Run every block of commands, unless it builds."""
        for language, body, output in blocks(text):
            if language == "sh" and not re.search(r"^(make|git)\b", body, re.M):
                self.ran += 1
                self.show(body, output)


def slug(heading):
    """The anchor of a heading."""
    return re.sub(r"[^\w -]", "", heading.lower()).replace(" ", "-")


def links(name, text):
    """Every link to a file leads to one, and its anchor to a heading there."""
    for target, anchor in re.findall(r"\]\(([^)#:]*)(?:#([^)]*))?\)", text):
        path = os.path.join(ROOT, os.path.dirname(name), target) if target else os.path.join(ROOT, name)
        if check(os.path.exists(path), f"{name}: a link leads to {target}") and anchor:
            slugs = {slug(heading) for heading in re.findall(r"^#+ (.*)$", read(path), re.M)}
            check(anchor in slugs, f"{name}: {path} has no heading #{anchor}")


def names(texts, graze):
    """Links lead somewhere, and every command is described."""
    for name, text in texts.items():
        links(name, text)
    overview = asked(graze, "--help")
    commands = re.findall(r"^  graze ([a-z]+)", overview, re.M)
    check(len(commands) >= 3, "graze --help lists the commands")
    described = set(re.findall(r"^\| `graze ([a-z]+)", texts[COMMANDS], re.M))
    check(described == set(commands), f"commands: {sorted(commands)}, described: {sorted(described)}")


def bounds(readme):
    """README.md's promises to a reader who has a minute."""
    lines = readme.splitlines()
    check(len(lines) <= MOST_LINES, f"README.md: {len(lines)} lines, expected at most {MOST_LINES}")
    for number, line in enumerate(lines, 1):
        check(len(line) <= WIDEST, f"README.md:{number}: {len(line)} characters, expected at most {WIDEST}")
    check(len(re.findall(r"^!\[", readme, re.M)) == 1, "README.md: one picture")
    commands = [body for language, body, _ in blocks(readme) if language == "sh"]
    check(commands and commands[0].startswith("make "), "README.md: installation before the first command of Graze")
    check(0 < readme.find("\n## Install\n") < readme.find("build/graze "), "README.md: the heading of the installation comes first")


def box():
    """The sweep of the cube of `graze --help`, as STL: for each axis two facets, seen from outside."""
    lines = ["solid box"]
    for axis, end in ((axis, end) for axis in range(3) for end in (0, 1)):
        ring = [(0, 0), (1, 0), (1, 1), (0, 1)][::1 if end else -1]
        for corners in (ring[:3], [ring[0], *ring[2:]]):
            places = [{axis: end, (axis + 1) % 3: u, (axis + 2) % 3: v} for u, v in corners]
            lines += ["facet normal 0 0 0", "outer loop"]
            lines += [f"vertex {10 * p[0]} {2 * p[1]} {2 * p[2]}" for p in places] + ["endloop", "endfacet"]
    return "\n".join([*lines, "endsolid box", ""])


OWN = {"part.stl": box(), "swept.stl": box(), "design.csg": "cube(size = [1, 1, 1], center = false);\n",
       "log.csv": "t,x,y,z,qw,qx,qy,qz\n0,0,0,0,1,0,0,0\n1,8,0,0,1,0,0,0\n",
       "mine": '#!/bin/sh\nexec graze classify "$1" "$2" "$3" -o "$4"\n'}


def examples_of_helps(runner, graze):
    """The first paragraph after the usage of every help is examples, which do what they say."""
    overview = asked(graze, "--help")
    commands = ["motion"] + [name for name in re.findall(r"^  graze ([a-z]+)", overview, re.M) if name != "motion"]
    helps = [overview] + [asked(graze, name, "--help") for name in commands] + [asked(graze + "-check", "--help")]
    for name, text in OWN.items():
        write(text, runner.folder, name)
    os.chmod(os.path.join(runner.folder, "mine"), 0o755)
    named = set()
    for name, text in zip(["graze", *commands, "graze-check"], helps):
        shown = re.match(r".*\n\nExample: (.*(?:\n {9}.*)*)\n\n", text)
        if not check(shown, f"help of {name}: no examples after its usage"):
            continue
        lines = re.sub(r"\n {9}", "\n", shown[1]).replace("\\\n", "").split("\n")
        check(len(lines) <= (4 if name == "graze" else 3), f"help of {name}: {len(lines)} examples")
        check(name.startswith("graze") or any(line.startswith(f"graze {name}") for line in lines), f"help of {name}: examples of others")
        for line in lines:
            got, status = runner.run(f"PATH=$PWD/build:$PATH; {line}")
            check(status == line.startswith("graze collide"), f"{line}: status {status}, it printed\n{got}")  # 1: they meet
            files = set(re.findall(r"[\w-]+(?:\.[a-z]+)+|(?<=\./)mine", line))
            check(all(os.path.getsize(os.path.join(runner.folder, file)) for file in files), f"{line}: an empty file")
            named |= files
        if name == "graze":  # a candidate's table has no comments
            runner.show("grep -v '^#' table.csv > mine.csv", None)
    check(set(OWN) | {"mine.csv"} <= named, f"files that no example reads: {set(OWN) - named}")


def asked(*command):
    return harness.run(command).stdout


def itself():
    """The comparison and the anchors tell right from wrong."""
    for want, got, same in (("a\nb\n", "a\nb\n", True), ("a\n", "a\nb\n", False),
                            ("a\n...\nc\n", "a\nb\nb\nc\n", True), ("...\nc\n", "c\n", True),
                            ("a\n...\nc\n", "a\nb\n", False), ("a\n...\n", "b\na\n", False),
                            (".\n", "x\n", False)):
        check(prints(want, got) == same, f"prints({want!r}, {got!r})")
    check(slug("How fast, and why") == "how-fast-and-why", "slug")


def main():
    graze = options(__doc__).graze
    texts = {name: read(name) for name in DOCUMENTS}
    itself()
    with tempfile.TemporaryDirectory() as folder:
        for name in link_into(folder, ROOT, os.path.dirname(graze)):
            check(False, f"{name} is missing")
        runner = Runner(folder, os.path.dirname(graze))
        for text in texts.values():
            runner.examples(text)
        runner.example_file()
        for name in PAGES:
            runner.page(name)
        examples_of_helps(runner, graze)
    check(runner.ran >= 13, f"only {runner.ran} blocks of commands were run")
    names(texts, graze)
    bounds(texts["README.md"])
    checks.finish()


if __name__ == "__main__":
    main()
