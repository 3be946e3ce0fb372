"""Curved solids as expressions: the nodes of `.csg.json` files, made by constructors and operators.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

from typing import Any, Dict, Optional, Type, TypeVar

Node = Dict[str, Any]
Made = TypeVar("Made", bound="Expressions")


class Expressions:
    """Constructors and operators of curved solids. A solid of another origin has no expression."""

    _node: Optional[Node] = None

    @property
    def dimension(self) -> int:
        """2 or 3."""
        raise NotImplementedError

    @classmethod
    def _expressed(cls: Type[Made], dimension: int, node: Node, *, lazily: bool = False) -> Made:
        raise NotImplementedError

    @classmethod
    def _primitive(cls: Type[Made], dimension: int, key: str, **numbers: Any) -> Made:
        """A primitive of the numbers that are given; a keyword of Python has a _ behind it."""
        given = {name.rstrip("_"): value for name, value in numbers.items() if value is not None}
        return cls._expressed(dimension, {key: given})

    @classmethod
    def halfspace(cls: Type[Made], normal: Any, offset: Any = 0) -> Made:
        """The points x with normal . x <= offset."""
        return cls._primitive(len(normal), "halfspace", normal=normal, offset=offset)

    @classmethod
    def box(cls: Type[Made], low: Any, high: Any) -> Made:
        """The box between two corners, low < high in each coordinate; in the plane a rectangle."""
        return cls._primitive(len(low), "box", low=low, high=high)

    @classmethod
    def ball(cls: Type[Made], radius: Any, center: Any = (0, 0, 0)) -> Made:
        """A ball; with a center of two numbers a disk."""
        return cls._primitive(len(center), "ball", radius=radius, center=center)

    @classmethod
    def ellipsoid(cls: Type[Made], semiaxes: Any, center: Any = None) -> Made:
        """An ellipsoid along the axes; in the plane an ellipse."""
        return cls._primitive(len(semiaxes), "ellipsoid", semiaxes=semiaxes, center=center)

    @classmethod
    def cylinder(cls: Type[Made], radius: Any, axis: Any = (0, 0, 1), point: Any = (0, 0, 0), low: Any = None,
                 high: Any = None) -> Made:
        """A cylinder about the line through `point`; `low` and `high` are multiples of `axis`, without them it is infinite."""
        return cls._primitive(3, "cylinder", point=point, axis=axis, radius=radius, from_=low, to=high)

    @classmethod
    def cone(cls: Type[Made], slope: Any, axis: Any = (0, 0, 1), point: Any = (0, 0, 0), low: Any = None,
             high: Any = None) -> Made:
        """A cone with its apex in `point`, of the radius slope * height; `low` (0) and `high` are multiples of `axis`."""
        return cls._primitive(3, "cone", point=point, axis=axis, slope=slope, from_=low, to=high)

    @classmethod
    def torus(cls: Type[Made], major: Any, minor: Any, axis: Any = (0, 0, 1), point: Any = (0, 0, 0)) -> Made:
        """A torus about `point`, 0 < minor < major."""
        return cls._primitive(3, "torus", point=point, axis=axis, major=major, minor=minor)

    @classmethod
    def capsule(cls: Type[Made], radius: Any, axis: Any, point: Any = None) -> Made:
        """A ball, in the plane a disk, swept from `point`, or the origin, by `axis`."""
        return cls._primitive(len(axis), "capsule", point=[0] * len(axis) if point is None else point, axis=axis, radius=radius)

    @classmethod
    def quadric(cls: Type[Made], coefficients: Any) -> Made:
        """As `polynomial`."""
        return cls.polynomial(coefficients)

    @classmethod
    def polynomial(cls: Type[Made], coefficients: Any) -> Made:
        """The points where a polynomial of degree at most 4 is at most 0: {(2, 0, 1): 3} is 3 x^2 z."""
        terms = dict(coefficients)
        if not terms:
            raise ValueError("a polynomial has at least one coefficient")
        named = {",".join(map(str, powers)): value for powers, value in terms.items()}
        return cls._expressed(len(next(iter(terms))), {"polynomial": named})

    @classmethod
    def polygon(cls: Type[Made], points: Any, holes: Any = None, extrude: Any = None, revolve: bool = False,
                scale: Any = None) -> Made:
        """A polygon in the plane; with two heights `extrude` a prism, whose top the two factors
        `scale` scale, with `revolve` the solid whose points have their
        distance from the z axis and their height in the polygon."""
        return cls._primitive(2 if extrude is None and not revolve else 3, "polygon", points=points, holes=holes, extrude=extrude,
                              revolve=1 if revolve else None, scale=scale)

    @classmethod
    def polyhedron(cls: Type[Made], points: Any, faces: Any) -> Made:
        """A closed polyhedron of its points and, for each face, their numbers from 0 in a row around it."""
        return cls._primitive(3, "polyhedron", points=points, faces=faces)

    def _operand(self) -> Node:
        if self._node is None:
            raise TypeError("only curved solids made by constructors, or from a dict or JSON text, have operators")
        return self._node

    def _joined(self: Made, operation: str, other: Any) -> Made:
        """A chain of one operation is one node."""
        if not isinstance(other, Expressions):
            return NotImplemented
        if self.dimension != other.dimension:
            raise ValueError(f"one solid is in E^{self.dimension}, the other in E^{other.dimension}")
        first, second = self._operand(), other._operand()
        chain = first[operation] if set(first) == {operation} else [first]
        return type(self)._expressed(self.dimension, {operation: [*chain, second]}, lazily=True)

    def __or__(self: Made, other: Any) -> Made:
        """The union."""
        return self._joined("union", other)

    def __and__(self: Made, other: Any) -> Made:
        """The intersection."""
        return self._joined("intersection", other)

    def __sub__(self: Made, other: Any) -> Made:
        """The solid without another."""
        return self._joined("difference", other)

    def moved(self: Made, matrix: Any) -> Made:
        """The image by an invertible affine map: d rows of d + 1 numbers, or the square matrix with the last row 0 ... 0 1."""
        d = self.dimension
        rows = [list(row) for row in matrix]
        if len(rows) == d + 1 and rows[d] == [0] * d + [1]:
            rows.pop()
        return type(self)._expressed(d, {"affine": {"matrix": rows, "of": self._operand()}})

    def named(self: Made, name: str) -> Made:
        """This solid with a name, which cells of a primitive have."""
        return type(self)._expressed(self.dimension, {**self._operand(), "name": name})
