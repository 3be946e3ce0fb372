/* The surfaces of a curved solid along one piece of a trajectory: polynomials in the local time and
 * their sorted roots. SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CURVED_PULLBACKS_H
#define GRAZE_CURVED_PULLBACKS_H

#include "base/number/algebraic.h"
#include "decide/filter/findings.h"
#include "decide/trace/trajectory.h"
#include "input/csg/csg.h"

/** A surface that vanishes at a time. */
typedef struct zero {
    size_t time, surface; /* time: an index, after pullbacks_set a rank */
} zero;

/** The times are both ends of a window and all roots in it. Times of equal rank r are equal;
 * by_rank[r] is one of them. */
typedef struct pullbacks {
    graze_context *context;
    const csg *solid;
    fmpz_poly_struct *form; /* by surface; set for those that are asked */
    size_t *asked;
    size_t asked_count, asked_capacity;
    algebraic_list time;
    algebraic **by_rank;
    size_t rank_count;
    zero *zero; /* by rank */
    size_t zero_count, zero_capacity;
    size_t *slide; /* surfaces that contain the whole piece */
    size_t slide_count;
} pullbacks;

/** @return GRAZE_ESYSTEM; pullbacks_clear in either case */
graze_status pullbacks_init(pullbacks *p, graze_context *context, const csg *solid);
void pullbacks_clear(pullbacks *p);

/** The pullback of one surface. @return GRAZE_ESYSTEM */
graze_status pullback_surface(fmpz_poly_t out, graze_context *context, const trajectory *c,
                              const csg_surface *surface);

/** Set the polynomials and roots for a trajectory and a window.
 * @param asked the window's candidates: surfaces, perhaps with duplicates */
graze_status pullbacks_set(pullbacks *p, const trajectory *c, const exact_window *window,
                           const candidate *asked);

#endif
