"""The table of scores by family, and its sums.

A score is what score.py prints; `code`, `setting` and `seconds` are added by whoever ran the code, and the candidate's
file name stands for a code that is not named. A line with `failure`, a reason, has no score: a row says of how many
scenes its figures are.
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


def row(code, setting, lines):
    scores = [line for line in lines if "failure" not in line]
    on = [sum(score["on"][answer] for score in scores) for answer in ("in", "on", "out")]
    none = sum(score["missing"] + score["unreadable"] for score in scores)
    seconds = [score["seconds"] for score in scores if score.get("seconds") is not None]
    scenes = len(scores) if len(scores) == len(lines) else f"{len(scores)} of {len(lines)}"
    return (code, setting, scenes, *(percent(pooled(scores, level)) for level in LEVELS), ", ".join(map(str, on)), none,
            f"{sum(seconds):.0f}" if seconds else "")


def grouped(scores):
    """(code, setting): scores, in the order of their first appearance."""
    groups = {}
    for score in scores:
        groups.setdefault((score.get("code") or score["candidate"], score.get("setting") or ""), []).append(score)
    return groups


def table(scores):
    """Markdown: a table for each family that occurs, and one for all."""
    parts = {"levels", "on", "family", "candidate"}
    if not all(isinstance(score, dict) and ("failure" in score or parts <= score.keys()) for score in scores):
        raise BadInput("a line is no score; expected what score.py prints")
    lines = []
    for family in (*FAMILIES, "all"):
        groups = grouped([score for score in scores if family in (score["family"], "all")])
        if groups:
            lines += ["", f"**{family}**", "", "| " + " | ".join(HEAD) + " |", "|---|---|" + "--:|" * (len(HEAD) - 2)]
            lines += ["| " + " | ".join(map(str, row(*key, group))) + " |" for key, group in groups.items()]
    return "\n".join(lines[1:]) + "\n"


def failures(lines):
    """Markdown: scenes without a score, by code, setting and reason; nothing where there are none."""
    found = {}
    for line in lines:
        if "failure" in line:
            found.setdefault((line["code"], line["setting"], line["failure"]), []).append(line["scene"])
    rows = [f"| {code} | {setting} | {reason} | {', '.join(scenes)} |" for (code, setting, reason), scenes in found.items()]
    return "\n".join(["", "**without a score**", "", "| code | setting | reason | scenes |", "|---|---|---|---|", *rows]) + "\n" if rows else ""


def spread(values):
    """The middle one and the greatest."""
    values = sorted(values)
    return f"{values[len(values) // 2]:.2g}, {values[-1]:.2g}" if values else "–"


def distances(lines):
    """Markdown: how far signed distances and meshes are off, over the diagonal, in the scenes together; nothing where there are none of either.

    `diagonal` is added by whoever ran the code.
    """
    rows = []
    for (code, setting), group in grouped([line for line in lines if line.get("sdf") or line.get("judge")]).items():
        sdf = [(line["sdf"]["all"], line["diagonal"]) for line in group if line["sdf"]]
        judged = [(line["judge"]["distance"], line["diagonal"]) for line in group if line["judge"] and line["judge"]["distance"]]
        over, points = (sum(part[name] for part, _ in sdf) for name in ("over", "points"))
        lows = [spread([part[name]["low"] / diagonal for part, diagonal in judged if part[name] and part[name]["low"] is not None])
                for name in ("mesh_to_sweep_outside", "mesh_to_sweep_inside", "sweep_to_mesh")]
        rows.append((code, setting, len(group), percent(over / points) if points else "–",
                     spread([part["greatest_miss"] / diagonal for part, diagonal in sdf]), *lows))
    head = ("code", "setting", "scenes", "too far", "greatest error", "mesh outside the sweep", "mesh inside", "boundary from the mesh")
    text = ["", "**distances**", "", "| " + " | ".join(head) + " |", "|---|---|" + "--:|" * (len(head) - 2)]
    return "\n".join(text + ["| " + " | ".join(map(str, row)) + " |" for row in rows]) + "\n" if rows else ""
