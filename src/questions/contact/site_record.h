/* Record of a site.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CONTACT_SITE_RECORD_H
#define GRAZE_CONTACT_SITE_RECORD_H

#include "decide/trace/trace.h"
#include "graze/contact.h"
#include "questions/contact/flow.h"
#include "questions/contact/neighborhood.h"

/** A side of t: the motion's piece there and the parameter of t in it. Not `present` beyond an end
 * of the motion. Where one piece is on both sides, the flow of the side before is that of both. */
typedef struct site_side {
    int present;
    size_t piece;
    fmpq_t u;
    flow flow;
} site_side;

/** A facet through y on one side of t: the speed g, the drift, its derivative by t at fixed y, the
 * second derivative theta of the pullback by t, with the primitive outward normal; and order and
 * sign of the pullback next to t, 0 and GRAZE_ORDER_VANISHES where it vanishes. */
typedef struct site_germ {
    size_t facet; /* of place.facet */
    int side;     /* -1 before t, +1 after it */
    fmpq_t speed, drift, theta;
    int order, sign;
} site_germ;

/** Sides before and after t. Germs stand facet by facet, before t first. `is_break`: two different
 * pieces meet at t. `near` and `near_in` are NULL where there is none; each is owned, or a time of
 * the trace. `shift` counts where `snapped`; where that is `missed` too, the cell of the facts has
 * no contact, and of the rest t, y, world and sides alone are known. */
struct graze_site {
    const graze_scene *scene;
    int dimension, is_break;
    neighborhood place;
    site_side side[2];
    fmpq_t t;
    fmpq *y, *world;
    size_t germ_count;
    site_germ *germ;
    graze_trace trace;
    graze_time *itself;
    const graze_time *near, *near_in;
    graze_site_facts facts;
    int snapped, missed;
    fmpq_t shift;
};

#endif
