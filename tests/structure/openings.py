# SPDX-License-Identifier: GPL-3.0-or-later
"""Wording that a reader must read twice: openings without a subject, and phrases in which a bound or a relation hides.

A unit is a comment, a docstring, a message of the sources, or a sentence that begins a line of a page. Headings and
rows of tables are no sentences, so their openings do not count, but their phrases do. Code in a page does not count.
"""
import re

import sources

# A question may open with What or Which.
OPENING = re.compile(r"(?:Of|The same|(?:What|Which)\b(?![^.:;?]*\?))\b")
PHRASE = re.compile(r"\b(?:of which|so many|as many as|so often|as often as|as far as)\b")
# The most that each place may have. These numbers only fall.
ALLOWED = {"src": 9, "include": 0, "tests": 6, "proofs": 0, "README.md": 0, "Makefile": 0, ".ci": 0}
HASHED = (".py", ".sh", "Makefile", ".ci/run")
TYPES = (".c", ".h", ".cpp", ".hpp", ".js", ".md", *HASHED)
LITERAL = r'"(?:\\.|[^"\\\n])*"'
# Comments of C, those in one block of lines together, and literals side by side.
C_UNIT = re.compile(rf'/\*.*?\*/|//[^\n]*(?:\n[ \t]*//[^\n]*)*|{LITERAL}(?:\s*{LITERAL})*|\'(?:\\.|[^\'\\\n])*\'', re.S)
PYTHON_UNIT = re.compile(r'""".*?"""|(?m:^)[ \t]*#[^\n]*(?:\n[ \t]*#[^\n]*)*|(?<!\S)#[^\n]*|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'', re.S)
C_MARGIN = re.compile(r"(?:^|\n)[ \t]*(?:/\*+<?|\*(?!/)|//+<?)[ \t]*|\*/")
PYTHON_MARGIN = re.compile(r"(?:^|\n)[ \t]*#+[ \t]?")
FENCE = re.compile(r"^[ \t]*(```|~~~).*?^[ \t]*\1", re.M | re.S)
CODE = re.compile(r"`[^`\n]*`")


def without(pattern, text):
    """The text with each match of the pattern replaced by a backtick and blanks, so that lines keep their numbers."""
    return pattern.sub(lambda place: "`" + re.sub(r"[^\n]", " ", place.group()[1:]), text)


def of_c(text):
    for place in C_UNIT.finditer(text):
        unit = place.group()
        if unit.startswith("/"):
            yield place.start(), C_MARGIN.sub(" ", unit), True
        else:
            unit = re.sub(r'"\s*"', "", unit)[1:-1].replace("\\n", " ")
            yield place.start(), unit, unit.count(" ") > 1


def of_python(text):
    for place in PYTHON_UNIT.finditer(text):
        unit = place.group()
        if unit.startswith('"""'):
            yield place.start(), re.sub(r"^#\s*suite:?", "", unit[3:-3].strip()), True
        elif unit.lstrip().startswith("#"):
            yield place.start(), PYTHON_MARGIN.sub(" ", unit), True


def of_page(text):
    """Each run of lines from a sentence that begins a line up to the next one; headings and rows of tables alone."""
    start, run, opens, ended, at = 0, [], False, True, 0
    for line in without(CODE, without(FENCE, text)).split("\n"):
        bare = line.strip()
        told = re.sub(r"^(?:(?:[-*>]|\d+\.)\s+|\*\*)+", "", bare)
        apart = bare.startswith(("#", "|", ":"))
        if ended or apart or told != bare:
            yield start, " ".join(run), opens
            start, run, opens = at, [], not apart
        run.append(told)
        ended = apart or not bare or bare.rstrip("*)").endswith((".", ":", "?", "!", ";"))
        at += len(line) + 1
    yield start, " ".join(run), opens


def units(path, text):
    """Each unit as (its place, its words with one blank between two, whether its first words are an opening)."""
    read = of_page if path.endswith(".md") else of_python if path.endswith(HASHED) else of_c
    for start, unit, opens in read(text):
        yield start, " ".join(unit.split()), opens


def found(path, text):
    """(line of the unit, words) of each opening and each phrase."""
    for start, unit, opens in units(path, text):
        line = text.count("\n", 0, start) + 1
        if opens and OPENING.match(unit):
            yield line, unit[:60]
        for place in PHRASE.finditer(unit):
            yield line, unit[max(0, place.start() - 30):place.end() + 20]


def places(files):
    """For each place of ALLOWED a list of lines: file, line and words of each opening and phrase in these files."""
    by_place = {place: [] for place in ALLOWED}
    for path in files:
        place = path.split("/")[0]
        if place in ALLOWED and path.endswith(TYPES):
            by_place[place] += [f"{path}:{line}: {words}" for line, words in found(path, sources.read(path))]
    return by_place


# Texts with the lines at which they are found: openings and phrases count, what only looks like them does not.
SAMPLES = [
    ("a.c", "/* What it makes. */\nint a;\n/** The\n * same of b. */\nint b; /* which of them, whatever */\n", [1, 3]),
    ("a.h", "// Cubes, one\n// of\n// which is cut, for so many\n// turns.\nint of_which;\n", [1, 1]),
    ("a.c", 'f("of %s", "Of the two the first", " one is as many"\n  " as the other");\ng("What");\n', [1, 1]),
    ("a.js", "// Whatever comes.\nconst text = '// What is it?';\n/* Offset of the whole. */\n", []),
    ("a.py", '"""# suite: of all rooms."""\nx = "# What"  # Which of two.\n# Two lines,\n# as far as it goes.\n', [2, 3]),
    ("a.md", "# What it is\nOf two one.\nIt is one of\nwhich\n- The same.\n| Of | of which |\n`of which`\n\n```sh\n# What\n```\nWhich is it?\nWhat it is: why?\n",
     [2, 3, 5, 6, 13]),
]
