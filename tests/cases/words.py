"""Meaning of a word by [EI]: counts, position case, definition, class and membership.

SPDX-License-Identifier: GPL-3.0-or-later
"""
# Table 1: rows by the state at the end, columns by the state at the start.
POSITION = {"O": {"O": 1, "B": 4, "I": 7}, "B": {"O": 2, "B": 5, "I": 8},
            "I": {"O": 3, "B": 6, "I": 9}}
NUMBER = {"regular": 5, "fold": 6, "fold_boundary": 7, "boundary": 8, "exterior": 9}


def read(word, combined=False):
    """The fields i, t, case, class, definition and pmc as the table prints them."""
    inner = word.strip("B")
    gaps = inner.split("B") if inner else []
    crossed = sum(a != b for a, b in zip(gaps, gaps[1:]))
    touched = max(len(gaps) - 1, 0) - crossed
    for end, near in ((word[0], gaps[:1]), (word[-1], gaps[-1:])):
        if end == "B" and near:
            crossed, touched = crossed + (near == ["I"]), touched + (near == ["O"])
    if word == "B":
        touched = 1
    double = crossed + (word[0] == "I") + (word[-1] == "I")
    if double % 2 or set(word) - set("IBO") or "IO" in word or "OI" in word or "BB" in word:
        raise ValueError(f"{word} is no word")
    case, visits = POSITION[word[-1]][word[0]], double // 2
    if visits == 0:
        name = "boundary" if touched else "exterior"
    elif visits > 1 and (combined or touched == 0):
        name = "fold"
    else:
        name = "fold_boundary" if touched else "regular"
    number = {"fold": 10, "fold_boundary": 11}.get(name) if combined else None
    return {"i": str(crossed), "t": str(touched), "case": str(case), "class": name,
            "definition": "ext" if case in (5, 6, 8, 9) else str(number or NUMBER[name]),
            "pmc": "in" if visits else "on" if touched else "out"}


def unswept(word):
    """Membership in the unsweep ([IS] eq. 35)."""
    return "in" if word == "I" else "out" if "O" in word else "on"


def combinations():
    """All 84 (definition, case, dimension), `ext CLASS` in the cases [EI] leaves out."""
    main = [(str(d), c) for d in (5, 6, 7, 10, 11) for c in (1, 2, 3, 4, 7)]
    main += [("8", c) for c in (1, 2, 4)] + [("9", 1)]
    main += [("ext " + n, c) for n in ("regular", "fold", "fold_boundary") for c in (5, 6, 8, 9)]
    main.append(("ext boundary", 5))
    return {(definition, case, d) for definition, case in main for d in (2, 3)}
