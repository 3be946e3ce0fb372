"""Two solids, one moving or both: runs of `graze collide`, and what their answers are compared with.

SPDX-License-Identifier: GPL-3.0-or-later

A Trace is the state of a pair over time, as the second methods of this folder find it: `times` are Roots from the
motion's start to its end, `at[k]` is the letter at times[k], `between[k]` that of the gap up to times[k + 1]. An
interval between two critical times has one letter, and B, where it stands in a gap, stands at both ends too, since
the closed sets meet at a closed set of times and interiors at an open one.
"""
import json
import os
import sys
from itertools import chain, zip_longest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "agree", "lib"))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

from algebra import Root, compare, sort_roots  # noqa: E402
from program import Checks, Graze, merged, options  # noqa: E402,F401  (suites take them from here)
from times import check_canonical, time_is, time_root  # noqa: E402

NAMES = {"vertex": "vertex", "edge": "edge", "face": "facet"}
VERDICTS = (("overlap", "I"), ("touch", "B"), ("clear", "O"))


class Pair:
    """One answer of `graze collide`."""

    def __init__(self, record, status):
        self.record, self.status = record, status
        self.word, self.verdict = record["word"], record["verdict"]
        self.first, self.contacts = record["first"], record["contacts"]

    def times(self):
        return [(c["from"], c["to"]) for c in self.contacts]

    def kinds(self):
        return [c["kind"] for c in self.contacts]

    def cells(self):
        return [cell_pairs(c) for c in self.contacts]


def cell_of(feature):
    (kind, value), *body = feature.items()
    return (kind,) + (tuple(value) if isinstance(value, list) else (value,)) + tuple(k for _, k in body)


def cell_pairs(contact):
    return {(cell_of(c["moving"]), cell_of(c["fixed"])) for c in contact["cells"]}


def exchanged_cells(pairs):
    return {(b, a) for a, b in pairs}


class Collide:
    """Runs of the command; solids and motions are objects with text(), or paths."""

    def __init__(self, args, checks):
        self.graze, self.checks = Graze(args, checks), checks

    def file(self, tag, thing, suffix):
        return thing if isinstance(thing, str) else self.graze.write(tag + suffix, thing.text())

    def ask(self, name, moving, motion, fixed, *flags, motion_of_fixed=None):
        """The answer, or None after a failed check. What every answer must obey is counted here."""
        tag = name.replace(" ", "_").replace("/", "_")
        words = ["collide", self.file(tag + "_moving", moving, getattr(moving, "suffix", "")),
                 self.file(tag, motion, ".json"), self.file(tag + "_fixed", fixed, getattr(fixed, "suffix", ""))]
        if motion_of_fixed is not None:
            words += ["--motion-of-fixed", self.file(tag + "_frame", motion_of_fixed, ".json")]
        out = self.graze.call(*words, "--format", "json", *flags)
        if out.returncode not in (0, 1):
            self.checks.fail(name, *flags, f"exit {out.returncode}: {out.stderr.strip()[:300]}")
            return None
        answer = Pair(json.loads(out.stdout), out.returncode)
        self.consistent(name, answer, flags)
        return answer

    def consistent(self, name, answer, flags):
        """Verdict and status follow from the word; types from the cells; `first` is the first contact."""
        equal, where = self.checks.equal, (name, *flags)
        verdict = next(v for v, letter in VERDICTS if letter in answer.word)
        status = int(verdict == "overlap" or (verdict == "touch" and "overlap" not in flags))
        equal("next" in answer.record, "--first" in flags, *where, "next")
        if "--first" in flags:
            verdict = "meets" if "B" in answer.word else "inside" if "--inside" in flags and answer.word == "O" else verdict
            equal([(c["to"], c["kind"]) for c in answer.contacts], [(None, None)] * ("B" in answer.word), *where, "to, kind")
        equal((answer.verdict, answer.status), (verdict, status), *where, "verdict")
        equal(answer.word, merged(answer.word), *where, "letters twice")
        equal(len(answer.contacts), answer.word.count("B"), *where, "contacts")
        for c in answer.contacts:
            types = [x["type"] for x in c["cells"]]
            equal(types, ["-".join(NAMES[cell_of(x[side])[0]] for side in ("moving", "fixed")) for x in c["cells"]],
                  *where, "types")
            equal(len(cell_pairs(c)), len(c["cells"]), *where, "cells twice")
        if answer.word == "O":
            equal(answer.first, None, *where, "first")
        elif answer.word[0] == "I":
            equal(answer.first and answer.first["cells"], [], *where, "first")
        else:
            equal(answer.first, answer.contacts[0], *where, "first")


# ---------------------------------------------------------------------------------------- traces

class Trace:
    def __init__(self, times, at, between):
        self.times, self.at, self.between = times, at, between

    def word(self):
        return merged("".join(chain.from_iterable(zip_longest(self.at, self.between, fillvalue=""))))

    def contacts(self):
        """(from, to, kind), as Roots, of every maximal interval of B; with the place of `from` in times."""
        out, k, n = [], 0, len(self.times)
        while k < n:
            if self.at[k] != "B":
                k += 1
                continue
            last = k
            while last + 1 < n and self.between[last] == "B":
                last += 1
            left = self.between[k - 1] if k > 0 else None
            right = self.between[last] if last + 1 < n else None
            out.append((self.times[k], self.times[last], kind_of(left, right), k))
            k = last + 1
        return out

    def state(self, root):
        """The letter at any time within the motion."""
        for k, t in enumerate(self.times):
            order = compare(root, t)
            if order == 0:
                return self.at[k]
            if order < 0:
                return self.between[k - 1]
        raise ValueError("a time after the end")

    def refined(self, times):
        """The states at more times, which include those of this trace."""
        at, between, k = [], [], 0
        for t in times:
            if k < len(self.times) and compare(t, self.times[k]) == 0:
                at.append(self.at[k])
                k += 1
            else:
                at.append(self.between[k - 1])
            between.append(self.between[k - 1] if k <= len(self.between) else None)
        return Trace(times, at, between[:-1])


def kind_of(left, right):
    """The kind of a contact by the states beside it, as for points (proofs/semantics.md, 2)."""
    if left and right:
        return "tangency" if left == right else "intersection"
    return "intersection" if "I" in (left, right) else "tangency"


def trace_of(answer, start, end):
    """The Trace that a word with its contacts states."""
    times, at, between = [Root(value=start)], [answer.word[0]], []
    contacts = [(time_root(c["from"]), time_root(c["to"])) for c in answer.contacts]
    for letter, following in zip(answer.word, answer.word[1:] + " "):
        if letter != "B":
            between.append(letter)
            continue
        low, high = contacts.pop(0)
        if compare(low, times[-1]):
            times.append(low)
            at.append("B")
        if compare(low, high):
            between.append("B")
            times.append(high)
            at.append("B")
    if compare(times[-1], Root(value=end)):
        times.append(Root(value=end))
        at.append(answer.word[-1])
    return Trace(times, at, between)


def together(one, other, rule):
    """The letters of two traces joined by a rule at all times."""
    times = sort_roots(one.times + other.times)
    one, other = one.refined(times), other.refined(times)
    return Trace(times, [rule(a, b) for a, b in zip(one.at, other.at)],
                 [rule(a, b) for a, b in zip(one.between, other.between)])


def larger(a, b):
    """The state of a pair whose parts have these two states: I before B before O."""
    return min(a, b, key="IBO".index)


def agrees(checks, answer, trace, *where):
    """Word, times and kinds of an answer are those of a Trace."""
    if not checks.equal(answer.word, trace.word(), *where, "word"):
        return False
    for c, (low, high, kind, _) in zip(answer.contacts, trace.contacts()):
        checks.equal(c["kind"], kind, *where, "kind")
        for name, root in (("from", low), ("to", high)):
            check_canonical(checks, c[name], *where)
            checks.holds(time_is(c[name], root), *where, name, c[name], float(root))
    return True


def cut_off(word, lasts):
    """(word, next) of --first, from the whole word: a contact that lasts is followed by itself, an instant by the next letter."""
    start = word.find("B")
    if word[0] == "I" or start < 0:
        return word[0], None
    return (word[:start + 1], "B") if lasts else (word[:start + 2], word[start + 1:start + 2] or None)


def first_agrees(checks, first, full, *where):
    """An answer of --first against the full one."""
    word, following = cut_off(full.word, full.contacts and full.contacts[0]["from"] != full.contacts[0]["to"])
    if checks.equal((first.word, first.record["next"]), (word, following), *where, "--first word") and "B" in word:
        checks.equal((first.first["from"], cell_pairs(first.first)),
                     (full.first["from"], cell_pairs(full.first)), *where, "--first")
