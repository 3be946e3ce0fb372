/* curved: the contacts and the word of a trajectory through a curved solid, by the patterns of
 * signs that occur near its points.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_DECIDE_CURVED_H
#define GRAZE_DECIDE_CURVED_H

#include <flint/fmpq_poly.h>
#include "base/number/algebraic.h"
#include "decide/scene/scene.h"
#include "decide/trace/trace.h"
#include "input/csg/csg.h"

/** An element of a moment_field: a polynomial in u, reduced by the modulus. */
typedef fmpq_poly_struct value;

/** A set of patterns: bit s is pattern s, in which surface k is negative iff bit k of s is set. */
typedef struct pattern_set {
    uint64_t word[CSG_TABLE_WORDS];
} pattern_set;

int pattern_has(const pattern_set *set, unsigned pattern);

/* The trace of a point through a curved solid (proofs/curved.md). */

/** Trace a point as trace_point does, through a curved solid. Where no rule decides a state, the
 * trace is undecided and its word has a `?`.
 * @return GRAZE_ELIMIT, GRAZE_ECANCELED, GRAZE_ESYSTEM, GRAZE_EINTERNAL */
graze_status curved_trace(graze_trace *out, graze_context *context, const graze_scene *scene,
                          query_point point, trace_detail detail);

/** The pullback of one surface along a piece of a trajectory, a polynomial in the local time.
 * @return GRAZE_ESYSTEM */
graze_status pullback_surface(fmpz_poly_t out, graze_context *context, const trajectory *c,
                              const csg_surface *surface);

/* The expression of a curved solid where some surfaces vanish, as a function of their signs. */

/** Signs of all surfaces, and scratch memory to evaluate the expression. */
typedef struct expression {
    const csg *solid;
    graze_context *context;
    signed char *sign;
    uint64_t *work;
    size_t room;
} expression;

/** Begin with all signs 1; the caller calls expression_clear, also on failure. @return
 * GRAZE_ESYSTEM */
graze_status expression_init(expression *e, graze_context *context, const csg *solid);
void expression_clear(expression *e);

/** The asked surfaces on whose signs the expression depends. */
typedef struct dependence {
    graze_state state;   /* I or O if the expression depends on no sign, else ABSENT */
    const size_t *asked; /* borrowed */
    size_t asked_count;
    int too_many; /* more than CSG_FREE_MOST surfaces are asked; nothing below is set */
    int count;
    size_t surface[CSG_FREE_MOST]; /* the surfaces it depends on */
    pattern_set truth;             /* patterns of their signs for which it is true */
} dependence;

/** Evaluate the expression for all signs of some surfaces; the other surfaces have the signs in
 * e->sign, which is unchanged. */
graze_status expression_ask(dependence *out, expression *e, const size_t *surface, size_t count);

#endif
