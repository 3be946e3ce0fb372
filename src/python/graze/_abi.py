"""graze.h, and what it takes from gmp.h, as the record `abi.txt` has them.

The record has a line for each function, number, structure and member. tests/install/abi.py writes
it from the headers and holds it to the compiler, so nothing here is a second copy. A member whose
name is a word of Python has `_` behind it: `from_`.
SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import ctypes
import functools
import keyword
import os
import re
from types import SimpleNamespace
from typing import Any, Dict, List, Tuple

_NUMBERS = {"int": ctypes.c_int, "unsigned": ctypes.c_uint, "unsigned char": ctypes.c_ubyte,
            "unsigned long": ctypes.c_ulong, "unsigned long long": ctypes.c_ulonglong,
            "size_t": ctypes.c_size_t, "double": ctypes.c_double}
_ADDRESSES = ("mpq_t", "mpz_t", "mpq_srcptr", "mpq_ptr", "mpz_srcptr", "graze_rationals",
              "graze_cancel")


class Structure(ctypes.Structure):
    """A structure of graze.h. The member `size` of options is set when one is made."""

    def __init__(self, *values: Any, **members: Any) -> None:
        super().__init__(*values, **members)
        if self._fields_[0][0] == "size":
            self.size = ctypes.sizeof(self)


_numbers: Dict[str, int] = {}
_enums: Dict[str, Dict[str, int]] = {}
_members: Dict[str, List[Tuple[str, str]]] = {}
#: Prototypes of the functions by their names, those of GMP too.
PROTOTYPES: Dict[str, str] = {}


def _read() -> None:
    path = os.path.join(os.path.dirname(os.path.abspath(__file__)), "abi.txt")
    with open(path, encoding="ascii") as file:
        for line in file.read().splitlines():
            kind, rest = line.split(" ", 1)
            if kind == "value":
                name, number, *enum = rest.split()
                _numbers[name] = int(number)
                for of in enum:
                    _enums.setdefault(of, {})[name] = int(number)
            elif kind == "struct":
                _members[rest.split()[0]] = []
            elif kind == "member":
                name, _, _, declared = rest.split(" ", 3)
                struct, _, member = name.partition(".")
                _members[struct].append((member, declared))
            else:
                PROTOTYPES[rest[:rest.index("(")].split()[-1].lstrip("*")] = rest


@functools.lru_cache(maxsize=None)
def _type_of(declared: str) -> Any:
    """A type of C, as ctypes has it: handles, rationals and what is given out are addresses."""
    array = re.fullmatch(r"(.*)\[(\d+)\]", declared)
    if array:
        return _type_of(array[1]) * int(array[2])
    pointed = re.fullmatch(r"const ([\w ]+) \*", declared)
    if pointed and pointed[1] == "char":
        return ctypes.c_char_p
    if pointed and (pointed[1] in _members or pointed[1] in _NUMBERS):
        return ctypes.POINTER(_type_of(pointed[1]))
    if "*" in declared or declared in _ADDRESSES:
        return ctypes.POINTER(ctypes.c_void_p) if declared.endswith("**") else ctypes.c_void_p
    if declared in _members:
        fields = [(name + "_" * keyword.iskeyword(name), _type_of(kind))
                  for name, kind in _members[declared]]
        return type(declared, (Structure,), {"_fields_": fields, "__qualname__": f"C.{declared}"})
    if declared in _enums:
        return ctypes.c_int
    return _NUMBERS[declared]


def _argument(declared: str) -> Any:
    """Numbers may stand in any memory: in an array of ctypes, of numpy, at an address."""
    plain = declared[len("const "):] if declared.startswith("const ") else declared
    anywhere = plain in _ADDRESSES or plain.rstrip(" *") in _NUMBERS
    return _type_of(plain if anywhere else declared)


def signature(name: str) -> Tuple[Any, List[Any]]:
    """restype and argtypes of a function."""
    prototype = PROTOTYPES[name].replace("GRAZE_CHECKED ", "")
    before, _, inside = prototype.rstrip(")").partition("(")
    result = before[:-len(name)].strip()
    arguments = [] if inside.strip() == "void" else [
        _argument(re.sub(r"\w+$", "", argument).strip()) for argument in inside.split(",")]
    return None if result == "void" else _type_of(result), arguments


def words(enum: str) -> Dict[str, int]:
    """The values of an enum by their words: the names without what all of them begin with and
    without the enum's own name, in lower case."""
    values, own = _enums[enum], enum.upper() + "_"
    begin = os.path.commonprefix([*values])
    skipped = begin.rindex("_") + 1
    return {name[len(own) if name.startswith(own) else skipped:].lower(): number
            for name, number in values.items()}


_read()
#: Structures and numbers under their names in graze.h.
C: Any = SimpleNamespace(**_numbers, **{name: _type_of(name) for name in _members})
