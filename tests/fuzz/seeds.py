"""The seeds of the fuzz targets: at most PLAIN files in corpus/TARGET, all others in the archive corpus/TARGET.tar.xz.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import io
import os
import re
import tarfile

CORPUS = "tests/fuzz/corpus"
PLAIN = 30  # files of a target; more of them are a burden to all who list the tree


def is_own(name):
    """A name that somebody gave: the seed stays whatever it reaches."""
    return not re.fullmatch("[0-9a-f]{12}", name)


def archive(target):
    return f"{CORPUS}/{target}.tar.xz"


def plain(target):
    """Names of the seeds that are files."""
    folder = f"{CORPUS}/{target}"
    return sorted(os.listdir(folder)) if os.path.isdir(folder) else []


def archived(target):
    """Name -> bytes of the others."""
    if not os.path.exists(archive(target)):
        return {}
    with tarfile.open(archive(target)) as file:
        return {member.name: file.extractfile(member).read() for member in file}


def load(target):
    """Name -> bytes of all seeds."""
    seeds = archived(target)
    for name in plain(target):
        with open(f"{CORPUS}/{target}/{name}", "rb") as file:
            seeds[name] = file.read()
    return seeds


def lay_out(target, folder):
    """Write all seeds into a folder that is made; their paths."""
    os.makedirs(folder)
    paths = []
    for name, content in sorted(load(target).items()):
        paths.append(os.path.join(folder, name))
        with open(paths[-1], "wb") as file:
            file.write(content)
    return paths


def store(target, seeds):
    """Make the seeds of a target anew: name -> bytes, the first ones as files. Equal seeds give equal archives."""
    folder, names = f"{CORPUS}/{target}", list(seeds)
    os.makedirs(folder, exist_ok=True)
    for name in set(plain(target)) - set(names[:PLAIN]):
        os.remove(f"{folder}/{name}")
    for name in names[:PLAIN]:
        with open(f"{folder}/{name}", "wb") as file:
            file.write(seeds[name])
    if names[PLAIN:]:
        with tarfile.open(archive(target), "w:xz", format=tarfile.USTAR_FORMAT, preset=9) as file:
            for name in sorted(names[PLAIN:]):
                member = tarfile.TarInfo(name)
                member.size = len(seeds[name])
                file.addfile(member, io.BytesIO(seeds[name]))
    elif os.path.exists(archive(target)):
        os.remove(archive(target))
