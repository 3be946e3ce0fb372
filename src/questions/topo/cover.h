/* Cover of directions about the point by germs.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_COVER_H
#define GRAZE_TOPO_COVER_H

#include "questions/topo/germ.h"

/** Statements about a direction; each is 1 if it is proved, `covered` is 0 if its opposite is. */
typedef struct germ_cover {
    int open;     /* the direction has a neighbourhood that is covered, to first order */
    int edge_way; /* it has one by a trajectory's way through a pinch or along an edge */
    int exact;    /* it lies in a closed cone that is covered */
    int covered;  /* it lies in a closed cone that bounds the cover */
} germ_cover;

/** Add the cover of a direction of its body by one germ: by all sides or, if `keeping_edge`, only
 * by sides that keep the edge. */
graze_status germ_cover_body(germ_cover *out, germ *g, graze_context *context, const fmpz *u,
                             int keeping_edge);

/** Add the cover of a direction about the point by a part of a germ. */
graze_status germ_cover_part(germ_cover *out, germ *g, graze_context *context,
                             const fmpz *direction, int part);

/** Find how all germs together cover a direction about the point. */
graze_status germs_cover(germ_cover *out, germ_list *list, graze_context *context,
                         const fmpz *direction);

#endif
