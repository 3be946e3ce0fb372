#!/usr/bin/env python3
"""Install the Debian package into a new minimal system and use it there.

SPDX-License-Identifier: GPL-3.0-or-later

Needs root, debootstrap and the archive's mirror, and takes a minute or two; so it is one of the long tests. apt
must find every dependency in the archive, the program must give the bracket's rows, the library must be known to
the dynamic linker, and after the removal of the package none of its files may be left.
"""
import argparse
import os
import re
import shutil
import sys
import tempfile

import tally
from tally import ROOT, check, output, read, run, same


def release():
    with open("/etc/os-release", encoding="utf-8") as file:
        return re.search(r"^VERSION_CODENAME=(\w+)", file.read(), re.M)[1]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--graze", default="build/graze")
    parser.add_argument("--mirror", default="http://deb.debian.org/debian")
    options = parser.parse_args()
    build = os.path.relpath(os.path.dirname(os.path.abspath(options.graze)), ROOT)
    if os.geteuid() != 0 or shutil.which("debootstrap") is None:
        print("SKIP chroot: only root can make one, with debootstrap\n0 passed, 0 failed, 1 skipped")
        return
    package = os.path.join(ROOT, output(["make", "-s", f"B={build}", "deb"]).splitlines()[-1])
    folder = tempfile.mkdtemp()
    inside = ["chroot", folder]
    try:
        output(["debootstrap", "--variant=minbase", release(), folder, options.mirror])
        shutil.copy(package, os.path.join(folder, "tmp", "graze.deb"))
        output([*inside, "apt-get", "install", "-y", "--no-install-recommends", "/tmp/graze.deb"],
               DEBIAN_FRONTEND="noninteractive")
        same(output([*inside, "graze", "--version"]), output([options.graze, "--version"]), "versions there and here")
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
    finally:
        run(["rm", "-rf", "--one-file-system", folder])
    print(f"{tally.passed} passed, {tally.failed} failed")
    sys.exit(1 if tally.failed else 0)


if __name__ == "__main__":
    main()
