#!/usr/bin/env python3
"""Install the Debian package into a new minimal system and use it there; then type what the tutorial shows a newcomer.

SPDX-License-Identifier: GPL-3.0-or-later

Needs root, debootstrap and the archive's mirror, and takes a minute or two; so it is one of the long tests. apt
must find every dependency in the archive, the program must give the bracket's rows, the library must be known to
the dynamic linker, and after the removal of the package none of its files may be left.
"""
import os
import re
import shutil
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "src", "docs"))

import blocks  # noqa: E402
from programs import ROOT, check, checks, options, output, read, run, same


def release():
    with open("/etc/os-release", encoding="utf-8") as file:
        return re.search(r"^VERSION_CODENAME=(\w+)", file.read(), re.M)[1]


def newcomer(inside, folder):
    """Every block of the tutorial, in one shell's folders, after the packages that its first lines ask for; the clone is made of
    this one. Then what README.md and the tutorial say besides: make demo, an installation without root, a virtual environment."""
    output(["git", "clone", "--quiet", "--bare", ROOT, os.path.join(folder, "srv", "graze.git")])
    output([*inside, "apt-get", "install", "-y", "--no-install-recommends", "git", "make", "gcc", "sudo", "ca-certificates",
            "python3-numpy", "python3-pandas", "python3-venv"], DEBIAN_FRONTEND="noninteractive")
    output([*inside, "git", "config", "--system", "--add", "safe.directory", "*"])
    shell = [*inside, "/bin/sh", "-ec"]
    installs = 0
    for language, command, wanted in blocks.blocks(read("src", "docs", "tutorial.md")):
        if language != "sh":
            continue
        installing = blocks.changes_system(command)
        installs += installing
        command = command.replace("https://example.org/graze.git", "/srv/graze.git")
        print(command.split("\n")[0], flush=True)
        got = output([*shell, f"cd {'/srv' if installing else '/tmp'}\nexec 2>&1\n{command}"], DEBIAN_FRONTEND="noninteractive")
        check(wanted is None or blocks.prints(wanted, got), f"{command}\n  want {wanted}\n  got {got}")
    check(installs == 1, f"{installs} blocks install something")
    for command in ("make demo", "make install PREFIX=/tmp/own", "/tmp/own/bin/graze --version",
                    "python3 -m venv --system-site-packages /tmp/venv && /tmp/venv/bin/pip install ./src/python && cd / && "
                    "/tmp/venv/bin/python -c 'import graze; assert graze.__file__.startswith(\"/tmp/venv\"), graze.__file__'"):
        print(command, flush=True)
        output([*shell, f"cd /srv/graze\n{command}"], DEBIAN_FRONTEND="noninteractive")


def main():
    args = options(__doc__, ("--mirror", {"default": "http://deb.debian.org/debian"}))
    build = os.path.relpath(os.path.dirname(args.graze), ROOT)
    if os.geteuid() != 0 or shutil.which("debootstrap") is None:
        checks.skip("chroot", "only root can make one, with debootstrap")
        checks.finish()
    package = os.path.join(ROOT, output(["make", "-s", f"B={build}", "deb"]).splitlines()[-1])
    folder = tempfile.mkdtemp()
    inside = ["chroot", folder]
    try:
        output(["debootstrap", "--variant=minbase", release(), folder, args.mirror])
        shutil.copy(package, os.path.join(folder, "tmp", "graze.deb"))
        output([*inside, "apt-get", "install", "-y", "--no-install-recommends", "/tmp/graze.deb"],
               DEBIAN_FRONTEND="noninteractive")
        same(output([*inside, "graze", "--version"]), output([args.graze, "--version"]), "versions there and here")
        cases = "/usr/share/graze/cases/bracket"
        table = output([*inside, "graze", "classify", f"{cases}/solid.off", f"{cases}/motion.json",
                        f"{cases}/points.csv"])
        same([line for line in table.splitlines() if not line.startswith("#")],
             read("cases", "bracket", "expected.csv").splitlines(), "the bracket's rows")
        check("libgraze.so.0 " in output([*inside, "ldconfig", "-p"]), "the dynamic linker knows the library")
        files = output([*inside, "dpkg", "-L", "graze"]).split("\n")
        output([*inside, "dpkg", "--purge", "graze"])
        left = [path for path in files if "graze" in path and os.path.lexists(folder + path)]
        check(len(files) > 300 and not left, f"left of {len(files)} files: {left}")
        newcomer(inside, folder)
    finally:
        run(["rm", "-rf", "--one-file-system", folder])
    checks.finish()


if __name__ == "__main__":
    main()
