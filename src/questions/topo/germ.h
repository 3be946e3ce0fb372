/* One time of contact to first order, and the list of all of a trajectory.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_GERM_H
#define GRAZE_TOPO_GERM_H

#include "base/number/algebraic.h"
#include "input/motion/motion.h"
#include "questions/topo/cone.h"

/** A side of a time of contact on which the trajectory leaves the cell it is in
 * (proofs/topology.md C46, C51, C52). */
typedef struct germ_side {
    int sign;  /* 1 after the time, -1 before it */
    fmpz e[3]; /* its leading direction modulo the directions of the cell */
    slong order;
    int exact;     /* what it covers is exactly the closed cone that is swept along e */
    int has_later; /* e runs along an edge that leaves the vertex, and `later` leaves the edge */
    fmpz later[3];
    int edge_way;   /* the opposite of e is covered with a neighbourhood */
    int keeps_edge; /* d = 3: what it covers does not depend on the way along the cell's edge */
} germ_side;

/** Further data of a germ at an irrational time: the time, and the trajectory's distances from the
 * planes of the cone, differentiated up to the order of its sides. */
typedef struct germ_root {
    algebraic time;
    size_t count;
    fmpz_poly_struct *way;
} germ_root;

/** A time of contact: the cone there, and how directions about P are carried to it. */
typedef struct germ {
    local_cone cone;
    const point_map *map; /* of the piece */
    int has_time;
    fmpq time; /* on the piece, if it is rational */
    fmpz to_body[9];
    germ_root *root; /* NULL if all else is exact; else that is near it, and covers nothing */
    int exact;       /* the planes of the cone keep their directions on the piece */
    int side_count;
    germ_side side[2];
    int covers_edge; /* d = 3: both directions of the cell, an edge, are covered near them */
} germ;

/** Parts of a germ: what the solid covers at its time, with what it sweeps on both sides, or, with
 * the number of a side, on that one. */
enum { GERM_WHOLE = -2, GERM_REST = -1 };

/** A stretch during which the solid turns while the trajectory stays in one cell. */
typedef struct turning_stretch {
    size_t germ; /* at a time in it */
    algebraic from, to;
} turning_stretch;

/** `bounded`: every direction near which there are points of the closed sweep as near to P as one
 * likes is covered by the germs or in a turning stretch; else `reason` says what may cover more. */
typedef struct germ_list {
    size_t count, capacity;
    germ *item;
    size_t turn_count, turn_capacity;
    turning_stretch *turn;
    int bounded;
    const char *reason;
} germ_list;

void germs_init(germ_list *list);
void germs_clear(germ_list *list);

/** A new germ on a piece, else zeros. */
graze_status germs_append(germ **out, germ_list *list, graze_context *context,
                          const point_map *map);

/** Take the germ made last away. */
void germs_drop_last(germ_list *list);

/** A new turning stretch between two times, about the germ made last. */
graze_status germs_append_turn(germ_list *list, graze_context *context, const algebraic *from,
                               const algebraic *to);

/** Give a germ a root, with zeros. */
graze_status germ_make_root(germ *g, graze_context *context, const algebraic *time);
/** Take it away again. */
void germ_drop_root(germ *g);

/** The germs no longer bound what is covered. */
void germs_leave_open(germ_list *list, const char *reason);

#endif
