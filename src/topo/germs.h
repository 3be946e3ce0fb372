/* The contacts of a trajectory to first order: what each covers of the directions about the point.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_GERMS_H
#define GRAZE_TOPO_GERMS_H

#include "scene/scene.h"
#include "topo/cone.h"

/** A side of a time of contact on which the trajectory leaves the cell it is in. */
typedef struct germ_side {
    fmpz e[3];    /* its leading direction modulo the directions of the cell */
    int straight; /* what it covers is exactly the closed cone that is swept along e */
} germ_side;

/** A rational time of contact: the cone there, and how directions about P are carried to it. */
typedef struct germ {
    local_cone cone;
    fmpz to_body[9];
    int side_count;
    germ_side side[2];
} germ;

/** `bounded`: every direction near which there are points of the closed sweep as near to P as one
 * likes is covered by the germs; else `reason` says what may cover more. */
typedef struct germ_list {
    size_t count, capacity;
    germ *item;
    int bounded;
    const char *reason;
} germ_list;

void germs_init(germ_list *list);
void germs_clear(germ_list *list);

/** The germs of all contacts of a point (proofs/topology.md C46). */
graze_status germs_find(germ_list *list, graze_context *context, const graze_scene *scene,
                        const plane_list *planes, const fmpq *point);

/** What the germs say about a direction. */
typedef struct germ_cover {
    int open;    /* it is covered, and so is a neighbourhood */
    int exact;   /* it lies in a closed cone that is covered */
    int covered; /* it lies in a cone that holds all that is covered */
} germ_cover;

graze_status germs_cover(germ_cover *out, germ_list *list, graze_context *context,
                         const fmpz *direction);

#endif
