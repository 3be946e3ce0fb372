"""A mesh as shells for the CGAL programs (../shells.h): parts first, then cavities.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from exact import Fraction as F

from solids import cross


def components(mesh):
    """Facet lists of the parts connected by shared vertices."""
    home = list(range(len(mesh.vertices)))

    def find(k):
        while home[k] != k:
            home[k] = home[home[k]]
            k = home[k]
        return k
    for f in mesh.facets:
        for k in f[1:]:
            home[find(k)] = find(f[0])
    out = {}
    for f in mesh.facets:
        out.setdefault(find(f[0]), []).append(f)
    return list(out.values())


def volume6(mesh, facets):
    total = F(0)
    for f in facets:
        p = mesh.vertices[f[0]]
        for a, b in zip(f[1:], f[2:]):
            n = cross(mesh.vertices[a], mesh.vertices[b])
            total += sum(x * y for x, y in zip(p, n))
    return total


def shells_text(mesh):
    """Every shell outward oriented, its sign before it, and the closing `end`."""
    shells = sorted((volume6(mesh, c) < 0, k, c) for k, c in enumerate(components(mesh)))
    lines = []
    for cavity, _, facets in shells:
        used = sorted({k for f in facets for k in f})
        index = {k: n for n, k in enumerate(used)}
        lines.append(f"shell {'-' if cavity else '+'} {len(used)} {len(facets)}")
        lines += [" ".join(str(x) for x in mesh.vertices[k]) for k in used]
        for f in facets:
            cycle = [index[k] for k in (f[::-1] if cavity else f)]
            lines.append(" ".join(str(k) for k in [len(cycle)] + cycle))
    return "\n".join(lines + ["end"]) + "\n"
