/* Whether a facet has a contact of order 4 or more, [AMS]'s singular trim points, at a time.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_ENVELOPE_SINGULAR_POINT_H
#define GRAZE_ENVELOPE_SINGULAR_POINT_H

#include "questions/envelope/axis.h"
#include "questions/envelope/envelope_record.h"

/** g, theta and the third derivative at the corners of the facet's first triangle; the products of
 * two of these rows, three each; and the determinant. */
enum {
    SINGULAR_ROWS = 9,
    SINGULAR_MINORS = 9,
    SINGULAR_DETERMINANT = SINGULAR_ROWS + SINGULAR_MINORS,
    SINGULAR_SIGNS
};

/** A facet on one piece of the motion. */
typedef struct singular_view {
    const graze_envelope *e;
    graze_context *context;
    size_t facet, piece;
    fmpz_poly_struct p[SINGULAR_SIGNS];
} singular_view;

/** @param[out] out uninitialised; singular_view_clear after it */
void singular_view_make(singular_view *out, const graze_envelope *e, graze_context *context,
                        size_t facet, size_t piece);
void singular_view_clear(singular_view *v);

/** Has g one strict sign at all corners of the facet, all the time? If it is cheaply seen. */
int singular_is_never(const singular_view *v);

/** Does the determinant vanish all the time? If not, there is such a point at its roots alone. */
int singular_is_lasting(const singular_view *v);

/** Is there such a point in the facet's relative interior at u? */
graze_status singular_exists(int *out, const singular_view *v, algebraic *u);

/** The times at which the answer may change (proofs/events.md C80): all others are between two at
 * which it is the same. @param[out] out uninitialised; axis_clear in any case */
graze_status singular_axis(axis *out, const singular_view *v);

#endif
