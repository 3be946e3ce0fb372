/* The expression of a curved solid where some surfaces vanish: what it depends on.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CURVED_TRUTH_H
#define GRAZE_CURVED_TRUTH_H

#include "decide/curved/state.h"

/** Signs of all surfaces, and room to evaluate the expression. */
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

/** Surfaces at which the expression was asked. */
typedef struct dependence {
    graze_state state;   /* I or O whatever their signs; else ABSENT */
    const size_t *asked; /* borrowed */
    size_t asked_count;
    int too_many; /* more than CSG_FREE_MOST: nothing below is set */
    int count;
    size_t surface[CSG_FREE_MOST]; /* on which it depends */
    pattern_set truth;             /* over their signs */
} dependence;

/** Ask for all signs of some surfaces, the others as they are in e->sign, which stays. */
graze_status expression_ask(dependence *out, expression *e, const size_t *surface, size_t count);

#endif
