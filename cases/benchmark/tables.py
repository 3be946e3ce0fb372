"""Files of a scene of the benchmark, as golden.py and score.py read them.

SPDX-License-Identifier: CC0-1.0
"""
import csv
import json
import math
import os
from fractions import Fraction as F

STATUS_BAD_INPUT = 3
FAMILIES = ("parts", "motions", "degenerate", "large", "adversarial")


class BadInput(Exception):
    """A file that is not what is expected; the message names it."""


def read_text(path):
    try:
        with open(path, encoding="utf-8-sig", newline="") as file:
            return file.read()
    except OSError as error:
        raise BadInput(f"{path}: {error.strerror}") from error
    except UnicodeDecodeError as error:
        raise BadInput(f"{path}: byte {error.start} is not UTF-8") from error


def read_table(path):
    """The names of a CSV table and its rows, as dictionaries; lines that begin with # and blank ones are passed over."""
    lines = [line for line in read_text(path).splitlines() if line.strip() and not line.startswith("#")]
    reader = csv.DictReader(lines, strict=True)
    try:
        names, rows = [name.strip() for name in reader.fieldnames or ()], list(reader)
    except csv.Error as error:
        raise BadInput(f"{path}: {error}") from error
    twice = [name for name in names if names.count(name) > 1]
    if twice:
        raise BadInput(f"{path}: two columns {twice[0]}")
    return names, rows


def number(text):
    """A finite number, or a ratio of whole ones, as the nearest double, or None."""
    try:
        found = math.nan if "_" in text else float(F(text) if "/" in text else text)
    except (TypeError, ValueError, ZeroDivisionError, OverflowError):
        return None
    return found if math.isfinite(found) else None


def read_scene(folder):
    """scene.json, whose numbers are such."""
    path = os.path.join(folder, "scene.json")
    try:
        scene = json.loads(read_text(path))
        good = (scene["name"] and scene["family"] in FAMILIES and scene["count"] > 0 and 0 < scene["diagonal"] < math.inf
                and scene["seed"] is not None and all(p["deviation"] >= 0 for p in scene["poses"].values()))
    except (ValueError, KeyError, TypeError, AttributeError) as error:
        raise BadInput(f"{path}: {type(error).__name__} {error}; expected name, family, count, seed, diagonal and poses") from error
    if not good:
        raise BadInput(f"{path}: a value is out of range; expected a family of {', '.join(FAMILIES)}, count and diagonal above 0, deviations from 0 up")
    return scene
