/* Germs: a trajectory's contacts with the solid to first order.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_GERM_H
#define GRAZE_TOPO_GERM_H

#include "base/number/algebraic.h"
#include "input/motion/motion.h"
#include "questions/topo/cone.h"

/** The times just before or just after a contact, where the trajectory leaves the boundary cell
 * that it is in at the contact (proofs/topology.md C46, C51, C52). */
typedef struct germ_side {
    int sign;  /* 1 after the contact, -1 before it */
    fmpz e[3]; /* the trajectory's leading direction, modulo directions along the cell */
    slong order;
    int exact;     /* the cover by this side is exactly the closed cone swept along e */
    int has_later; /* e runs along an edge that leaves the vertex, and `later` leaves the edge */
    fmpz later[3];
    int edge_way;   /* the opposite of e is covered with a neighbourhood */
    int keeps_edge; /* d = 3: the cover does not depend on the motion along the cell, an edge */
} germ_side;

/** Data of a germ at an irrational time: the time, and the trajectory's distances from the cone's
 * planes as functions of time, differentiated up to the order of the sides. */
typedef struct germ_root {
    algebraic time;
    size_t count;
    fmpz_poly_struct *way;
} germ_root;

/** A time of contact: the local cone at the trajectory's place, and the linear map from directions
 * about P to directions of the body. */
typedef struct germ {
    local_cone cone;
    const point_map *map; /* of the piece */
    int has_time;
    fmpq time; /* the piece's parameter, if it is rational */
    fmpz to_body[9];
    germ_root *root; /* NULL if all other members are exact; else they are approximate and prove no
                        cover */
    int exact;       /* the planes of the cone keep their directions on the piece */
    int side_count;
    germ_side side[2];
    int covers_edge; /* d = 3: both directions of the cell, an edge, have covered neighbourhoods */
} germ;

/** Parts of a germ: all of it; the solid at the time itself; or, as the number of a side, the cover
 * by that side. */
enum { GERM_WHOLE = -2, GERM_REST = -1 };

/** An interval of time in which the solid turns and the trajectory remains in one boundary cell. */
typedef struct turning_stretch {
    size_t germ; /* at a time inside it */
    algebraic from, to;
} turning_stretch;

/** All germs of a point P. `bounded`: the germs and turning stretches cover every tangent direction
 * of the closed sweep at P (a limit of directions to its points that tend to P); else `reason`
 * names what may cover more. */
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

/** Append a germ on a piece; its other members are zeros. */
graze_status germs_append(germ **out, germ_list *list, graze_context *context,
                          const point_map *map);

/** Remove the last germ. */
void germs_drop_last(germ_list *list);

/** Append a turning stretch between two times, with the last germ inside it. */
graze_status germs_append_turn(germ_list *list, graze_context *context, const algebraic *from,
                               const algebraic *to);

/** Allocate a germ's root at a time, with zeros as polynomials. */
graze_status germ_make_root(germ *g, graze_context *context, const algebraic *time);
/** Free a germ's root. */
void germ_drop_root(germ *g);

/** Clear `bounded` for a reason. */
void germs_leave_open(germ_list *list, const char *reason);

#endif
