/* Directions about the point that germs cover.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_COVER_H
#define GRAZE_TOPO_COVER_H

#include "questions/topo/germ.h"

/** Cover of a direction by the germs. */
typedef struct germ_cover {
    int open;     /* it is covered, and so is a neighbourhood */
    int edge_way; /* the same, by the way of a trajectory through a pinch, or along an edge */
    int exact;    /* it lies in a closed cone that is covered */
    int covered;  /* it lies in a cone that holds all that is covered */
} germ_cover;

/** Add what one germ covers of a direction of its body, with all sides or with those alone that
 * keep the edge. */
graze_status germ_cover_body(germ_cover *out, germ *g, graze_context *context, const fmpz *u,
                             int keeping_edge);

/** Add what a part of a germ covers of a direction about the point. */
graze_status germ_cover_part(germ_cover *out, germ *g, graze_context *context,
                             const fmpz *direction, int part);

/** Find how all germs together cover a direction about the point. */
graze_status germs_cover(germ_cover *out, germ_list *list, graze_context *context,
                         const fmpz *direction);

#endif
