/* The expression of a curved solid where some surfaces vanish, as a function of their signs.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CURVED_TRUTH_H
#define GRAZE_CURVED_TRUTH_H

#include "decide/curved/state.h"

/** Signs of all surfaces, and scratch memory to evaluate the expression. */
typedef struct expression {
    const csg *solid;
    graze_context *context;
    signed char *sign;
    uint64_t *work;
    size_t room;
} expression;

/** Signs are 1 at first. @return GRAZE_ESYSTEM; expression_clear in either case */
graze_status expression_init(expression *e, graze_context *context, const csg *solid);
void expression_clear(expression *e);

/** The surfaces, of those asked, on whose signs the expression depends. */
typedef struct dependence {
    graze_state state;   /* I or O if it does not depend on any sign, else ABSENT */
    const size_t *asked; /* borrowed */
    size_t asked_count;
    int too_many; /* it depends on more than CSG_FREE_MOST: the members below are not set */
    int count;
    size_t surface[CSG_FREE_MOST]; /* the surfaces it depends on */
    pattern_set truth;             /* over their signs */
} dependence;

/** Evaluate the expression for all signs of some surfaces; the other surfaces have the signs in
 * e->sign, which is unchanged. */
graze_status expression_ask(dependence *out, expression *e, const size_t *surface, size_t count);

#endif
