"""Graze: exact classification of points against the set that a moving solid sweeps.

    >>> import graze
    >>> scene = graze.Scene("cases/bracket/solid.off", "cases/bracket/motion.json")
    >>> trace = scene.trace(["3/5", "29/5", 3])
    >>> trace.word, trace.verdict.class_.name, [float(contact.start) for contact in trace.contacts]
    ('OBOBIBOB', 'FOLD_BOUNDARY', [0.5, 1.1, 1.225, 1.859375])

`Scene.classify` takes many points, arrays of numpy the fastest; `Scene.trace` and `Scene.explain`
say why for one. Nothing is rounded: floats are the dyadic numbers they are, times of contact are
Fractions, or of type `AlgebraicNumber`. The module is pure Python, 3.9 or later, on top of the shared
library libgraze, which is looked for at $GRAZE_LIBRARY, beside the package, in the lib folder it is
installed in, in the build folder of a checkout, and where the dynamic linker looks. numpy and
pandas are used where they are installed.
SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

from . import tools
from ._library import VERSION as __version__
from ._library import library as _load
from ._motions import Joint, slide, turn
from .boundaries import Boundary
from .collisions import CellPair, Closest, Collision, FirstContact, PairContact, collide
from .comparison import Comparison, compare
from .envelopes import Envelope, Event
from .errors import (CanceledError, GrazeError, IllegalError, InputError, InternalError,
                     LibraryError, LimitError, MachineError, UseError)
from .inputs import Motion, Solid
from .judgements import Greatest, Judgement
from .outlines import Outline, OutlineSample, Ring
from .patches import CurvePart, Patch, PatchJoint
from .pictures import Page, Picture, class_colours
from .results import (CLASS_NAMES, ENCLOSURE_DTYPE, PMC_NAMES, VERDICT_DTYPE, Cell, Class, Contact,
                      Enclosure, Pmc, Sample, Topology, Trace, Verdict, class_names, columns,
                      definition_names, pmc_names, to_dataframe)
from .scene import Scene
from .sites import Site, SiteFacet
from .times import AlgebraicNumber, Time, decimal

__all__ = [
    "AlgebraicNumber", "Boundary", "CLASS_NAMES", "CanceledError", "Cell", "CellPair", "Class", "Closest", "Collision",
    "Comparison",
    "Contact", "CurvePart", "ENCLOSURE_DTYPE", "Enclosure", "Envelope", "Event", "FirstContact", "GrazeError", "Greatest", "IllegalError",
    "InputError", "InternalError",
    "Joint", "Judgement", "LibraryError", "LimitError", "MachineError", "Motion", "Outline", "OutlineSample", "PMC_NAMES", "Page", "Patch",
    "PairContact", "PatchJoint", "Picture",
    "Pmc", "Ring", "Sample", "Scene", "Site", "SiteFacet", "Solid", "Time", "Topology", "Trace",
    "UseError", "VERDICT_DTYPE", "Verdict", "__version__", "class_colours", "class_names", "collide", "columns",
    "compare",
    "decimal", "definition_names", "pmc_names", "slide", "to_dataframe", "tools", "turn", "version"]


def version() -> str:
    """Versions of Graze and of the libraries it runs with, one a line."""
    return str(_load().graze_version().decode())
