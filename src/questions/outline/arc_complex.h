/* Pieces of curves, their sides, and the complex that the boundary's pieces form.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_QUESTIONS_OUTLINE_COMPLEX_H
#define GRAZE_QUESTIONS_OUTLINE_COMPLEX_H

#include "decide/verdict/verdict.h"
#include "questions/outline/arcs.h"

/** Make all pieces, and find those that are one point set (proofs/outline.md C137). */
graze_status outline_pieces(graze_outline *o, graze_context *context);

/** Decide for each piece whether it is boundary, with its sides, or a lower part (C138). */
graze_status outline_sides(graze_outline *o, graze_context *context);

/** Find the points at which boundary pieces end, each once (C139). */
graze_status outline_points(graze_outline *o, graze_context *context);

/** A point at a cut, without its place, and its memory. */
void outline_point_init(outline_point *p, size_t curve, size_t cut);
void outline_point_clear(outline_point *p);
/** Are two points, whose places meet, one point? */
graze_status points_equal(int *out, graze_outline *o, graze_context *context, outline_point *a,
                          outline_point *b);

/** The cuts at the ends of a piece. */
algebraic *piece_end(const graze_outline *o, const outline_piece *p, int end);
/** Is a piece boundary or a lower part? */
static inline int piece_has_ends(const outline_piece *p) {
    return p->turn || p->lower == 1;
}
/** A rational parameter within a piece. */
graze_status piece_middle(fmpq_t s, graze_context *context, const graze_outline *o,
                          const outline_piece *p);

/** Append the parameters strictly between two at which a coordinate passes a rational value. */
graze_status outline_crossings(algebraic_list *out, const graze_outline *o, graze_context *context,
                               outline_curve *c, algebraic *from, algebraic *to, int axis,
                               const fmpq_t value);
/** The sign of a coordinate at a parameter, minus a rational value. */
graze_status outline_side(int *out, const graze_outline *o, graze_context *context,
                          outline_curve *c, algebraic *s, int axis, const fmpq_t value);
/** The binary places of about a sixteenth of a size, not more than 1. */
ulong first_places(double size);
/** The membership of a rational point. */
graze_status outline_pmc(graze_pmc *out, const graze_outline *o, graze_context *context,
                         const fmpq *point, trace_detail detail);

/* The order of pieces about a point, and walks. */

/** For each boundary end, numbered 2 piece + end: the next end counter-clockwise about its point.
 */
typedef struct turn_order {
    size_t *next; /* of each end of a piece */
    size_t *previous;
} turn_order;

/** Find the order of the pieces about all points (C140). The caller frees both arrays. */
graze_status outline_turns(turn_order *out, graze_outline *o, graze_context *context);

/** Join boundary pieces to arcs. */
graze_status outline_arcs(graze_outline *o, graze_context *context, const turn_order *turns);

/** Walk along the arcs through the interior and through the complement (C141). */
graze_status outline_walks(graze_outline *o, graze_context *context, const turn_order *turns);

/** The cuts at which an arc begins and ends on its curve, the lower one first. */
void outline_arc_ends(algebraic **end, const graze_outline *o, const outline_arc *arc);
static inline int outline_is_straight(const graze_outline *o, const outline_curve *c) {
    return c->slant || o->equation[c->equation].degree == 1;
}
/** An exponent of 2, at least 0: the boundary's coordinates are less than its power. */
int outline_exponent(const graze_outline *o);
/** Find areas and lengths of all arcs, rings and walks, and of the whole (C142). */
graze_status outline_measures(graze_outline *o, graze_context *context);
/** A number of no arcs, and its memory. */
void measure_init(outline_measure *m);
void measure_clear(outline_measure *m);

/** Tell holes from other rings, find the ring around each, and count components (C141). */
graze_status outline_nesting(graze_outline *o, graze_context *context);

/** Find isolated lower points (C143). */
graze_status outline_spots(graze_outline *o, graze_context *context);

/* Polygons (C145, C148). Corners are integers of at most 53 bits. */

/** Begin a polygon with edges for all arcs, whose parts are within a distance of them. */
graze_status polygon_parts(outline_polygon *p, const graze_outline *o, graze_context *context,
                           double within);
/** Make room for rings. */
graze_status polygon_rings(outline_polygon *p, size_t count);
/** Append an edge. */
graze_status polygon_edge_add(outline_polygon *p, size_t arc, size_t node);
/** Let an edge begin at a point, rounded. GRAZE_ELIMIT: that has more than 53 bits. */
graze_status polygon_edge_start(const outline_polygon *p, size_t edge, const fmpq *point);
/** The turn from q to r about p: 1 to the left, -1 to the right. */
int polygon_turn(const slong *p, const slong *q, const slong *r);
/** Have two edges, whose boxes meet, more in common than one node? */
int polygon_edges_meet(const outline_polygon *p, const polygon_edge *e, const polygon_edge *f);
/** Visit pairs of edges whose boxes meet: of p, or if there is a q of p and q, whose boxes are
 * larger by `more` on all sides then. */
typedef graze_status polygon_visit(void *state, size_t first, size_t second);
graze_status polygon_pairs(const outline_polygon *p, const outline_polygon *q, slong more,
                           polygon_visit *visit, void *state);
/** Mark edges that have more in common with another one than one node; *clear becomes 0 if there
 * are any. */
graze_status polygon_meetings(int *clear, outline_polygon *p);
/** Find the ring around each hole. */
graze_status polygon_nest(outline_polygon *p);
/** How often a ring goes around the half of x, without the edge `but`. */
int polygon_winding(const outline_polygon *p, size_t first, const slong *x, size_t but);
/** Is the middle of an edge within ring s, which does not pass it? */
int polygon_ring_has(const outline_polygon *p, size_t s, size_t edge);

#endif
