# SPDX-License-Identifier: GPL-3.0-or-later
"""The sources as text: what a file includes, which functions it defines at file scope, which ones a header declares."""
import functools
import glob
import os
import re

COMMENT_OR_LITERAL = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'', re.S)
DIRECTIVE = re.compile(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", re.M)
ATTRIBUTE = re.compile(r"__attribute__\s*\(\((?:[^()]|\([^()]*\))*\)\)")
# A function whose type has a name, `soup_reader read_off`. A variable looks the same; it does no harm.
FUNCTION_OF_A_TYPE = re.compile(r"[a-z]\w*\s+(\w+)")
# Words before a brace that opens no function: functions inside it are still at file scope.
TRANSPARENT = re.compile(r'(?:extern\s*L|namespace(?:\s+[\w:]+)?)\s*$')

def sources():
    """All C and C++ files of src/ and the public headers."""
    found = []
    for pattern in ("src/**/*.[ch]", "src/**/*.[ch]pp", "include/**/*.h"):
        found += glob.glob(pattern, recursive=True)
    return sorted(found)

def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()

def room_of(path):
    """The folder that holds a source, below its wing; `api` for the public headers."""
    parts = path.split("/")
    return "api" if parts[0] != "src" else parts[2] if len(parts) > 3 else parts[1]

def wing_of(path):
    """The folder below src/; `api` for the public headers."""
    return path.split("/")[1] if path.startswith("src/") else "api"

def unit_of(path):
    """A source and its own header are one unit."""
    return os.path.splitext(path)[0]

def is_public(path):
    return path.startswith("include/")

@functools.cache  # several checks follow the includes of every file
def included(path, text):
    """The files of the project that a file includes, each as (the name as written, its path or None)."""
    found = []
    for name in re.findall(r'^\s*#\s*include\s+(?:"|<(?=graze))([^">]+)[">]', text, re.M):
        places = (f"src/{name}", f"include/{name}", f"{os.path.dirname(path)}/{name}")
        found.append((name, next((place for place in places if os.path.exists(place)), None)))
    return found

def bare(text):
    """The text without comments, preprocessor lines and attributes; each literal is an L."""
    text = COMMENT_OR_LITERAL.sub(lambda m: " " if m.group().startswith("/") else "L", text)
    return ATTRIBUTE.sub(" ", DIRECTIVE.sub(" ", text))

def chunks(text):
    """The declarations at file scope, each as (text, what ends it: `{` or `;`)."""
    depth = start = 0
    opened = []   # of each brace, whether it is transparent
    for place in re.finditer(r"[{};]", text):
        mark = place.group()
        if mark == "{":
            chunk = text[start:place.start()]
            transparent = depth == 0 and TRANSPARENT.search(chunk) is not None
            if depth == 0 and not transparent:
                yield chunk, mark
            opened.append(transparent)
            depth += not transparent
        elif mark == "}":
            depth -= not opened.pop()
        elif depth == 0:
            yield text[start:place.start()], mark
        if depth == 0:
            start = place.end()

def function_name(chunk):
    """The function that a declaration declares or defines, or None."""
    if "=" in re.sub(r"operator\s*\S+", "", chunk.split("(")[0]) or "typedef" in chunk:
        return None
    # A macro in front, such as GRAZE_API, has no parentheses of its own.
    head = re.search(r"([\w:~]+)\s*\(", chunk)
    if not head or head.group(1).isupper() or head.group(1) in ("if", "for", "while", "switch", "_Static_assert", "static_assert"):
        return None
    before = chunk[:head.start()].strip()
    # A name with :: is a member's, whose class is its scope.
    return head.group(1) if before and "::" not in head.group(1) else None

def defined(text):
    """Names of the functions that a file defines at file scope."""
    return {name for chunk, end in chunks(bare(text)) if end == "{"
            for name in [function_name(chunk)] if name}

def declared(text):
    """Names of the functions that a header declares, and of those it defines."""
    found = set()
    for chunk, end in chunks(bare(text)):
        name = function_name(chunk)
        of_type = FUNCTION_OF_A_TYPE.fullmatch(chunk.strip()) if end == ";" else None
        found |= {name} if name else {of_type.group(1)} if of_type else set()
    return found

def types(text):
    """Names of the types that a header defines or declares by a typedef; clang-format lays out each in one way."""
    plain = COMMENT_OR_LITERAL.sub(" ", text)
    found = set(re.findall(r"^\} (\w+);", plain, re.M))
    found |= set(re.findall(r"^typedef\b[^;{(]*\b(\w+)(?:\[\w*\])?;", plain, re.M))
    found |= set(re.findall(r"^typedef\b.*\} (\w+);", plain, re.M))
    return found | set(re.findall(r"^typedef\b[^;{(]*(?:\(\*|\b)(\w+)\)?\(", plain, re.M))
