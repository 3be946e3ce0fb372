"""The table of scores by family, and its sums.

A score is what score.py prints; `code`, `setting` and `seconds` are added by whoever ran the code, and the candidate's
file name stands for a code that is not named.
SPDX-License-Identifier: CC0-1.0
"""
from tables import FAMILIES, BadInput

LEVELS = ("0", "2^-40", "1e-6", "1e-3")
HEAD = ("code", "setting", "scenes", *(f"δ = {level}" for level in LEVELS), "`on` called in, on, out", "no answer", "seconds")


def percent(rate):
    """Three digits; what is not 0 never looks like it."""
    return "–" if rate is None else "0" if rate == 0 else f"{100 * rate:.3g} %"


def pooled(scores, level):
    """The mean of the rates among all `in` and all `out` points of the scenes."""
    rates = []
    for pmc in ("in", "out"):
        parts = [score["levels"][level][pmc] for score in scores]
        points = sum(part["points"] for part in parts)
        rates.append(sum(part["wrong"] for part in parts) / points if points else None)
    return None if None in rates else sum(rates) / 2


def row(code, setting, scores):
    on = [sum(score["on"][answer] for score in scores) for answer in ("in", "on", "out")]
    none = sum(score["missing"] + score["unreadable"] for score in scores)
    seconds = [score["seconds"] for score in scores if score.get("seconds") is not None]
    return (code, setting, len(scores), *(percent(pooled(scores, level)) for level in LEVELS), ", ".join(map(str, on)), none,
            f"{sum(seconds):.0f}" if seconds else "")


def grouped(scores):
    """(code, setting): scores, in the order of their first appearance."""
    groups = {}
    for score in scores:
        groups.setdefault((score.get("code") or score["candidate"], score.get("setting") or ""), []).append(score)
    return groups


def table(scores):
    """Markdown: a table for each family that occurs, and one for all."""
    if not all(isinstance(score, dict) and {"levels", "on", "family", "candidate"} <= score.keys() for score in scores):
        raise BadInput("a line is no score; expected what score.py prints")
    lines = []
    for family in (*FAMILIES, "all"):
        groups = grouped([score for score in scores if family in (score["family"], "all")])
        if groups:
            lines += ["", f"**{family}**", "", "| " + " | ".join(HEAD) + " |", "|---|---|" + "--:|" * (len(HEAD) - 2)]
            lines += ["| " + " | ".join(map(str, row(*key, group))) + " |" for key, group in groups.items()]
    return "\n".join(lines[1:]) + "\n"
