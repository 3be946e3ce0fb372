"""Settings of the site that `make docs` builds, for Sphinx.

The source folder is a copy of the repository in links (src/docs/build.py), so that pages link to one another and to the
sources by the same paths as in the repository. Nothing is loaded from a network.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import re
import sys

HERE = os.environ["GRAZE_DOCS"]  # the folder with source/ and xml/
sys.path.insert(0, os.path.join(HERE, "source", "src", "python"))
with open(os.path.join(HERE, "source", "include", "graze", "version.h"), encoding="utf-8") as header:
    release = re.search(r'GRAZE_VERSION "(.*)"', header.read())[1]

project = "Graze"
author = "the Graze maintainers"
extensions = ["myst_parser", "breathe", "sphinx.ext.autodoc", "sphinx.ext.napoleon", "sphinx_copybutton"]
root_doc = "src/docs/index"
include_patterns = ["src/docs/*.md", "proofs/*.md", "proofs/coq/README.md", "src/README.md", "src/program/cli/*.md",
                    "cases/README.md", "cases/*/README.md", "tests/README.md", "tests/bombs/README.md",
                    "tests/fuzz/README.md", "src/output/page/README.md", "README.md", "CONTRIBUTING.md", "CHANGELOG.md", "SECURITY.md", "RELEASE.md"]
myst_heading_anchors = 4
napoleon_use_ivar = True
default_role = "literal"  # docstrings have one backquote, as Markdown has

breathe_projects = {"graze": os.path.join(HERE, "xml")}
breathe_default_project = "graze"
breathe_domain_by_extension = {"h": "c"}
autodoc_member_order = "bysource"

html_theme = "furo"
html_title = f"Graze {release}"
html_show_sourcelink = False
html_copy_source = False
html_theme_options = {"navigation_with_keys": True}
html_static_path = ["site.css"]  # beside this file
html_css_files = ["site.css"]


LINK = re.compile(r"(?<!!)\[([^\]]*)\]\(([^)#:]+)\)")


def plain(app, what, name, obj, options, lines):
    """Docstrings are plain text: a bar is a bar."""
    lines[:] = [line.replace("|", r"\|") for line in lines]


def open_folders(app, docname, source):
    """A link to a folder leads to its README.md; to one without, it is no link here."""
    def target(link):
        path = os.path.join(app.srcdir, os.path.dirname(docname), link[2])
        if not os.path.isdir(path):
            return link[0]
        return f"[{link[1]}]({link[2]}/README.md)" if os.path.exists(f"{path}/README.md") else link[1]
    source[0] = LINK.sub(target, source[0])


def setup(app):
    app.connect("autodoc-process-docstring", plain, priority=100)
    app.connect("source-read", open_folders)
