# SPDX-License-Identifier: GPL-3.0-or-later
"""The table of columns that options of graze classify add, as src/output/report/columns.c has it."""
import os
import re

from harness import ROOT

SET = re.compile(r'\{\.option = "([\w-]+)",.*?\.names = \{(.*?)\}\},\n', re.S)


def column_sets():
    """{option: {column: its mark or ""}}, in the order of a table's columns."""
    with open(os.path.join(ROOT, "src", "output", "report", "columns.c"), encoding="utf-8") as file:
        source = file.read()
    sets = {option: {name: mark or "" for name, mark in re.findall(r'\{"(\w+)", (?:0|\'(.)\')', names)} for option, names in SET.findall(source)}
    assert len(sets) == source.count(".option = ") > 0 and all(sets.values()), sets
    return sets
