#!/usr/bin/env python3
"""# suite: the binary interface against the recorded one in src/python/graze/abi.txt.

SPDX-License-Identifier: GPL-3.0-or-later

Recorded are every exported function with its prototype, every value of an enum and every flag, and size and offsets of
every struct on machines with 64-bit pointers, with the type of each member; the module for Python is made from it. A
change on purpose is recorded by `python3 tests/install/abi.py --record`; its commit says what users of the library must
do. The order of arguments is checked here too (graze.h, rule 2).
"""
import ctypes
import glob
import keyword
import os
import re
import struct
import sys
import tempfile

from programs import ROOT, check, checks, options, output, read, same

RECORD = os.path.join("src", "python", "graze", "abi.txt")
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
    """{name: {member: its type}}"""
    found = {}
    for body, name in re.findall(r"typedef struct \w+ \{([^}]*)\} (graze_\w+);", text):
        members = found[name] = {}
        for line in filter(None, map(str.strip, body.split(";"))):
            declared = re.match(r".*?(?=\w+(?:\[\w+\])?(?:,|$))", line)[0]
            for one in line[len(declared):].split(","):
                member, array = re.fullmatch(r"[ *]*(\w+)((?:\[\w+\])?)", one).groups()
                members[member] = declared.strip() + array
    return found


def values(text):
    """{value: its enum}, and flags and other numbers that are defined, whose enum is ""."""
    found = {}
    for body, name in re.findall(r"typedef enum \w+ \{([^}]*)\} (graze_\w+);", declarations(text)):
        found.update(dict.fromkeys(re.findall(r"\b(GRAZE_[A-Z0-9_]+) =", body), name))
    return {**found, **dict.fromkeys(re.findall(r"^#define (GRAZE_(?!VERSION)[A-Z0-9_]+) \(?-?\d", text, re.M), "")}


# Structures of gmp.h that the functions' values are made of, and its functions that src/python calls.
GMP = {"__mpz_struct": {"_mp_alloc": "int", "_mp_size": "int", "_mp_d": "mp_limb_t *"},
       "__mpq_struct": {"_mp_num": "__mpz_struct", "_mp_den": "__mpz_struct"}}
GMP_FUNCTIONS = ["char *mpq_get_str(char *out, int base, mpq_srcptr x)", "int mpq_set_str(mpq_ptr x, const char *text, int base)",
                 "size_t mpz_sizeinbase(mpz_srcptr x, int base)", "void mpq_clear(mpq_ptr x)", "void mpq_init(mpq_ptr x)",
                 "void mpq_set_d(mpq_ptr x, double value)"]


def layout(text, folder):
    """Lines with every value of an enum and every size, offset and type, from a compiled program; it is not compiled
    where a type or a prototype that the record has is not the declared one."""
    lines = [f'printf("value %s %d{enum and " " + enum}\\n", "{name}", (int){name});' for name, enum in values(text).items()]
    checked = [f"{prototype};" for prototype in [*prototypes(declarations(text)).values(), *GMP_FUNCTIONS]]
    for name, members in {**structs(declarations(text)), **GMP}.items():
        lines.append(f'printf("struct {name} %zu\\n", sizeof({name}));')
        for member, kind in members.items():
            lines.append(f'printf("member {name}.{member} %zu %zu {kind}\\n", offsetof({name}, {member}), '
                         f"sizeof((({name} *)0)->{member}));")
            checked.append(f"_Static_assert(__builtin_types_compatible_p(__typeof__((({name} *)0)->{member}), __typeof__({kind})), "
                           f'"{name}.{member}");')
    source, program = os.path.join(folder, "layout.c"), os.path.join(folder, "layout")
    with open(source, "w", encoding="utf-8") as file:
        file.write("#include <graze.h>\n#include <stdio.h>\n" + "\n".join(checked) + "\nint main(void) {\n" +
                   "\n".join(lines) + "\nreturn 0;\n}\n")
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


def check_module(lines):
    """The structures of src/python have the compiler's layout, and its functions the types that the prototypes say."""
    sys.path.insert(0, os.path.join(ROOT, "src", "python"))
    from graze import _abi, errors
    for line in lines:
        kind, name, *numbers = line.split()
        struct_name, _, member = name.partition(".")
        made = getattr(_abi.C, struct_name, None)
        if kind == "struct":
            same([str(ctypes.sizeof(made))], numbers, f"size of {name} in src/python")
        elif kind == "member":
            field = getattr(made, member + "_" * keyword.iskeyword(member))
            same([str(field.offset), str(field.size)], numbers[:2], f"offset and size of {name} in src/python")
        elif kind == "function":
            name = re.search(r"(\w+)\(", line)[1]
            same(len(_abi.signature(name)[1]), 0 if line.endswith("(void)") else line.count(",") + 1, f"arguments of {name}")
    pointer, address, text, number, size = (ctypes.POINTER, ctypes.c_void_p, ctypes.c_char_p, ctypes.c_int, ctypes.c_size_t)
    for name, wanted in (
            ("graze_free", (None, [address])),
            ("graze_solid_read", (number, [pointer(address), address, text, ctypes.c_uint])),
            ("graze_distances_doubles", (number, [address, address, address, address, size, ctypes.c_double])),
            ("graze_draw", (number, [address, address, text, pointer(_abi.C.graze_draw_options)])),
            ("graze_boundary_face", (pointer(size), [address, size])),
            ("graze_site_snap", (number, [pointer(address), address, address, address, address, _abi.C.graze_cell])),
            ("graze_trace_verdict", (_abi.C.graze_verdict, [address])),
            ("graze_time_row", (ctypes.c_ulong, [address])),
            ("mpq_get_str", (address, [address, number, address]))):
        same(_abi.signature(name), wanted, f"types of {name} in src/python")
    for enum, wanted in (("graze_pmc", ["none", "in", "on", "out", "undecided"]), ("graze_operation", ["sweep", "unsweep"]),
                         ("graze_rounding", ["none", "binary64", "binary32"]), ("graze_on_as", ["on", "any", "in", "out"]),
                         ("graze_kind", ["intersection", "tangency"]), ("graze_candidate_has", ["columns", "sdf"])):
        same(list(_abi.words(enum)), wanted, f"words of {enum} in src/python")
    same(set(errors.BY_STATUS), set(_abi.words("graze_status").values()) - {0}, "statuses of errors.py")
    for error in errors.BY_STATUS.values():
        same(error.status, getattr(_abi.C, re.search(r"\((GRAZE_E\w+)\)", error.__doc__)[1]), f"status of {error}")
    same([chr(getattr(_abi.C, "GRAZE_STATE_" + letter)) for letter in "IBO"], list("IBO"), "states, which are given as letters")


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
        lines = [f"function {prototype}" for prototype in [*(functions[name] for name in sorted(functions)), *GMP_FUNCTIONS]]
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
        check_module(lines)
    checks.finish()


if __name__ == "__main__":
    main()
