"""Generated query points.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import ctypes
import itertools
from typing import Any, Iterator, List, Mapping, Optional, Set

from ._abi import C
from ._context import Context
from ._library import Handle, library
from ._numbers import Rationals, whole
from ._traces import cell_of
from .errors import UseError
from .results import Pmc, Sample


def strata() -> List[str]:
    """The names of all strata."""
    names: List[str] = []
    while True:
        name = library().graze_stratum_name(len(names))
        if name is None:
            return names
        names.append(name.decode())


def samples(context: Context, scene: Handle, dimension: int, rows: range, seed: int,
            weights: Optional[Mapping[str, int]], representable: bool) -> Iterator[Sample]:
    """The samples of these rows of distinct points, one after the other; fewer where no others are
    found. Raises UseError before the first."""
    names = strata()
    for key in weights or {}:
        if key not in names:
            raise UseError(f"there is no stratum {key!r}; expected one of {', '.join(names)}")
    chosen = None
    if weights is not None:
        given = [whole(f"weight of {name}", weights.get(name, 0), 0, 2 ** 64 - 1) for name in names]
        chosen = (ctypes.c_ulong * len(names))(*given)
    pointer = ctypes.c_void_p()
    context.run(library().graze_generator_create, ctypes.byref(pointer), context.pointer,
                scene.pointer, whole("seed", seed, 0, 2 ** 64 - 1), chosen, C.GRAZE_GENERATE_REPRESENTABLE if representable else 0)
    generator = Handle(pointer, library().graze_generator_destroy, scene)
    return itertools.islice(_distinct(_each(context, generator, dimension, names)), rows.start, rows.stop)


def _distinct(made: Iterator[Sample]) -> Iterator[Sample]:
    """After a point that repeats, the next one of its stratum, so that each keeps its share."""
    # Repeated points in a row after which a stratum, and after which all of them, are given up;
    # points passed over for another one of a stratum.
    most_tries, most_repeated, most_passed = 20, 2000, 1000
    seen: Set[Any] = set()
    spent: Set[str] = set()
    wanted, tries, passed, idle = None, 0, 0, 0
    for sample in made:
        stratum = "rounded" if sample.stratum.startswith("rounded-") else sample.stratum
        passed += wanted not in (None, stratum)
        if passed == most_passed:
            wanted, passed = None, 0
        if wanted not in (None, stratum):
            continue
        if sample.point not in seen:
            wanted, idle = None, 0
            seen.add(sample.point)
            yield sample
            continue
        tries, passed, idle = tries + 1 if wanted else 1, 0, idle + 1
        if tries == most_tries:
            spent.add(stratum)
        wanted = None if stratum in spent else stratum
        if idle == most_repeated:
            return


def _each(context: Context, generator: Handle, dimension: int,
          names: List[str]) -> Iterator[Sample]:
    numbers, made = Rationals(dimension + 1), C.graze_sample()
    for row in itertools.count():
        context.run(library().graze_generator_point, numbers.address, numbers.at(dimension),
                    ctypes.byref(made), context.pointer, generator.pointer, row, brief=True)
        cell = cell_of(made.cell)
        name = names[made.stratum]
        rounded = name == "rounded"
        yield Sample(tuple(numbers[k] for k in range(dimension)),
                     f"rounded-{names[made.origin]}" if rounded else name,
                     numbers[dimension] if cell else None, cell, made.order, made.k,
                     bool(made.outward), made.decade if name == "level" else None,
                     Pmc(made.pmc) if rounded else None)
