"""The mirror of the public headers in src/python, held to them and to the record of abi.py: every structure, every
function's arguments, every number of an enum or flag. A mirrored name that is not compared here fails.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import ast
import ctypes
import enum
import glob
import importlib
import os
import re
import sys

from programs import ROOT, check, read, same

# Members whose names are words of Python, or nearly.
RENAMED = {"from": "start", "to": "end", "in": "inside", "case_": "case",
           "_mp_alloc": "alloc", "_mp_size": "size", "_mp_d": "limbs", "_mp_num": "numerator", "_mp_den": "denominator"}
GMP = {"CMpz": "__mpz_struct", "CMpq": "__mpq_struct"}
NUMBERS = {"int": ctypes.c_int, "unsigned": ctypes.c_uint, "unsigned long": ctypes.c_ulong, "size_t": ctypes.c_size_t,
           "unsigned long long": ctypes.c_ulonglong, "double": ctypes.c_double}
ADDRESSES = ("mpq_t", "mpz_t", "mpq_srcptr", "graze_rationals", "graze_cancel")
# A word stands for PREFIX and the word in capitals, with its place as number; keys are the names that `choice` is given.
WORDS = {"operation": "GRAZE_", "overlap": "GRAZE_OVERLAP_", "folds": "GRAZE_FOLDS_", "columns": "GRAZE_COLUMNS_",
         "format": "GRAZE_FORMAT_", "round": "GRAZE_ROUND_", "question": "GRAZE_QUESTION_", "on_as": "GRAZE_ON_AS_",
         "candidate_has": "GRAZE_HAS_", "truth": "GRAZE_TRUTH_", "by": "GRAZE_DRAW_BY_"}
NAMED = {"_KINDS": "GRAZE_", "_CELLS": "GRAZE_CELL_"}  # number -> word
CONSTANTS = {"_REPRESENTABLE": "GRAZE_GENERATE_REPRESENTABLE", "_TRIANGULATE": "GRAZE_SOLID_TRIANGULATE",
             "_NO_SIGN": "GRAZE_SIGN_ABSENT", "_AFFINE": "GRAZE_POSES_AFFINE", "_SHORTEST": "GRAZE_POSES_SHORTEST",
             "_NUMBERED": "GRAZE_POSES_NUMBERED", "_LONG": "GRAZE_POSES_LONG", "_SLERP": "GRAZE_POSES_SLERP",
             "_REPORT_TEXT": "GRAZE_JUDGEMENT_TEXT", "_REPORT_JSON": "GRAZE_JUDGEMENT_JSON", "_ON_AS_ANY": "GRAZE_ON_AS_ANY",
             "_TEXT": "GRAZE_COMPARISON_TEXT", "_JSON": "GRAZE_COMPARISON_JSON", "_CANCELED": "GRAZE_ECANCELED",
             "_BINARY32": "GRAZE_ROUND_BINARY32", "_BOX": "GRAZE_SHAPE_BOX", "_BALL": "GRAZE_SHAPE_BALL",
             "_CYLINDER": "GRAZE_SHAPE_CYLINDER", "_CUTTER": "GRAZE_SHAPE_CUTTER"}
# Whole numbers of the module itself.
OWN = {"_ENDLESS", "_BRIEF", "PIECE", "_FEW", "_SIZE", "DEPTH", "BUDGET", "CONTACTS"}


def modules():
    sys.path.insert(0, os.path.join(ROOT, "src", "python"))
    names = sorted(os.path.basename(path)[:-3] for path in glob.glob(os.path.join(ROOT, "src", "python", "graze", "*.py")))
    return {name: importlib.import_module("graze" if name == "__init__" else f"graze.{name}") for name in names}


def declared_kind(text, enums):
    """The kind of a type of C to a caller: an address, a number, or a structure by its name."""
    text = re.sub(r"\b(const|GRAZE_CHECKED)\b", "", text).strip()
    if "*" in text or text in ADDRESSES:
        return "address"
    if text == "void":
        return None
    return kind(ctypes.c_int if text in enums else NUMBERS[text]) if text in enums or text in NUMBERS else text


def kind(made):
    """The kind of a type of ctypes."""
    if made is None:
        return None
    if issubclass(made, ctypes.Structure):
        return struct_of(made)
    if issubclass(made, ctypes.Array):
        return kind(made._type_), made._length_
    if made in (ctypes.c_void_p, ctypes.c_char_p) or issubclass(made, ctypes._Pointer):
        return "address"
    return "real" if made is ctypes.c_double else "signed" if made(-1).value < 0 else "unsigned", ctypes.sizeof(made)


def struct_of(made):
    """COptions mirrors graze_options."""
    return GMP.get(made.__name__) or "graze" + re.sub("([A-Z])", r"_\1", made.__name__[1:]).lower()


def member_kinds(text, enums):
    """{struct: [kind of each member]} of the headers."""
    number = kind(ctypes.c_int)
    found = {"__mpz_struct": [number, number, "address"], "__mpq_struct": ["__mpz_struct"] * 2}
    for body, name in re.findall(r"typedef struct \w+ \{([^}]*)\} (graze_\w+);", text):
        kinds = []
        for line in filter(None, map(str.strip, body.split(";"))):
            first = re.match(r"(.*?)\w+(?:\[(\d+)\])?(?=,|$)", line)
            one = declared_kind(first[1], enums)
            kinds += [(one, int(first[2])) if first[2] else one] * len(line.split(","))
        found[name] = kinds
    return found


def every(base):
    return [made for direct in base.__subclasses__() for made in [direct, *every(direct)]
            if made.__module__.split(".")[0] == "graze"]


def check_structs(text, enums, recorded):
    sizes = {name: int(size) for name, size in re.findall(r"^struct (\w+) (\d+)$", recorded, re.M)}
    made_of = {}
    for name, member, at, size in re.findall(r"^member (\w+)\.(\w+) (\d+) (\d+)$", recorded, re.M):
        made_of.setdefault(name, []).append((RENAMED.get(member, member), int(at), int(size)))
    kinds = member_kinds(text, enums)
    structures = every(ctypes.Structure)
    check(len(structures) > 20 and not every(ctypes.Union), f"structures are found: {structures}")
    for made in structures:
        name, where = struct_of(made), f"{made.__name__} of src/python"
        fields = [(field[0], getattr(made, field[0]).offset, getattr(made, field[0]).size) for field in made._fields_]
        if check(name in sizes, f"{where}: there is no {name} in the record"):
            same(fields, made_of[name], f"{where} beside {name}: members, offsets, sizes")
            same(ctypes.sizeof(made), sizes[name], f"{where}: its size")
            same([kind(field[1]) for field in made._fields_], kinds[name], f"{where}: types of {', '.join(f[0] for f in fields)}")


def check_functions(functions, enums, declared):
    """Results and arguments of the functions, GMP's left out."""
    for name, (result, arguments) in declared.items():
        if name.startswith("mp") or not check(name in functions, f"_library.py declares {name}, which no header has"):
            continue
        before, inside = re.match(r"(.*?)\w+\((.*)\)$", functions[name]).groups()
        wanted = [] if inside.strip() == "void" else [declared_kind(re.sub(r"\w+$", "", a.strip()), enums) for a in inside.split(",")]
        same((kind(result), list(map(kind, arguments))), (declared_kind(before, enums), wanted), f"{name} of _library.py")


def choices(loaded):
    """(name, words) of each call of `choice`."""
    for module, made in loaded.items():
        for node in ast.walk(ast.parse(read("src", "python", "graze", module + ".py"))):
            if isinstance(node, ast.Call) and getattr(node.func, "id", "") == "choice":
                words = node.args[2]
                yield ast.literal_eval(node.args[0]), getattr(made, words.id) if isinstance(words, ast.Name) else ast.literal_eval(words)


def check_numbers(loaded, recorded):
    value = {name: int(number) for name, number in re.findall(r"^value (\w+) (-?\d+)$", recorded, re.M)}
    asked = list(choices(loaded))
    same({name for name, _ in asked}, set(WORDS), "names given to `choice`")
    tables = [(name, WORDS[name], dict(enumerate(words))) for name, words in asked if name in WORDS]
    for name, content in [item for made in loaded.values() for item in vars(made).items() if item[0].isupper()]:
        if isinstance(content, dict) and set(map(type, content)) == {int} and name != "BY_STATUS":
            check(name in NAMED, f"{name}: numbers of src/python that are not compared")
            tables.append((name, NAMED.get(name, ""), content))
        elif type(content) is int and name not in OWN:
            where = f"{name} of src/python beside {CONSTANTS.get(name, 'nothing: it is not compared')}"
            same(content, value.get(CONSTANTS.get(name)), where)
    for name, prefix, words in tables:
        if name == "format":  # rows as text alone
            value = {key: number for key, number in value.items() if key not in ("GRAZE_FORMAT_VTK", "GRAZE_FORMAT_NPY")}
        mirrored = {prefix + word.upper(): number for number, word in words.items()}
        wanted = {key for key in value if key in mirrored or (prefix != "GRAZE_" and key.startswith(prefix))}
        same(mirrored, {key: value[key] for key in wanted}, f"words and numbers of {name}")
    for made in every(enum.Enum):
        for member in made:
            same(member.value, value.get(f"GRAZE_{made.__name__.upper()}_{member.name}", value.get("GRAZE_" + member.name)), repr(member))
    statuses = {re.search(r"\((GRAZE_E\w+)\)", error.__doc__)[1]: status for status, error in loaded["errors"].BY_STATUS.items()}
    wanted = {name: number for name, number in value.items() if re.fullmatch("GRAZE_E(?!XTERIOR)[A-Z]+", name)}
    same(statuses, wanted, "statuses of errors.py")
    same([chr(value["GRAZE_STATE_" + letter]) for letter in "IBO"], list("IBO"), "states, which are given as letters")
    same((value["GRAZE_JOINT_TURN"], value["GRAZE_JOINT_SLIDE"]), (0, 1), "kinds of joints, by which _motions.by_joints goes")


def check_mirrors(text, functions, recorded):
    """`text` has the headers' declarations, `functions` their prototypes by name."""
    loaded, enums = modules(), set(re.findall(r"typedef enum \w+ \{[^}]*\} (graze_\w+);", text))
    check_structs(text, enums, recorded)
    check_functions(functions, enums, loaded["_library"]._FUNCTIONS)
    check_numbers(loaded, recorded)
