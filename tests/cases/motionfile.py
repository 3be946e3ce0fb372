"""A case's motion as a gp expression over the functions of motion.gp.

SPDX-License-Identifier: GPL-3.0-or-later

Only the text is turned here: JSON into calls, number tokens into ratios, s into t, and a piece cut
where its turns begin a new quarter. gp does the algebra.
"""
import json
import re

from exact import Fraction as F

TOKEN = re.compile(r"\s*(?:((?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)|([ts])|([-+*/^()]))")


def expression(text, a, b):
    """An expression in t and s as gp reads it; [a, b] is the piece s runs along."""
    out, at, text = [], 0, str(text).rstrip()
    while at < len(text):
        token = TOKEN.match(text, at)
        if not token:
            raise ValueError(f"{text}: an unknown character")
        at = token.end()
        value, name, sign = token.groups()
        operand = out and out[-1] not in ("+", "-", "*", "/", "^", "(", "(-1)*")
        if value:
            out.append(f"({F(value)})")
        elif name:
            out.append("'t" if name == "t" else f"(('t-({a}))/({F(b) - F(a)}))")
        elif sign in "+-" and not operand:
            if out and out[-1] == "^":
                digits = re.compile(r"\s*\d+").match(text, at)
                at = digits.end()
                out.append(f"({sign}{digits[0].strip()})")
            elif sign == "-":
                out.append("(-1)*")
        else:
            out.append(sign)
    return "(" + "".join(out) + ")"


def vector(entries, a, b):
    return "[" + ",".join(expression(e, a, b) for e in entries) + "]"


class Piece:
    """One piece [a, b] of a motion in dimension d."""

    def __init__(self, a, b, d):
        self.a, self.b, self.d = a, b, d

    def cuts(self, transform):
        """Where the turns of a transform begin a new quarter."""
        (name, value), = ((n, v) for n, v in transform.items() if n != "center")
        if name == "compose":
            return set().union(*(self.cuts(part) for part in value))
        n = abs(int(F(str(value["quarters"])))) if name == "turn" else 0
        return {self.a + (self.b - self.a) * F(k, n) for k in range(1, n)}

    def text(self, transform, u, v):
        """The transform on [u, v] as a gp expression."""
        a, b, zero = self.a, self.b, ["0"] * self.d
        (name, value), = ((n, x) for n, x in transform.items() if n != "center")
        place = vector(transform.get("center", zero), a, b)
        if name == "compose":
            return "compose([" + ",".join(self.text(part, u, v) for part in value) + "])"
        if name == "matrix":
            return "rows([" + ",".join(vector(row, a, b) for row in value) + "])"
        if name == "translate":
            return f"translate({vector(value, a, b)})"
        if name == "quaternion":
            return f"quaternion({vector(value, a, b)},{place})"
        if name == "scale":
            factor = vector(value, a, b) if isinstance(value, list) else expression(value, a, b)
            return f"scale({factor},{place})"
        place = vector(value.get("center", zero), a, b)
        axis = vector(value["axis"], a, b) if "axis" in value else "0"
        if name == "rotate":
            h, n = expression(value["tan_half"], a, b), int(F(str(value.get("times", 1))))
            return f"rotate({h},{n},{axis},{(u + v) / 2},{place})"
        if name == "turn":
            return f"turn({int(F(str(value['quarters'])))},{a},{b},{u},{axis},{place})"
        raise ValueError(f"there is no transform {name}")


def pieces(motion):
    out = []
    for piece in motion["pieces"]:
        a, b = (F(str(t)) for t in piece["t"])
        p = Piece(a, b, int(motion["dimension"]))
        cuts = sorted({a, b} | p.cuts(piece["transform"]))
        out += [f"[{u},{v},{p.text(piece['transform'], u, v)}]" for u, v in zip(cuts, cuts[1:])]
    return "[" + ",".join(out) + "]"


def keyframes(motion):
    d = int(motion["dimension"])
    rest, key = (["1", "0", "0", "0"], "quaternion") if d == 3 else (["1", "0"], "complex")
    frames = []
    for f in motion["keyframes"]:
        frames.append(f"[{F(str(f['t']))},{vector(f.get('position', ['0'] * d), 0, 1)},"
                      f"{vector(f.get(key, rest), 0, 1)}]")
    return "keyframes([" + ",".join(frames) + "])"


def gp_motion(motion):
    if "pieces" in motion:
        return pieces(motion)
    if "keyframes" in motion:
        return keyframes(motion)
    if "relative" in motion:
        pair = motion["relative"]
        return f"relative({gp_motion(pair['moving'])},{gp_motion(pair['frame'])})"
    return "sequence([" + ",".join(gp_motion(m) for m in motion["sequence"]) + "])"


def motion_of(path):
    with open(path, encoding="utf-8") as file:
        return gp_motion(json.load(file, parse_int=str, parse_float=str))
