/* The germ of a solid at a point of the trajectory: surfaces through the point, and which patterns
 * of their signs occur arbitrarily near it.
 * SPDX-License-Identifier: GPL-3.0-or-later
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
    pattern_set seen;             /* patterns that occur, */
    pattern_set never;            /* and such as do not */
    int near_in, near_out;        /* points of the interior, of the outside, are arbitrarily near */
} sign_germ;

/** Expand the surfaces at the point; the germ has no members, and nothing is known of it yet. */
void germ_init(sign_germ *g, moment_field *f, const trajectory *c, const csg *solid,
               const size_t *surface, int count);
void germ_clear(sign_germ *g);

/** Patterns of the members: 2^count. */
unsigned germ_patterns(const sign_germ *g);

/** I, B or O if what is known decides, else ABSENT. */
graze_state germ_settled(const sign_germ *g);

/** 1 if the gradient of a member is not zero. */
int germ_is_smooth(const sign_germ *g, int k);

/** Patterns that equal `want` at the members of `mask` do not occur. */
void germ_exclude(sign_germ *g, unsigned mask, unsigned want);

#endif
