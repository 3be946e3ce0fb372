"""Closed forms as READMEs write them, enclosed by ratios; signed squares for comparisons without roots.

SPDX-License-Identifier: GPL-3.0-or-later

A form is made of ratios, + - * / ^, sqrt(FORM) and root(POLYNOMIAL, a, b), the polynomial's only root in the open
interval (a, b). An enclosure is a pair of Fractions, at most 2^-190 or so apart for forms of ordinary size.
"""
import ast
import math
import re

from exact import Fraction as F
from times import parse_time, value

PLACES = 200


def sqrt_bounds(x):
    """Ratios about the root of a ratio."""
    scaled = math.floor(x * 4 ** PLACES)
    low = math.isqrt(scaled)
    return F(low, 2 ** PLACES), F(low + (low * low != x * 4 ** PLACES), 2 ** PLACES)


def root_bounds(text):
    p, low, high = parse_time(text)
    if p is None:
        return low, high
    below = value(p, low) > 0
    while high - low > F(1, 2 ** PLACES):
        middle = (low + high) / 2
        if value(p, middle) == 0:
            return middle, middle
        low, high = (middle, high) if (value(p, middle) > 0) == below else (low, middle)
    return low, high


def product(a, b):
    ends = [x * y for x in a for y in b]
    return min(ends), max(ends)


def quotient(a, b):
    if b[0] <= 0 <= b[1]:
        raise ValueError("division by what may be 0")
    return product(a, (1 / b[1], 1 / b[0]))


COMBINE = {ast.Add: lambda a, b: (a[0] + b[0], a[1] + b[1]), ast.Sub: lambda a, b: (a[0] - b[1], a[1] - b[0]),
           ast.Mult: product, ast.Div: quotient}


def enclose(node, roots):
    if isinstance(node, ast.Constant) and isinstance(node.value, int):
        return F(node.value), F(node.value)
    if isinstance(node, ast.Name):
        return roots[int(node.id[1:])]
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
        low, high = enclose(node.operand, roots)
        return -high, -low
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Pow):
        out, base = (F(1), F(1)), enclose(node.left, roots)
        for _ in range(node.right.value):
            out = product(out, base)
        return out
    if isinstance(node, ast.BinOp):
        return COMBINE[type(node.op)](enclose(node.left, roots), enclose(node.right, roots))
    if isinstance(node, ast.Call) and node.func.id == "sqrt":
        low, high = enclose(node.args[0], roots)
        return sqrt_bounds(low)[0], sqrt_bounds(high)[1]
    raise ValueError(f"no closed form: {ast.dump(node)}")


def form_bounds(text):
    """The enclosure of a closed form."""
    roots = []

    def keep(found):
        roots.append(root_bounds(found[0]))
        return f"R{len(roots) - 1}"
    text = re.sub(r"root\([^,]*,[^,]*,[^,)]*\)", keep, text)
    return enclose(ast.parse(text.replace("^", "**"), mode="eval").body, roots)


def signed_square(x):
    return x * x if x > 0 else -x * x
