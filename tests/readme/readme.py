#!/usr/bin/env python3
# suite
"""Does what README.md shows, and compares: the commands, their output, the C example, the names.

Works in a temporary folder into which the repository's paths are linked; build/ there is a folder of
its own that holds the program and the libraries. The blocks are taken in their order:

- `sh`: run by /bin/sh, unless it calls make or git. A `text` block next to it is what it prints, both
  streams; a line `...` there stands for any lines. Without one it must end with status 0.
- `c`: written to build/example.c. The block that compiles it is run again as strict C11, against the
  static and the shared library.

Links must lead somewhere, every target, option and command named must exist, and every command that
`graze --help` lists must be described.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
BLOCK = re.compile(r"^```(\w*)\n(.*?)^```$(?:\n\n```text\n(.*?)^```$)?", re.M | re.S)
# What the compiler must be told if the libraries were built with a sanitizer.
SANITIZERS = {b"__asan_init": "address", b"__ubsan_handle": "undefined", b"__tsan_init": "thread"}
passed = failed = 0


def check(holds, message):
    global passed, failed
    passed, failed = passed + bool(holds), failed + (not holds)
    if not holds:
        print("FAILED", message)
    return holds


def prints(want, got):
    """Is `got` the text `want`, whose lines `...` stand for any number of lines?"""
    parts = re.split(r"^\.\.\.\n", want, flags=re.M)
    return re.fullmatch("(?:.*\n)*?".join(map(re.escape, parts)), got) is not None


def blocks(text):
    """(language, text, output or None) of every block in order."""
    return [match.groups() for match in BLOCK.finditer(text) if match[1] != "text"]


def link_into(folder, build):
    """A folder that looks like the repository after `make`, and can be written to."""
    for name in os.listdir(ROOT):
        if not name.startswith("build"):
            os.symlink(os.path.join(ROOT, name), os.path.join(folder, name))
    os.mkdir(os.path.join(folder, "build"))
    for name in ("graze", "libgraze.a", "libgraze.so"):
        path = os.path.join(build, name)
        if check(os.path.exists(path), f"{path} is missing"):
            os.symlink(path, os.path.join(folder, "build", name))


def run(command, folder, **environment):
    done = subprocess.run(["/bin/sh", "-c", command], cwd=folder, stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=300,
                          env=dict(os.environ, **environment))
    return done.stdout.decode("utf-8", "replace"), done.returncode


def sanitized(command, build):
    """The compile command, with what the library at hand needs."""
    with open(os.path.join(build, "libgraze.a"), "rb") as file:
        library = file.read()
    kinds = [kind for symbol, kind in SANITIZERS.items() if symbol in library]
    if not kinds:
        return command
    flags = f"clang -fsanitize={','.join(kinds)} -fsanitize-link-c++-runtime "
    return re.sub(r"^cc ", flags, command, flags=re.M)


def show(command, output, folder, **environment):
    got, status = run(command, folder, **environment)
    if output is None:
        check(status == 0, f"status {status} of\n{command}it printed\n{got}")
    else:
        check(prints(output, got), f"\n{command}should print\n{output}and prints\n{got}")


def show_c(body, output, folder):
    """The example as it is, as strict C11, and with the shared library."""
    strict = body.replace("-std=c11", "-std=c11 -Wall -Wextra -Werror")
    check(strict != body, "the example is compiled as C11")
    shared = strict.replace("libgraze.a", "libgraze.so")
    check(shared != strict, "the example is linked with libgraze.a")
    show(body, output, folder)
    show(strict, output, folder)
    # The shared library is found by its soname.
    os.symlink("libgraze.so", os.path.join(folder, "build", "libgraze.so.0"))
    show(shared, output, folder, LD_LIBRARY_PATH="build")


def examples(text, folder, build):
    """Run every block; (blocks of commands that were run, C programs)."""
    commands = programs = 0
    for language, body, output in blocks(text):
        if language == "c":
            with open(os.path.join(folder, "build", "example.c"), "w", encoding="utf-8") as file:
                file.write(body)
            programs += 1
        if language != "sh" or re.search(r"^(make|git)\b", body, re.M):
            continue
        commands += 1
        if "build/example.c" in body:
            show_c(sanitized(body, build), output, folder)
        else:
            show(body, output, folder)
    return commands, programs


# Options of GNU parallel and Slurm in the recipes.
OF_OTHERS = {"--sshloginfile", "--workdir", "--array", "--cpus-per-task", "--requeue"}


def names(text, graze):
    """Everything the README names exists, and every command is described."""
    for target in re.findall(r"\]\(([^)#:]+)\)", text):
        check(os.path.exists(os.path.join(ROOT, target)), f"a link leads to {target}")
    with open(os.path.join(ROOT, "Makefile"), encoding="utf-8") as file:
        targets = set(re.findall(r"^([a-z-]+):", file.read(), re.M))
    for target in sorted(set(re.findall(r"(?:`|^)make ([a-z-]+)", text, re.M))):
        check(target in targets, f"make {target}: no such target")
    overview = run(f"'{graze}' --help", ROOT)[0]
    commands = re.findall(r"^  graze ([a-z]+)", overview, re.M)
    check(len(commands) >= 3, "graze --help lists the commands")
    described = set(re.findall(r"^\| `graze ([a-z]+)", text, re.M))
    check(described == set(commands), f"commands: {sorted(commands)}, described: {sorted(described)}")
    helps = overview + "".join(run(f"'{graze}' {c} --help", ROOT)[0] for c in commands)
    known = set(re.findall(r"--[a-z][a-z-]*", helps)) | {"--help"} | OF_OTHERS
    for option in sorted(set(re.findall(r"(?<![\w-])--[a-z][a-z-]*", text))):
        check(option in known, f"{option} is in no --help")


def itself():
    """The comparison tells right from wrong."""
    for want, got, same in (("a\nb\n", "a\nb\n", True), ("a\n", "a\nb\n", False),
                            ("a\n...\nc\n", "a\nb\nb\nc\n", True), ("...\nc\n", "c\n", True),
                            ("a\n...\nc\n", "a\nb\n", False), ("a\n...\n", "b\na\n", False),
                            (".\n", "x\n", False)):
        check(prints(want, got) == same, f"prints({want!r}, {got!r})")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--graze", default="build/graze")
    parser.add_argument("--scale", type=int, default=1)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    graze = os.path.abspath(options.graze)
    with open(os.path.join(ROOT, "README.md"), encoding="utf-8") as file:
        text = file.read()
    itself()
    folder = tempfile.mkdtemp()
    try:
        link_into(folder, os.path.dirname(graze))
        commands, programs = examples(text, folder, os.path.dirname(graze))
    finally:
        shutil.rmtree(folder)
    check(commands >= 4, f"only {commands} blocks of commands were run")
    check(programs == 1, f"{programs} C examples")
    names(text, graze)
    print(f"{passed} passed, {failed} failed")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
