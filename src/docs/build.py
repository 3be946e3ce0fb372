#!/usr/bin/env python3
"""Builds the site: runs what its pages show, then Doxygen and Sphinx, both with warnings as errors.

In BUILD/docs: source/, the repository in links, from which Sphinx reads, so that pages link to sources by the paths they
have; source/build/pages/PAGE/, the folder in which the commands of a page ran, with the files and pictures they made; xml/,
what Doxygen says of the headers; html/, the site.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import argparse
import glob
import os
import shutil
import subprocess
import sys

import blocks

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
FIRST = "src/docs/index.html"
REDIRECT = f"""<!doctype html>
<meta charset="utf-8"><meta http-equiv="refresh" content="0; url={FIRST}">
<title>Graze</title><a href="{FIRST}">Graze</a>
"""


def environment(source):
    """Programs, libraries and module of source/build, as where they are installed."""
    build = os.path.join(source, "build")
    with open(os.path.join(build, "graze.pc"), "w", encoding="utf-8") as file:
        file.write(f"Name: graze\nDescription: as it is built\nVersion: 0\nRequires: gmp\nCflags: -I{source}/include\n"
                   f"Libs: -L{build} -lgraze\n")
    return dict(os.environ, PATH=f"{build}:{os.environ['PATH']}", PYTHONPATH=os.path.join(source, "src", "python"),
                GRAZE_LIBRARY=os.path.join(build, "libgraze.so"), GRAZE_SOURCE=source, PKG_CONFIG_PATH=build, LD_LIBRARY_PATH=build,
                PYTEST_PLUGINS="graze.pytest_plugin")  # which an installed module names


def run_page(page, source, change=lambda command: command):
    """Run the commands of a page, as `change` makes them, in a folder of its own; the number of those that did not do what
    the page says."""
    name = os.path.splitext(os.path.basename(page))[0]
    folder = os.path.join(source, "build", "pages", name)
    os.makedirs(folder)
    wrong, installed = 0, environment(source)
    with open(page, encoding="utf-8") as file:
        shown = blocks.blocks(file.read())
    for language, command, output in shown:
        if language != "sh" or blocks.changes_system(command):
            continue
        command = change(command)
        done = subprocess.run(["/bin/sh", "-ec", command], cwd=folder, env=installed, text=True, timeout=600,
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        if done.returncode if output is None else not blocks.prints(output, done.stdout):
            wrong += 1
            print(f"{page}: status {done.returncode} of\n{command}it printed\n{done.stdout}"
                  + (f"expected\n{output}" if output else ""), file=sys.stderr)
    return wrong


def doxygen(folder):
    """The headers' comments as XML. Typedefs of enums and structs are written as plain ones, which Sphinx knows once."""
    with open(os.path.join(HERE, "Doxyfile"), encoding="utf-8") as file:
        settings = file.read() + f'XML_OUTPUT="{folder}/xml"\n'
    subprocess.run(["doxygen", "-"], input=settings, text=True, cwd=ROOT, check=True)


def sphinx(folder):
    subprocess.run([sys.executable, "-m", "sphinx", "-q", "-W", "--keep-going", "-c", HERE, "-b", "html",
                    "-d", f"{folder}/doctrees", f"{folder}/source", f"{folder}/html"], check=True,
                   env=dict(os.environ, GRAZE_DOCS=folder, PYTHONDONTWRITEBYTECODE="1"))
    with open(f"{folder}/html/index.html", "w", encoding="utf-8") as file:
        file.write(REDIRECT)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--build", default="build", help="folder with the programs (build)")
    build = os.path.abspath(parser.parse_args().build)
    folder = os.path.join(build, "docs")
    source = os.path.join(folder, "source")
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(source)
    missing = blocks.link_into(source, ROOT, build)
    if missing:
        sys.exit(f"{build}: {', '.join(missing)} missing; make all makes them")
    os.symlink(sys.executable, os.path.join(source, "build", "python3"))  # with the packages that Sphinx has
    pages = sorted(glob.glob(os.path.join(HERE, "*.md")))
    wrong = sum(run_page(page, source) for page in pages)
    doxygen(folder)
    sphinx(folder)
    if wrong:
        sys.exit(f"{wrong} blocks of commands do not do what the pages show")
    print(f"{len(pages)} pages of our own; open {os.path.relpath(folder)}/html/index.html")


if __name__ == "__main__":
    main()
