/* Facets that are touched over their whole face at once, which a search at sampled times would
 * miss.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_GENERATE_SPECIAL_H
#define GRAZE_GENERATE_SPECIAL_H

#include "decide/scene/scene.h"
#include "questions/generate/instant.h"

/** At `when` the normal velocity is zero on all of the simplex; with `slides`, at all times of the
 * piece. */
typedef struct special {
    instant when;
    size_t simplex;
    int slides;
} special;

typedef struct specials {
    size_t count, capacity;
    special *item;
} specials;

/**
 * Look for them among the planes of the solid: all planes, or evenly spread ones where there are
 * too many. A face that is touched as a whole at an irrational time is not among them.
 */
graze_status specials_find(specials *out, graze_context *context, const graze_scene *scene);
void specials_clear(specials *list);

/** The derivative by u of the pullback of a plane form along the trajectory of P = M(u) y, at u
 * itself: zero where the normal velocity of y is zero. */
void special_velocity(fmpz_poly_t out, const graze_scene *scene, size_t piece, const fmpz *form,
                      const fmpq *y);

/** Rational roots of a polynomial in (0, 1), at most SPECIAL_ROOTS; how many. */
enum { SPECIAL_ROOTS = 40 };
int special_roots(fmpq *out, const fmpz_poly_t p);

#endif
