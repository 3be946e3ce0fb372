#!/usr/bin/env python3
"""Messages of the source that the refusal cases have reached, and those whose expectation they quote.

A message is a string literal handed to context_fail, to a function declared with a printf format
attribute, or to one of the functions named below that pass a text on. Its conversions become
wildcards, and it is reached when the pattern occurs in what the cases printed to standard error. A
case must also quote, in a line `says`, what the message expects, so that no message loses it.
run.py calls account(); messages.py --list prints the messages found. SPDX-License-Identifier:
GPL-3.0-or-later
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]

# Functions without a format attribute, and macros, whose literal is (part of) a message.
PLAIN = ("context_limit", "table_fail")

# Functions with a format attribute that are no messages.
SILENT = ("text_format", "output_format", "few_add")

# Messages no case of the command line can reach: a part of the message, and the reason.
UNREACHED = {
    "out of memory": "an allocation fails only under fault injection",
    "no memory ": "an allocation fails only under fault injection",
    "memory ran out": "an allocation fails only under fault injection",
    "cannot be started, for want of memory or of threads; expected a smaller --jobs": "the system refuses a thread",
    "signals cannot be watched": "the system refuses a pipe",
    "as many as can be numbered": "needs 2^32 vertices",
    "limit %d: expected 0 to %d": "the command line knows the limits; tests/api reaches it",
    "expected none, binary64 or binary32": "the command line knows the roundings; tests/api reaches it",
    "an unsweep; expected a sweep to judge a mesh by": "the command line judges sweeps alone; tests/api reaches it",
    "the mesh has no inside: edges with an odd number": "the command line asks closed meshes alone; tests/api reaches it",
    "; expected a number below that": "readers check vertices of files; tests/api reaches it",
    "canceled by the caller": "the command line dies by the signal; tests/api reaches it",
    "another program has changed it": "needs a program that ignores the lock",
    "another run is writing it": "needs two runs at once; tests/shards reaches it",
    "rows already, more than there are points": "needs a table of this version; tests/shards reaches it",
    "rows are not those that were written": "needs a table of this version; tests/shards reaches it",
    "rows are of other %s": "needs a table of this version; tests/shards reaches it",
    "rows for which there are points": "needs a table of this version; tests/shards reaches it",
    "is not the file that was validated": "needs a receipt of this version; tests/shards reaches it",
    "the box along axis": "the command line makes numbers in lowest terms; tests/api reaches it",
    "cannot be waited for": "the system refuses to poll",
    "is empty; expected a file": "stands in a row of the table; collide-list-rows quotes it",
    "inside: %.*s: expected yes or no": "stands in a row of the table; collide-list-rows quotes it",
    "a motion error goes without --first, --ask overlap and inside": "stands in a row of the table; collide-error-list quotes it",
    "a rank cannot begin": "needs a machine that lacks a file which another one has",
    "MPI cannot begin": "the system refuses a pipe",
    "PNG and PDF pictures need ": "tests/draw hides the library",
    "a VTK file numbers its points": "needs 2^31 rows",
    "the crossings of a ray with the solid do not add up": "a fault of Graze itself",
    "the motion's end maps are singular": "a fault of Graze itself",
    "inside the geometry library failed": "a fault of Graze itself",
    "unexpected fault in the geometry": "a fault of Graze itself",
    "this processor does not obey the rounding mode": "needs an emulator such as valgrind",
    "a contact ends between two pieces": "a fault of Graze itself",
    "a polynomial cannot be factored": "a fault of Graze itself",
    "the edges of a facet do not close": "a fault of Graze itself",
    "the points of a hull are in one plane": "a fault of Graze itself",
    "a number that is not zero has the sign 0": "a fault of Graze itself",
    "a form of low degree is refused": "a fault of Graze itself",
    "two rules disagree on the surfaces": "a fault of Graze itself",
    "the degree of the times of flat edges": "paths of that degree are refused first",
    "the places of a crossing": "needs curves that are 2^-100000 apart",
    "the places of a point of the outline": "needs curves that are 2^-100000 apart",
    "the places of a box about a point": "needs curves that are 2^-100000 apart",
    "the places of a ray": "needs curves that are 2^-100000 apart",
    "the cells of an integral": "needs cells of 2^-100000",
    "the ends of an integral": "needs cells of 2^-100000",
    "a resultant of curves is not found": "a fault of Graze itself",
    "a point beside a curve of the outline is on its boundary": "a fault of Graze itself",
    "a curve is cut by its own equation": "a fault of Graze itself",
    "an equation of a curve has no factors": "a fault of Graze itself",
    "a curve has two equations": "a fault of Graze itself",
    "a curve has no equation": "a fault of Graze itself",
    "a hole of the outline is in no ring": "a fault of Graze itself",
    "a walk has two outer rings": "a fault of Graze itself",
    "two counts of the Euler characteristic differ": "a fault of Graze itself",
    "the area of an outline is negative": "a fault of Graze itself",
    "the boundary's pieces do not alternate about a point": "a fault of Graze itself",
    "a piece of the boundary is in no arc, or in two": "a fault of Graze itself",
    "a walk along the boundary does not close": "a fault of Graze itself",
    "a resultant is not found": "a fault of Graze itself",
    "a gap and the stacks beside its end disagree": "a fault of Graze itself",
    "a trace passes between inside and outside": "a fault of Graze itself",
    "a slide does not begin on the boundary": "a fault of Graze itself",
    "a trace has lost a contact": "a fault of Graze itself",
    "one after the other, disagree on the state": "a fault of Graze itself",
    "an exact location disagree on a state": "a fault of Graze itself",
    "and the exact path disagree on a sign": "a fault of Graze itself",
    "one after the other, are not in order of time": "a fault of Graze itself",
    "between two contacts of a trace is neither": "a fault of Graze itself",
    "between two contacts is neither": "a fault of Graze itself",
    "cannot be certified in": "a fault of Graze itself",
    "contacts are certified": "a fault of Graze itself",
    "an irreducible pullback vanishes": "a fault of Graze itself",
    "a point is on the boundary, and its cell is not": "a fault of Graze itself",
    "a curve of a sweep is not": "a fault of Graze itself",
    "parts of curves of a sweep": "a fault of Graze itself",
    "is in no row of the table of kinds": "a fault of Graze itself",
    "a common factor of curves is": "a fault of Graze itself",
    "a common factor is not found": "a fault of Graze itself",
    "of a ray beside a contact do not add up": "a fault of Graze itself",
    "the crossings of a ray through a solid do not add up": "a fault of Graze itself",
    "no arc tells if a direction at a common point is in a cone": "a fault of Graze itself",
    "two boundaries that meet have no point in common": "a fault of Graze itself",
    "a cell next to a contact is not found": "a fault of Graze itself",
    "of a boundary point misses the boundary at its time": "a fault of Graze itself",
    "a cell is not on the boundary": "a fault of Graze itself",
    "disagree on the states beside a time": "a fault of Graze itself",
    "border what is covered about the point than the": "needs a saddle of more than 60 planes around which all directions are covered",
    "a certificate is of facets as they stand in the file": "certify has no --triangulate; tests/api reaches it",
    "a certificate is of the numbers": "certify has no --round; tests/api reaches it",
    "a certificate names its files": "certify reads files; tests/api reaches it",
}

# Files whose messages only callers of the library can meet; tests/api reaches them.
LIBRARY = ("src/api/api.c", "src/api/api_kinds.c", "src/api/api_convert.c", "src/api/api_draw.c", "src/output/table/typed.c", "src/output/table/row_values.c", "src/output/table/typed_read.c",
           "src/api/api_certify.c", "src/api/api_solid.c", "src/api/api_trace.c", "src/api/api_rows.c", "src/api/api_export.c", "src/api/api_distance.c", "src/api/api_contact.c", "src/api/api_grid.c", "src/api/api_envelope.c", "src/api/api_curve.c", "src/input/read/nesting.c")

STRING = r'"(?:[^"\\]|\\.)*"'
ATTRIBUTE = re.compile(r"(\w+)\s*\([^;{}]*?\)\s*(?:\n\s*)?__attribute__\s*\(\(\s*format\s*\(\s*printf", re.S)
CONVERSION = re.compile(r"%(?:%|[-+ #0]*(?:\*|\d+)?(?:\.(?:\*|\d+))?(?:hh|h|ll|l|z|j|t)?[a-zA-Z])")


def sources():
    """(path, text without comments) of every source file."""
    for path in sorted((ROOT / "src").rglob("*")):
        if "check" in path.relative_to(ROOT).parts:  # graze-check, another program: tests/check
            continue
        if path.suffix in (".c", ".h", ".cpp", ".hpp"):
            text = path.read_text(encoding="utf-8")
            text = re.sub(STRING + r"|'(?:[^'\\]|\\.)+'|/\*.*?\*/|//[^\n]*",
                          lambda m: re.sub(r"[^\n]", " ", m[0]) if m[0][0] == "/" else m[0], text,
                          flags=re.S)
            yield path, text


def expand(text):
    """Put the printf macros of <inttypes.h> and string constants of macros between literals aside."""
    return re.sub(r"\bPRI\w+\b", '"u"', text)


def messages():
    """(file:line, message) of every message."""
    texts = [(path, expand(text)) for path, text in sources()]
    names = set(PLAIN)
    for _, text in texts:
        names.update(ATTRIBUTE.findall(text))
    names -= set(SILENT)
    call = re.compile(r"\b(" + "|".join(sorted(names)) + r")\s*\(")
    for path, text in texts:
        for match in call.finditer(text):
            literal = first_literal(text, match.end())
            if literal:
                line = text.count("\n", 0, match.start()) + 1
                yield f"{path.relative_to(ROOT)}:{line}", literal


def first_literal(text, start):
    """The first run of string literals among a call's own arguments; None if there is none."""
    depth, at = 1, start
    while at < len(text) and depth:
        run = re.compile(rf"{STRING}(?:\s*{STRING})*").match(text, at)
        if run:
            if depth == 1 or depth == 2:
                parts = re.findall(STRING, run[0])
                return "".join(p[1:-1].replace('\\"', '"').replace("\\\\", "\\") for p in parts)
            at = run.end()
            continue
        depth += {"(": 1, ")": -1}.get(text[at], 0)
        at += 1
    return None


def pattern(message):
    """A pattern of the message as it is printed."""
    parts = CONVERSION.split(message)
    kinds = [m[0] for m in CONVERSION.finditer(message)]
    out = re.escape(parts[0])
    for kind, part in zip(kinds, parts[1:]):
        out += ("%" if kind == "%%" else "[^\n]*?") + re.escape(part)
    return out


def is_printed(message, lines):
    """Is it part of a line? A message is of one line, and only lines that have its longest text are looked at closely."""
    longest, whole = max(CONVERSION.split(message), key=len), re.compile(pattern(message))
    return any(longest in line and whole.search(line) for line in lines)


def says_something(message):
    """A format that is only places and values, such as `%s:%zu`, is part of another message."""
    return len(re.sub(r"[^a-z]", "", CONVERSION.sub("", message))) >= 4


def account(printed, quoted):
    """(number reached, [(where, message) of those that are not], those whose expectation is not among the lines `quoted`)."""
    reached, silent, unquoted, lines = 0, [], [], set(printed.split("\n"))
    for where, message in messages():
        file = where.split(":")[0]
        if not says_something(message) or file in LIBRARY:
            continue
        if any(part in message for part in UNREACHED):
            continue
        if not is_printed(message, lines):
            silent.append((where, message))
            continue
        reached += 1
        expects = message.find("expected")
        if expects >= 0 and not is_printed(message[expects:], quoted):
            unquoted.append((where, message))
    return reached, silent, unquoted


if __name__ == "__main__":
    if sys.argv[1:] != ["--list"]:
        sys.exit("usage: messages.py --list")
    for found in messages():
        print(*found)
