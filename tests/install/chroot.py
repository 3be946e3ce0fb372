#!/usr/bin/env python3
"""Install the Debian package into a new minimal system and use it there.

SPDX-License-Identifier: GPL-3.0-or-later

Needs root, debootstrap and the archive's mirror, and takes a minute or two; so it is one of the long tests. apt
must find every dependency in the archive, the program must give the bracket's rows, the library must be known to
the dynamic linker, and after the removal of the package none of its files may be left.
"""
import os
import re
import shutil
import tempfile

from programs import ROOT, check, checks, options, output, read, run, same


def release():
    with open("/etc/os-release", encoding="utf-8") as file:
        return re.search(r"^VERSION_CODENAME=(\w+)", file.read(), re.M)[1]


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
    finally:
        run(["rm", "-rf", "--one-file-system", folder])
    checks.finish()


if __name__ == "__main__":
    main()
