"""Builds a wheel that holds the module and libgraze.so, for pip, with Python's own library alone (PEP 517).

The shared library is $GRAZE_LIBRARY, or build/libgraze.so of the checkout, which `make` builds first where it is
missing, on all cores, and says how far it is. The wheel is for this machine: the library needs those it was linked with, such as FLINT and MPFR.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import base64
import hashlib
import os
import re
import subprocess
import sysconfig
import zipfile

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.normpath(os.path.join(HERE, "..", ".."))


class UnsupportedOperation(Exception):
    """The exception that PEP 517 requires of a backend that makes no source distribution."""


def _read(*path):
    with open(os.path.join(*path), "rb") as file:
        return file.read()


def _version():
    return re.search(rb'^VERSION = "(.*)"$', _read(HERE, "graze", "_library.py"), re.M)[1].decode()


def _library():
    named = os.environ.get("GRAZE_LIBRARY")
    path = named or os.path.join(ROOT, "build", "libgraze.so")
    if not named and not os.path.exists(path):
        _make()
    return _read(path)


def _make():
    """Make the library on all cores. pip shows nothing of a build but with -v: a terminal is written to besides."""
    try:
        terminal = open("/dev/tty", "w", encoding="utf-8")
    except OSError:
        terminal = open(os.devnull, "w", encoding="utf-8")
    words = ["make", "-C", ROOT, f"-j{len(os.sched_getaffinity(0))}", "build/libgraze.so"]
    environment = {name: value for name, value in os.environ.items() if name not in ("MAKEFLAGS", "MFLAGS", "MAKELEVEL")}
    with terminal, subprocess.Popen(words, stdout=subprocess.PIPE, text=True, env=environment) as making:
        terminal.write("\n  graze: compiling its library, a few minutes on two cores\n")
        for line in making.stdout:
            print(line, end="", flush=True)
            terminal.write("  graze:" + line)
            terminal.flush()
    if making.returncode:
        raise SystemExit(f"graze: make ended with status {making.returncode}")


def contents(library, platform, more=()):
    """Names in a wheel of this library and their bytes, and the wheel's name; `more` are pairs of
    a name, below graze.libs/ or else in dist-info, and bytes."""
    info = f"graze-{_version()}.dist-info"
    files = {f"graze/{name}": _read(HERE, "graze", name)
             for name in sorted(os.listdir(os.path.join(HERE, "graze"))) if name.endswith((".py", ".txt", ".typed"))}
    files["graze/libgraze.so"] = library
    files.update((name if name.startswith("graze.libs/") else f"{info}/{name}", data) for name, data in more)
    # `make install` writes these files too.
    files[f"{info}/METADATA"] = _read(ROOT, "src", "install", "METADATA.in").replace(b"@VERSION@", _version().encode())
    files[f"{info}/entry_points.txt"] = _read(ROOT, "src", "install", "entry_points.txt")
    files[f"{info}/WHEEL"] = ("Wheel-Version: 1.0\nGenerator: graze\nRoot-Is-Purelib: false\n"
                              f"Tag: py3-none-{platform}\n").encode()
    record = "".join(
        f"{name},sha256={base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b'=').decode()},{len(data)}\n"
        for name, data in files.items())
    files[f"{info}/RECORD"] = (record + f"{info}/RECORD,,\n").encode()
    return files, f"graze-{_version()}-py3-none-{platform}.whl"


def write(wheel_directory, files, name):
    """Write a wheel, without dates; returns its name."""
    with zipfile.ZipFile(os.path.join(wheel_directory, name), "w", zipfile.ZIP_DEFLATED) as wheel:
        for path, data in files.items():
            entry = zipfile.ZipInfo(path)
            entry.compress_type, entry.external_attr = zipfile.ZIP_DEFLATED, 0o644 << 16
            wheel.writestr(entry, data)
    return name


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """Write the wheel of this machine into a folder; returns its name."""
    return write(wheel_directory, *contents(_library(), re.sub(r"[-.]", "_", sysconfig.get_platform())))


def build_sdist(sdist_directory, config_settings=None):
    """None is made: the sources of the library are those of the checkout."""
    raise UnsupportedOperation("no source distribution; expected a checkout of Graze")
