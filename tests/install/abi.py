#!/usr/bin/env python3
"""# suite: the binary interface against the recorded one in tests/install/abi.txt.

SPDX-License-Identifier: GPL-3.0-or-later

Recorded are every exported function with its prototype, every value of an enum and every flag, and size and offsets of
every struct on machines with 64-bit pointers; what the module for Python mirrors is compared with it (mirrors.py). A
change on purpose is recorded by `python3 tests/install/abi.py --record`; its commit says what users of the library must
do. The order of arguments is checked here too (graze.h, rule 2).
"""
import glob
import os
import re
import struct
import tempfile

from mirrors import check_mirrors
from programs import ROOT, check, checks, options, output, read, same

RECORD = os.path.join("tests", "install", "abi.txt")
COMMAND = "python3 tests/install/abi.py --record"
# Types whose address is an output before the context and a handle behind it.
OUTPUT = re.compile(r"(?:graze_\w+ \*+|double \*|int \*|unsigned char \*|char \*\*|size_t \*|mpq_t \*?|mpz_t )\w+$")
OPTIONS = ("options", "flags", "form", "format")


def headers():
    return "".join(read(*path.split(os.sep)) for path in sorted(glob.glob("include/graze/*.h", root_dir=ROOT)))


def declarations(text):
    """The public headers without comments, each declaration on one line."""
    return re.sub(r"\s+", " ", re.sub(r"/\*.*?\*/", " ", re.sub(r"^#.*?[^\\]$", "", text, flags=re.M | re.S), flags=re.S))


def prototypes(text):
    """{name: prototype} of the functions."""
    found = re.findall(r"GRAZE_API ((?:GRAZE_CHECKED )?[^;{]*?\b(graze_\w+)\([^;{]*\));", text)
    return {name: prototype for prototype, name in found}


def structs(text):
    """{name: members}"""
    found = {}
    for body, name in re.findall(r"typedef struct \w+ \{([^}]*)\} (graze_\w+);", text):
        members = []
        for line in body.split(";"):
            members += [re.search(r"(\w+)(?:\[\w+\])?\s*$", part)[1] for part in line.split(",") if part.strip()]
        found[name] = members
    return found


def values(text):
    """Names of the values of enums, and of flags and other numbers that are defined."""
    return (re.findall(r"\b(GRAZE_[A-Z0-9_]+) =", declarations(text)) +
            re.findall(r"^#define (GRAZE_(?!VERSION)[A-Z0-9_]+) \(?-?\d", text, re.M))


# Structures of gmp.h that the functions' values are made of.
GMP = {"__mpz_struct": ["_mp_alloc", "_mp_size", "_mp_d"], "__mpq_struct": ["_mp_num", "_mp_den"]}


def layout(text, folder):
    """Lines with every value of an enum and every size and offset, from a compiled program."""
    lines = [f'printf("value %s %d\\n", "{name}", (int){name});' for name in values(text)]
    for name, members in {**structs(declarations(text)), **GMP}.items():
        lines.append(f'printf("struct {name} %zu\\n", sizeof({name}));')
        lines += [f'printf("member {name}.{member} %zu %zu\\n", offsetof({name}, {member}), sizeof((({name} *)0)->{member}));'
                  for member in members]
    source, program = os.path.join(folder, "layout.c"), os.path.join(folder, "layout")
    with open(source, "w", encoding="utf-8") as file:
        file.write("#include <graze.h>\n#include <stdio.h>\nint main(void) {\n" + "\n".join(lines) + "\nreturn 0;\n}\n")
    output(["cc", "-std=c11", "-Iinclude", source, "-o", program])
    return output([program]).splitlines()


def exported(library):
    return {line.split()[2] for line in output(["nm", "-D", "--defined-only", library]).splitlines() if len(line.split()) == 3}


def check_order(name, prototype):
    """Outputs, context, handle, inputs, options."""
    arguments = [word.strip() for word in re.search(r"\((.*)\)$", prototype)[1].split(",")]
    context = next((k for k, a in enumerate(arguments) if a == "graze_context *context"), None)
    if context is None:
        first = next((k for k, a in enumerate(arguments) if re.match(r"const graze_\w+ \*", a)), len(arguments))
        outputs, rest = arguments[:first], arguments[first + 1:]
    else:
        outputs, rest = arguments[:context], arguments[context + 1:]
        handles = [k for k, a in enumerate(rest) if re.match(r"const graze_(?!options|\w+_options|joint)\w+ \*", a)]
        check(not handles or handles[0] == 0, f"{name}: the handle stands behind an input")
    if name.startswith("graze_context_") or name.endswith("_destroy"):
        return
    check(all(OUTPUT.match(a) for a in outputs) or arguments == outputs, f"{name}: an input stands before the outputs end: {outputs}")
    check(not any(OUTPUT.match(a) and not a.startswith(("graze_rationals", "const")) for a in rest), f"{name}: an output stands behind")
    named = [re.search(r"(\w+)$", a)[1] for a in rest]
    options = [k for k, word in enumerate(named) if word in OPTIONS]
    check(not options or named[options[0] + 1:] in ([], ["rest"]), f"{name}: an input stands behind the options: {named}")


def main():
    args = options(__doc__, ("--record", {"action": "store_true", "help": f"write {RECORD}"}))
    text = declarations(headers())
    functions = prototypes(text)
    check(len(functions) > 80 and len(structs(text)) > 12, "functions and structs are found")
    for name, prototype in functions.items():
        check_order(name, prototype)
    if not args.sanitizers:
        library = os.path.join(os.path.dirname(args.graze), "libgraze.so")
        same(exported(library), set(functions), f"symbols of {library}")
    with tempfile.TemporaryDirectory() as folder:
        lines = [f"function {functions[name]}" for name in sorted(functions)]
        if struct.calcsize("P") == 8:
            lines += layout(headers(), folder)
    if args.record:
        with open(os.path.join(ROOT, RECORD), "w", encoding="utf-8") as file:
            file.write("\n".join(lines) + "\n")
    recorded = read(RECORD).splitlines()
    if struct.calcsize("P") != 8:
        recorded = [line for line in recorded if line.startswith("function ")]
    for line in sorted(set(recorded) - set(lines)):
        check(False, f"recorded, and no longer so: {line}; on purpose: {COMMAND}")
    for line in sorted(set(lines) - set(recorded)):
        check(False, f"not as recorded: {line}; on purpose: {COMMAND}")
    check(len(recorded) > 100, f"{len(recorded)} lines of {RECORD}")
    if struct.calcsize("P") == 8:
        check_mirrors(text, functions, "\n".join(recorded))
    checks.finish()


if __name__ == "__main__":
    main()
