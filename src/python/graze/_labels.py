"""Labels that classifiers return, as words, and which of them are wrong.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

from numbers import Integral, Real
from typing import Any, List, Mapping, NamedTuple, Optional

from .errors import UseError
from .results import PMC_NAMES, Pmc

WORDS = ("in", "on", "out")
ON_AS = ("on", "any", "in", "out")


class Labels(NamedTuple):
    """Labels of one kind: `words`, `Booleans`, `integers` or `distances`."""

    kind: str
    values: List[Any]
    words: List[str]

    @property
    def default_on(self) -> str:
        """The convention for `on` points where none is named: who cannot say `on` may say anything."""
        return "any" if self.kind in ("Booleans", "distances") else "on"


def is_wrong(exact: str, given: str, on: str) -> bool:
    """Is a label wrong under a convention for `on` points, as `graze compare --on-as` has them?"""
    if on == "any" and exact == "on":
        return False
    if on in ("in", "out"):
        exact, given = (on if exact == "on" else exact), (on if given == "on" else given)
    return exact != given


def read_labels(given: Any, mapping: Optional[Mapping[Any, str]]) -> Labels:
    """Labels as words. Raises UseError for what is none, with its index."""
    if hasattr(given, "tolist"):
        given = given.tolist()
    try:
        values = [value.item() if hasattr(value, "item") else value for value in given]
    except TypeError:
        raise UseError(f"classify returned a {type(given).__name__}; expected labels, one for each point") from None
    for value, word in (mapping or {}).items():
        if word not in WORDS:
            raise UseError(f"labels: {value!r} stands for {word!r}; expected in, on or out")
    if mapping is not None:
        return Labels("words", values, [_mapped(k, value, mapping) for k, value in enumerate(values)])
    kinds = [_kind(k, value) for k, value in enumerate(values)]
    if len(set(kinds)) > 1:
        other = next(k for k, kind in enumerate(kinds) if kind != kinds[0])
        raise UseError(f"labels[{other}] is {values[other]!r}, labels[0] is {values[0]!r}; expected labels of one kind")
    kind = kinds[0] if kinds else "words"
    words = [_word(k, value, kind) for k, value in enumerate(values)]
    if kind == "integers" and 1 in values and -1 not in values and 0 in values:
        raise UseError("labels are the integers 0 and 1 alone; expected Booleans, or -1 (in), 0 (on), 1 (out), or "
                       "labels= with the word of each, such as {1: 'in', 0: 'out'}")
    return Labels(kind, values, words)


def _mapped(k: int, value: Any, mapping: Mapping[Any, str]) -> str:
    try:
        return mapping[value]
    except (KeyError, TypeError):
        raise UseError(f"labels[{k}] is {value!r}; expected one of {', '.join(map(repr, mapping))}") from None


def _kind(k: int, value: Any) -> str:
    if isinstance(value, (str, Pmc)):
        return "words"
    if isinstance(value, bool):
        return "Booleans"
    if isinstance(value, Integral):
        return "integers"
    if isinstance(value, Real):
        return "distances"
    raise UseError(f"labels[{k}] is {value!r}; expected in, on or out, a Boolean, -1, 0 or 1, or a signed distance")


def _word(k: int, value: Any, kind: str) -> str:
    if kind == "Booleans":
        return "in" if value else "out"
    if kind == "words":
        word = PMC_NAMES[value] if isinstance(value, Pmc) else value
        if word in WORDS:
            return str(word)
        raise UseError(f"labels[{k}] is {value!r}; expected in, on or out")
    if kind == "integers" and value not in (-1, 0, 1):
        raise UseError(f"labels[{k}] is {value}; expected -1 (in), 0 (on) or 1 (out)")
    if value != value:
        raise UseError(f"labels[{k}] is {value}; expected a signed distance")
    return "in" if value < 0 else "out" if value > 0 else "on"
