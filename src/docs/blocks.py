"""The blocks of a page of documents: what they run, what they print.

- `sh`: run by /bin/sh. A `text` block next to it is what it prints, both streams; a line `...` there stands for any
  lines. It must end with status 0 unless a `text` block shows otherwise.
- every other language is the caller's.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import re

BLOCK = re.compile(r"^```(\w*)\n(.*?)^```$(?:\n\n```text\n(.*?)^```$)?", re.M | re.S)
PROGRAMS = ("graze", "graze-check", "libgraze.a", "libgraze.so")


def blocks(text):
    """(language, text, output or None) of every block in order."""
    return [match.groups() for match in BLOCK.finditer(text) if match[1] != "text"]


def changes_system(command):
    """Does it install something? tests/install/chroot.py runs such blocks in a bare system."""
    return "sudo " in command or "git clone" in command


def prints(want, got):
    """Is `got` the text `want`, whose lines `...` stand for any number of lines?"""
    parts = re.split(r"^\.\.\.\n", want, flags=re.M)
    return re.fullmatch("(?:.*\n)*?".join(map(re.escape, parts)), got) is not None


def link_into(folder, root, build):
    """Make a folder look like the repository at `root` after `make` into `build`; its own build/ can be written to.
    Returns the programs that are missing."""
    for name in os.listdir(root):
        if not name.startswith(("build", ".git")):
            os.symlink(os.path.join(root, name), os.path.join(folder, name))
    os.mkdir(os.path.join(folder, "build"))
    for name in PROGRAMS:
        os.symlink(os.path.join(build, name), os.path.join(folder, "build", name))
    # The shared library is found by its soname, that of pictures beside it.
    os.symlink("libgraze.so", os.path.join(folder, "build", "libgraze.so.0"))
    for name in os.listdir(build):
        if name.startswith("libgraze-png"):
            os.symlink(os.path.join(build, name), os.path.join(folder, "build", name))
    return [name for name in PROGRAMS if not os.path.exists(os.path.join(build, name))]
