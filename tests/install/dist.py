#!/usr/bin/env python3
"""The files of `make dist`: what they hold, that the sources are the same bytes twice, and that each works in a new minimal system.

SPDX-License-Identifier: GPL-3.0-or-later

The dataset is one of two scenes (SCENES). Then, as root and with debootstrap: the wheel in a virtual environment of a bare Debian
without compiler and FLINT, where it must give the rows of README.md's first example; the package there; and the steps of
Containerfile with the archive of the sources in place of the folder. It takes ten minutes, so it is one of the long tests.
"""
import base64
import csv
import hashlib
import io
import json
import os
import re
import shlex
import shutil
import subprocess
import tarfile
import tempfile
import zipfile

from chroot import release
from programs import ROOT, check, checks, options, output, read, run, same

SCENES = "igl-2562 wedge-straight"
# README's cube, motion and points, by the module: word and pmc of each row.
FIRST = """
import csv, graze, sys
scene = graze.Scene(sys.argv[1], sys.argv[2])
for row in csv.DictReader(open(sys.argv[3])):
    trace = scene.trace([row["x"], row["y"], row["z"]])
    print(trace.word, trace.verdict.pmc.name.lower())
"""
CUBE = ("OFF\n8 6 0\n0 0 0\n2 0 0\n2 2 0\n0 2 0\n0 0 2\n2 0 2\n2 2 2\n0 2 2\n4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n")
MOVE = '{"dimension": 3, "pieces": [{"t": [0, 1], "transform": {"translate": ["8*t", 0, 0]}}]}'


def digest(*path):
    with open(os.path.join(*path), "rb") as file:
        return hashlib.sha256(file.read()).hexdigest()


def made(build):
    """name: path of the files of `make dist`; its sums hold."""
    folder = os.path.join(ROOT, build, "dist")
    output(["make", "-s", f"B={build}", "dist", f"SCENES={SCENES}"])
    sums = dict(reversed(line.split("  ")) for line in open(os.path.join(folder, "SHA256SUMS"), encoding="ascii").read().splitlines())
    same(sums, {name: digest(folder, name) for name in os.listdir(folder) if name != "SHA256SUMS"}, "SHA256SUMS")
    same(sorted(os.path.splitext(name)[1] for name in sums), [".deb", ".gz", ".tar", ".whl"], "files")
    return {os.path.splitext(name)[1]: os.path.join(folder, name) for name in sums}


def sources(files, folder):
    """All files of the commit, and the same bytes out of another clone."""
    with tarfile.open(files[".gz"]) as archive:
        inside = {name.split("/", 1)[1] for name in archive.getnames() if "/" in name and archive.getmember(name).isfile()}
    listed = set(output(["git", "ls-tree", "-r", "--name-only", "HEAD"]).splitlines())
    same(inside, listed, "files of the sources")
    clone, prefix = os.path.join(folder, "clone"), os.path.basename(files[".gz"]).removesuffix(".tar.gz")
    output(["git", "clone", "--quiet", "--no-hardlinks", ROOT, clone])
    output(["sh", "-c", f"umask 077; git archive --format=tar --prefix={prefix}/ {output(['git', 'rev-parse', 'HEAD']).strip()} | gzip -9n >../again.gz"], clone)
    same(digest(folder, "again.gz"), digest(files[".gz"]), "the same bytes of the sources")


def dataset(files, folder):
    with tarfile.open(files[".tar"]) as archive:
        check(all((one.uid, one.mtime, one.mode & 0o022) == (0, 0, 0) for one in archive), "owner, date and mode in the dataset's archive")
        name = archive.getnames()[0]
    output(["tar", "-C", folder, "-xf", files[".tar"]])
    output(["sha256sum", "-c", "--quiet", "SHA256SUMS"], os.path.join(folder, name))
    os.rename(os.path.join(folder, name), os.path.join(folder, "dataset"))
    words = re.search(r"^tar (--sort(?:.*\\\n)*.*)", read("src", "install", "dist.sh"), re.M)[1]
    output(["sh", "-ec", f"umask 077; touch dataset/*; chmod -R g-rx dataset; build=. dist=.; version={name.rsplit('-', 1)[1]}; tar {words}"], folder)
    same(digest(folder, os.path.basename(files[".tar"])), digest(files[".tar"]), "the same bytes of the dataset's archive")


def wheel(files):
    """Its record holds, what it asks for is inside or the system's, and each library that it carries has a licence."""
    with zipfile.ZipFile(files[".whl"]) as archive:
        names, parts = archive.namelist(), {name: archive.read(name) for name in archive.namelist()}
    record = next(name for name in names if name.endswith("/RECORD"))
    for name, hashed, size in csv.reader(io.StringIO(parts[record].decode())):
        wanted = "sha256=" + base64.urlsafe_b64encode(hashlib.sha256(parts[name]).digest()).rstrip(b"=").decode()
        check(name == record or (hashed, size) == (wanted, str(len(parts[name]))), name)
    carried = [name for name in names if name.startswith("graze.libs/")]
    check({re.match(r"graze.libs/lib(\w+)-", name)[1] for name in carried} >= {"flint", "gmp", "mpfr", "yajl", "md"}, carried)
    with tempfile.TemporaryDirectory() as folder:
        for name in [*carried, "graze/libgraze.so"]:
            path = os.path.join(folder, "library")
            with open(path, "wb") as file:
                file.write(parts[name])
            asked = re.findall(r"NEEDED +(\S+)", output(["objdump", "-p", path]))
            own = {os.path.basename(one) for one in carried}
            left = [one for one in asked if one not in own and not re.match(r"(ld-linux.*|lib(c|m|stdc\+\+|gcc_s))\.so", one)]
            check(not left, f"{name} asks for {left}")
            check("$ORIGIN" in output(["objdump", "-p", path]), f"{name}: where it looks")
    texts = [name for name in names if "/licenses/" in name]
    check(len([name for name in texts if name.endswith(".copyright")]) >= len(carried) + 2, f"licences {texts}")
    again = os.path.join(os.path.dirname(files[".whl"]), os.pardir, "again")
    shutil.rmtree(again, ignore_errors=True)
    os.mkdir(again)
    output(["python3", "src/install/wheel.py", os.path.dirname(os.path.dirname(files[".whl"])), again])
    same(digest(again, os.path.basename(files[".whl"])), digest(files[".whl"]), "the same bytes of the wheel")
    shutil.rmtree(again)


def first_rows():
    """(word, pmc) of README's first table, and its points."""
    table = re.search(r"^x,y,z,pmc,class.*\n((?:.*,.*\n)+)", read("README.md"), re.M)[1]
    rows = [line.split(",") for line in table.splitlines()]
    return [f"{row[9]} {row[3]}" for row in rows], "x,y,z\n" + "".join(",".join(row[:3]) + "\n" for row in rows)


def bare_wheel(inside, folder, path):
    """The wheel in a virtual environment, without a compiler or FLINT: the rows of README's first example."""
    output([*inside, "apt-get", "install", "-y", "--no-install-recommends", "python3-venv"], DEBIAN_FRONTEND="noninteractive")
    for program in ("g++", "gcc", "make"):
        check(run([*inside, "sh", "-c", f"command -v {program}"])[2] != 0, f"{program} is there")
    check("libflint" not in output([*inside, "dpkg-query", "-f", "${Package}\n", "-W"]), "libflint is there")
    home = os.path.join(folder, "home")
    words, points = first_rows()
    for name, text in (("cube.off", CUBE), ("move.json", MOVE), ("points.csv", points), ("first.py", FIRST)):
        with open(os.path.join(home, name), "w", encoding="utf-8") as file:
            file.write(text)
    shutil.copy(path, home)
    output([*inside, "python3", "-m", "venv", "/home/venv"])
    output([*inside, "/home/venv/bin/pip", "install", "--no-index", f"/home/{os.path.basename(path)}"])
    got = output([*inside, "/home/venv/bin/python", "/home/first.py", "/home/cube.off", "/home/move.json", "/home/points.csv"]).splitlines()
    same(got, words, "README's rows by the wheel")
    linked = dict(re.findall(r"(\S+) => (\S+)", output([*inside, "sh", "-c", "ldd /home/venv/lib/python3*/site-packages/graze/libgraze.so"])))
    carried = {name for name in linked if re.match(r"lib(flint|gmp|mpfr|yajl|md)-", name)}
    check(len(carried) == 5 and all(linked[name].startswith("/home/venv/") for name in carried), "libraries of the wheel", linked)


def container_steps():
    """Instructions of Containerfile, in order."""
    text = re.sub(r"^#.*\n", "", read("Containerfile"), flags=re.M).replace("\\\n", " ")
    return [line.split(" ", 1) for line in text.splitlines() if line.strip()]


def container(inside, folder, archive):
    """Containerfile's steps in a bare system, the sources out of their archive."""
    place, arguments = "/", {}
    for instruction, value in container_steps():
        print(instruction, value, flush=True)
        if instruction == "ARG":
            arguments.update([value.split("=", 1)])
        elif instruction == "COPY":
            target = folder + value.split()[1]
            os.makedirs(target)
            output(["tar", "-C", target, "--strip-components=1", "-xzf", archive])
        elif instruction == "WORKDIR":
            place = value
            os.makedirs(folder + value, exist_ok=True)
        elif instruction == "RUN":
            words = " ".join(f"{name}={shlex.quote(text)}" for name, text in arguments.items())
            done = subprocess.run([*inside, "sh", "-ec", f"cd {place}; {words}; {value}"], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT, text=True, timeout=7200, check=False)
            if not check(done.returncode == 0, f"RUN {value}: {done.stdout[-3000:]}"):
                return
        elif instruction in ("ENTRYPOINT", "CMD"):
            arguments[instruction] = json.loads(value)
        else:
            same((instruction, value), ("FROM", "debian:12"), "Containerfile begins")
    entry = arguments["ENTRYPOINT"]
    check("graze classify SOLID MOTION POINTS" in output([*inside, *entry, *arguments["CMD"]]), "what the container says by itself")
    got = output([*inside, *entry, "classify", *(f"/src/cases/bracket/{name}" for name in ("solid.off", "motion.json", "points.csv"))])
    same([line for line in got.splitlines() if not line.startswith("#")], read("cases", "bracket", "expected.csv").splitlines(), "rows of the container")


def bare(args, name, step, *more):
    """A step in a new minimal system, which is taken away again."""
    folder = tempfile.mkdtemp()
    try:
        output(["debootstrap", "--variant=minbase", name, folder, args.mirror])
        step(["chroot", folder], folder, *more)
    finally:
        run(["rm", "-rf", "--one-file-system", folder])


def main():
    args = options(__doc__, ("--mirror", {"default": "http://deb.debian.org/debian"}), ("--only", {"default": "", "help": "files, wheel or container"}))
    build = os.path.relpath(os.path.dirname(args.graze), ROOT)
    files = made(build)
    with tempfile.TemporaryDirectory() as folder:
        if args.only in ("", "files"):
            sources(files, folder)
            dataset(files, folder)
            wheel(files)
    if os.geteuid() != 0 or shutil.which("debootstrap") is None:
        checks.skip("chroot", "only root can make one, with debootstrap")
        checks.finish()
    if args.only in ("", "wheel"):
        bare(args, release(), bare_wheel, files[".whl"])
    if args.only in ("", "container"):
        bare(args, "bookworm", container, files[".gz"])
    checks.finish()


if __name__ == "__main__":
    main()
