#!/usr/bin/env python3
"""A wheel that carries the libraries that libgraze.so needs: wheel.py BUILD FOLDER

`pip install FILE` then works where neither FLINT nor a compiler is. Carried is what the dynamic linker finds beyond the libraries that
every Linux with this glibc has (PEP 600); each under a name with a part of its hash, so that another wheel's copy is never taken for
it, with the licence of its Debian package and the version whose sources Debian has. Two runs write the same bytes.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import glob
import hashlib
import os
import platform
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
sys.path.insert(0, os.path.join(ROOT, "src", "python"))

import wheel_backend  # noqa: E402

# Libraries that PEP 600 leaves to the system, of those that Graze meets.
SYSTEM = re.compile(r"(ld-linux.*|linux-vdso|lib(c|m|dl|rt|pthread|stdc\+\+|gcc_s))\.so\b")
# Packages whose code is compiled in.
COMPILED_IN = ("libcgal-dev", "libboost[0-9]*-dev")
COMMON = "/usr/share/common-licenses/"


def said(*words):
    return subprocess.run(words, stdout=subprocess.PIPE, text=True, check=True).stdout


def needed(library):
    """name: path of what a library needs, and what these need, but for the system's."""
    found = dict(re.findall(r"^\s*(\S+) => (/\S+)", said("ldd", library), re.M))
    return {name: path for name, path in sorted(found.items()) if not SYSTEM.match(name)}


def direct(library):
    return re.findall(r"^\s*NEEDED\s+(\S+)", said("objdump", "-p", library), re.M)


def package_of(path):
    """The Debian package of a file, which it may know with or without /usr."""
    real = os.path.realpath(path)
    for name in (real, re.sub("^/usr", "", real), path):
        done = subprocess.run(["dpkg-query", "-S", name], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, check=False)
        if done.returncode == 0:
            return done.stdout.split(": ")[0].split(":")[0]
    sys.exit(f"wheel.py: {path} is of no Debian package; expected one, for its licence")


def carry(build, folder):
    """Copies of libgraze.so and of what it needs, each under its new name, which they ask for."""
    libraries = needed(os.path.join(build, "libgraze.so"))
    names = {}
    for name, path in libraries.items():
        with open(path, "rb") as file:
            part = hashlib.sha256(file.read()).hexdigest()[:8]
        base, ending = name.split(".so", 1)
        names[name] = f"{base}-{part}.so{ending}"
    paths = {"libgraze.so": os.path.join(folder, "libgraze.so")} | {name: os.path.join(folder, new) for name, new in names.items()}
    for name, target in paths.items():
        shutil.copyfile(libraries.get(name, os.path.join(build, "libgraze.so")), target)
        said("strip", "--strip-unneeded", target)
        edits = [["--replace-needed", other, names[other]] for other in direct(target) if other in names]
        edits += [["--set-soname", names[name]]] if name in names else []
        edits.append(["--set-rpath", "$ORIGIN" if name in names else "$ORIGIN:$ORIGIN/../graze.libs"])
        for words in edits:  # patchelf 0.14 confuses the texts of two edits of one call
            said("patchelf", *words, target)
    return libraries, {name: path for name, path in paths.items() if name in names}


def licences(libraries):
    """Texts that stand in dist-info/licenses: Graze's, and those of each package whose code the wheel holds."""
    packages = {package_of(path) for path in libraries.values()}
    for pattern in COMPILED_IN:
        packages |= {os.path.basename(os.path.dirname(path)) for path in glob.glob(f"/usr/share/doc/{pattern}/copyright")}
    texts, common, lines = [], set(), ["# Packages of Debian whose code this wheel holds; https://snapshot.debian.org has their sources.\n"]
    for package in sorted(packages):
        with open(f"/usr/share/doc/{package}/copyright", "rb") as file:
            texts.append((f"licenses/{package}.copyright", file.read()))
        common |= set(re.findall(COMMON + r"([\w.-]*[\w])", texts[-1][1].decode("utf-8", "replace")))
        version = said("dpkg-query", "-W", "-f", "${source:Package} ${source:Version} (${Package})\n", package)
        lines.append(version.splitlines()[0] + "\n")
    own = [("GPL-3.0-or-later.txt", "LICENSES/GPL-3.0-or-later.txt"), ("three.js.txt", "src/output/page/three/LICENSE")]
    for name, path in [*own, *((f"common/{name}", COMMON + name) for name in sorted(common) if os.path.exists(COMMON + name))]:
        with open(os.path.join(ROOT, path), "rb") as file:
            texts.append((f"licenses/{name}", file.read()))
    return [*texts, ("licenses/SOURCES.txt", "".join(lines).encode())]


def main():
    if len(sys.argv) != 3:
        sys.exit("wheel.py: expected BUILD FOLDER")
    build, out = map(os.path.abspath, sys.argv[1:])
    tag = f"manylinux_{platform.libc_ver()[1].replace('.', '_')}_{platform.machine()}"
    with tempfile.TemporaryDirectory() as folder:
        libraries, copies = carry(build, folder)
        files = []
        for path in sorted([*copies.values()]):
            with open(path, "rb") as file:
                files.append(("graze.libs/" + os.path.basename(path), file.read()))
        with open(os.path.join(folder, "libgraze.so"), "rb") as file:
            library = file.read()
    name = wheel_backend.write(out, *wheel_backend.contents(library, tag, [*files, *licences(libraries)]))
    print(os.path.join(sys.argv[2], name))


if __name__ == "__main__":
    main()
