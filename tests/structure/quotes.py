# SPDX-License-Identifier: GPL-3.0-or-later
"""Names that pages and comments quote: identifiers, options, commands, targets of make."""
import re
import subprocess

import paths
import sources

# In a span of a page, and in a comment: a word with an underscore, or one that is called, but no file's name (paths.py) and no
# mathematics as x_i and N_ij.
WORD = re.compile(r"(?<![\w.*<-])([A-Za-z]\w+_\w\w+|[A-Za-z]\w+_(?=\*)|[a-z]\w+\(\))(?![\w]|\.(?:c|h|cpp|hpp|py)\b)")
SPAN = re.compile(r"`([^`\n]+)`")
OPTION = re.compile(r"(?<![\w-])--[a-z][a-z-]*[a-z]\b")
COMMAND = re.compile(r"`graze ([a-z]+)")
TARGET = re.compile(r"(?:`|^)make ([a-z][a-z-]*)", re.M)
MEMBER = re.compile(r"`graze\.(?!pc\b)([A-Za-z]\w*)")
LITERAL = re.compile(r'"_?(\w+)"')
# Names of YAJL, of CMake, of GoogleTest and of other projects about swept volumes.
FOREIGN = {"yajl_gen_alloc", "find_package", "gtest_main", "swept_volume", "swept_volume_mesh", "swept_volume_sdf"}
# Options of pkg-config, GNU parallel, Slurm, esbuild, and of pytest with the plugin of src/python.
OF_OTHERS = {"--cflags", "--libs", "--sshloginfile", "--workdir", "--array", "--cpus-per-task", "--requeue",
             "--outfile", "--minify", "--legal-comments", "--global-name", "--bundle", "--junit-xml",
             "--graze-n", "--graze-seed"}
# A part of a name stands for what it may be, as in test_NAME.
PLACEHOLDER = re.compile(r"(?:^|_)[A-Z]{3,}(?:_|$)")
# Here options are those of the scripts of tests too.
OF_SCRIPTS = ("tests/", "cases/", "proofs/coq/", "CONTRIBUTING.md", "Makefile")
SOURCES = (".c", ".h", ".cpp", ".hpp")
CODE = (*SOURCES, ".js", ".py", ".sh", ".v", ".json", "Makefile", ".ci/run")


def without_comments(path, text):
    if path.endswith((*SOURCES, ".js")):
        return paths.COMMENT.sub(" ", text)
    return paths.HASHED.sub(" ", text) if path.endswith((".py", ".sh", "Makefile")) else text


def helps(build):
    """The text of every --help."""
    def asked(*command):
        return subprocess.run(command, stdout=subprocess.PIPE, check=False, text=True).stdout

    overview = asked(f"{build}/graze", "--help")
    commands = re.findall(r"^  graze ([a-z]+)", overview, re.M)
    return {*commands, "help"}, overview + asked(f"{build}/graze-check", "--help") + "".join(asked(f"{build}/graze", name, "--help") for name in commands)


class Known:
    """All that may be quoted."""

    def __init__(self, build, files):
        texts = {path: without_comments(path, sources.read(path)) for path in files
                 if path.endswith(CODE)}
        self.words = {word for text in texts.values() for word in re.findall(r"\w+", text)} | FOREIGN
        self.literals = {word for path, text in texts.items() if path.startswith("src/output/") for word in LITERAL.findall(text)}
        self.commands, text = helps(build)
        self.options = set(OPTION.findall(text)) | OF_OTHERS
        self.of_scripts = {option for path, text in texts.items() if path.endswith((".py", ".sh", "Makefile"))
                           for option in OPTION.findall(text)}
        self.targets = set(re.findall(r"^([a-z-]+):", texts["Makefile"], re.M))
        self.members = {word for path, text in texts.items() if path.startswith("src/python/graze/") for word in re.findall(r"\w+", text)}

    def is_word(self, name):
        """A name, the beginning of names, or a key that a writer puts together, as topo_order."""
        if name.endswith("_"):
            return any(word.startswith(name) for word in self.words)
        if PLACEHOLDER.search(name) and not name.isupper():
            return True
        return name.removesuffix("()") in self.words or name.partition("_")[2] in self.literals


def quoted(path):
    """(kind, name) of each name that a file quotes."""
    text = sources.read(path) if path.endswith(".md") else paths.prose(path)
    spans = "\n".join(SPAN.findall(paths.FENCE.sub("", text))) if path.endswith(".md") else text
    found = [("word", name) for name in WORD.findall(spans)] + [("option", name) for name in OPTION.findall(text)]
    for kind, pattern in (("command", COMMAND), ("target", TARGET), ("member", MEMBER)):
        found += [(kind, name) for name in pattern.findall(text)]
    return set(found)


def missing(build):
    """(file, name quoted in it) for each name that does not exist; and the number of names looked at."""
    files = paths.tracked()
    known, wrong, seen = Known(build, files), [], 0
    for path in files:
        is_page = path.endswith(".md") and path != "CHANGELOG.md"
        if not is_page and not path.endswith(SOURCES):
            continue
        options = known.options | (known.of_scripts if path.startswith(OF_SCRIPTS) else set())
        sets = {"option": options, "command": known.commands, "target": known.targets, "member": known.members}
        names = quoted(path)
        seen += len(names)
        wrong += [(path, name) for kind, name in sorted(names)
                  if not (known.is_word(name) if kind == "word" else name in sets[kind])]
    return wrong, seen
