"""Solids of other packages, known by what they have: meshes of trimesh and meshio, polygons of
shapely.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

from typing import Any, List, Optional, Tuple

from .errors import InputError

_SURFACES = ("triangle", "quad", "polygon")
_CURVED = ("triangle6", "quad8", "quad9")
_LOWER = ("vertex", "line")


def arrays_of(source: Any) -> Optional[Tuple[Any, Any]]:
    """(vertices, facets) of an object of such a package; None if it is none.

    Raises:
        InputError: it has no closed boundary of facets: cells of volume, curved cells, heights.
    """
    if hasattr(source, "geom_type"):
        return _of_polygons(source)
    if hasattr(source, "vertices") and hasattr(source, "faces"):
        return source.vertices, source.faces
    if hasattr(source, "points") and hasattr(source, "cells"):
        return _of_cells(source)
    return None


def _of_cells(mesh: Any) -> Tuple[Any, Any]:
    facets: List[Any] = []
    for block in mesh.cells:
        kind, cells = (block.type, block.data) if hasattr(block, "type") else block
        if str(kind).rstrip("0123456789") in _SURFACES and kind not in _CURVED:
            facets.extend([int(vertex) for vertex in cell] for cell in cells)
        elif kind not in _LOWER:
            raise InputError(f"the mesh has cells of type {kind}; expected triangles, quads and "
                             "polygons, the boundary of a solid")
    return mesh.points, facets


def _of_polygons(shape: Any) -> Tuple[Any, Any]:
    if shape.geom_type not in ("Polygon", "MultiPolygon"):
        raise InputError(f"a {shape.geom_type} is no solid; expected a Polygon or a MultiPolygon")
    vertices: List[Any] = []
    rings: List[Any] = []
    for polygon in shape.geoms if shape.geom_type == "MultiPolygon" else [shape]:
        for ring in (polygon.exterior, *polygon.interiors):
            corners = list(ring.coords)[:-1]  # the last one is the first again
            if any(len(corner) != 2 for corner in corners):
                raise InputError("the polygon has heights; expected x and y alone")
            rings.append(list(range(len(vertices), len(vertices) + len(corners))))
            vertices.extend(corners)
    return vertices, rings
