/* The germ of a solid at a point of the trajectory: the surfaces through the point, and the
 * patterns of signs that they have arbitrarily near it. SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The point is in the interior, outside or on the boundary iff the expression is true, false or
 * both over the patterns that occur (proofs/curved.md C95).
 */
#ifndef GRAZE_CURVED_SIGN_GERM_H
#define GRAZE_CURVED_SIGN_GERM_H

#include "decide/curved/taylor.h"

/** A set of patterns: bit s is pattern s, in which surface k is negative iff bit k of s is set. */
typedef struct pattern_set {
    uint64_t word[CSG_TABLE_WORDS];
} pattern_set;

int pattern_has(const pattern_set *set, unsigned pattern);
void pattern_add(pattern_set *set, unsigned pattern);

typedef struct sign_germ {
    moment_field *f;
    int dimension, count;
    const trajectory *c;
    const csg_surface *surface[CSG_FREE_MOST];
    taylor member[CSG_FREE_MOST]; /* their expansions */
    pattern_set truth;            /* of the expression */
    pattern_set seen;             /* patterns that are known to occur, */
    pattern_set never;            /* and not to occur */
    int near_in, near_out;        /* the interior, and the exterior, come arbitrarily near */
} sign_germ;

/** Begin a germ: its members are the expansions of surfaces at the point; no pattern is known. */
void germ_init(sign_germ *g, moment_field *f, const trajectory *c, const csg *solid,
               const size_t *surface, int count);
void germ_clear(sign_germ *g);

/** The number of patterns of the members, 2^count. */
unsigned germ_patterns(const sign_germ *g);

/** The state I, B or O, if the known patterns decide it, else ABSENT. */
graze_state germ_settled(const sign_germ *g);

/** Is the gradient of a member not zero? */
int germ_is_smooth(const sign_germ *g, int k);

/** Exclude all patterns that equal `want` at the members of `mask`. */
void germ_exclude(sign_germ *g, unsigned mask, unsigned want);

#endif
