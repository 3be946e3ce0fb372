"""Counts, case, definition and class of a word, straight from [EI] Definitions 3-11 as printed.

SPDX-License-Identifier: GPL-3.0-or-later

Written from the paper's own case lists, searching for the k and j they speak of, not from the
rule with k = (i + ...) / 2 the program is built on. For cases 5, 6, 8 and 9, which the paper
leaves out, k is the number of runs of I in the word without its B's (proofs/claims.md C10).
"""
NAMES = {5: "regular", 6: "fold", 7: "fold_boundary", 8: "boundary", 9: "exterior", 10: "fold",
         11: "fold_boundary"}
PMC = {"regular": "in", "fold": "in", "fold_boundary": "in", "boundary": "on", "exterior": "out"}

# Table 1: (P against S^0, P against S^1) -> case
TABLE = {("O", "O"): 1, ("O", "B"): 2, ("O", "I"): 3, ("B", "O"): 4, ("B", "B"): 5,
         ("B", "I"): 6, ("I", "O"): 7, ("I", "B"): 8, ("I", "I"): 9}


def counts(word):
    """(i_p, t_p): inner contacts by what lies on their two sides, end contacts by Definitions 3
    and 4: does the trajectory next to the contact run in the interior?"""
    crossings = touches = 0
    for k, letter in enumerate(word):
        if letter != "B":
            continue
        before, after = word[:k][-1:], word[k + 1:k + 2]
        if before and after:
            crosses = before != after
        else:
            crosses = "I" in (before, after)
        crossings += crosses
        touches += not crosses
    return crossings, touches


def of_the_form(count, even, least, most):
    """Is count = 2k (even) or 2k - 1 for some least <= k <= most?"""
    return any(count == (2 * k if even else 2 * k - 1) for k in range(least, most + 1))


def holding(word, combined=False):
    """The definitions whose printed conditions the word meets (cases 1, 2, 3, 4, 7)."""
    i, t = counts(word)
    case, many = TABLE[word[0], word[-1]], len(word)
    if case not in (1, 2, 3, 4, 7):
        raise ValueError(word)
    even, out = case in (1, 2, 4), []
    if t == 0 and i == {1: 2, 2: 2, 3: 1, 4: 2, 7: 1}[case]:
        out.append(5)
    if combined:
        if of_the_form(i, even, 2, many) and (t == 0 or t >= 1):
            out.append(10)
        if of_the_form(i, even, 1, 1) and t >= 1:
            out.append(11)
    else:
        if of_the_form(i, even, 2, many) and t == 0:
            out.append(6)
        if of_the_form(i, even, 1, many) and t >= 1:
            out.append(7)
    if case in (1, 2, 4) and i == 0 and t >= 1:
        out.append(8)
    if set(word) == {"O"}:
        out.append(9)
    return out


def runs_of_i(word):
    letters = word.replace("B", "")
    return sum(a == "I" and b != "I" for a, b in zip(letters, letters[1:] + "O"))


def expected(word, combined=False):
    """The fields of a row: case, definition, class, pmc, i, t."""
    i, t = counts(word)
    case = TABLE[word[0], word[-1]]
    if case in (1, 2, 3, 4, 7):
        number, = holding(word, combined)
        name, definition = NAMES[number], str(number)
    else:
        k, definition = runs_of_i(word), "ext"
        if k == 0:
            name = "boundary" if t else "exterior"
        elif combined and k >= 2:
            name = "fold"
        elif t:
            name = "fold_boundary"
        else:
            name = "regular" if k == 1 else "fold"
    return {"case": str(case), "definition": definition, "class": name, "pmc": PMC[name],
            "i": str(i), "t": str(t), "word": word}


def admissible(letters):
    """All words of at most `letters` letters: B's stand alone between letters I and O."""
    out = ["B"]
    for r in range(1, letters // 2 + 2):
        for bits in range(2 ** r):
            core = "B".join("I" if bits >> k & 1 else "O" for k in range(r))
            out += [a + core + b for a in ("", "B") for b in ("", "B")]
    return sorted({w for w in out if len(w) <= letters}, key=lambda w: (len(w), w))
