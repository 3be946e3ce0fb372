/* Pieces of curves, their sides, and the complex that the boundary's pieces form.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_QUESTIONS_OUTLINE_COMPLEX_H
#define GRAZE_QUESTIONS_OUTLINE_COMPLEX_H

#include "questions/outline/arcs.h"
#include "questions/outline/outline.h"
#include "questions/outline/bracket.h"

/** Make all pieces, and find those that are one point set (proofs/outline.md C134). */
graze_status outline_pieces(graze_outline *o, graze_context *context);

/** Decide for each piece whether it is boundary, with its sides, or a lower part (C135). */
graze_status outline_sides(graze_outline *o, graze_context *context);

/** Find the points at which boundary pieces end, each once (C136). */
graze_status outline_points(graze_outline *o, graze_context *context);

/** Are two points, whose places meet, one point? */
graze_status points_equal(int *out, graze_outline *o, graze_context *context, outline_point *a,
                          outline_point *b);

/** The cuts at the ends of a piece. */
algebraic *piece_end(const graze_outline *o, const outline_piece *p, int end);
/** Is a number strictly between two others? */
graze_status number_between(int *out, graze_context *context, algebraic *low, algebraic *x,
                            algebraic *high);
/** A rational parameter within a piece. */
graze_status piece_middle(fmpq_t s, graze_context *context, const graze_outline *o,
                          const outline_piece *p);
/** The rational point of a curve that is not slanted. */
void outline_curve_at(fmpq *point, const outline_curve *c, const fmpq_t s);

/** The form of a slanted curve where its parameter is s, as a polynomial of the other coordinate.
 */
void slant_section(fmpz_poly_t out, const graze_outline *o, const outline_curve *c, const fmpq_t s);
/** The other coordinate of a slanted curve where its parameter is s. */
graze_status slant_other(bracket *out, graze_context *context, outline_curve *c, const fmpq_t s,
                         ulong places);

/* The order of pieces about a point, and walks. */

/** For each boundary end, numbered 2 piece + end: the next end counter-clockwise about its point.
 */
typedef struct turn_order {
    size_t *next; /* of each end of a piece */
    size_t *previous;
} turn_order;

/** Find the order of the pieces about all points (C137). The caller frees both arrays. */
graze_status outline_turns(turn_order *out, graze_outline *o, graze_context *context);

/** Join boundary pieces to arcs. */
graze_status outline_arcs(graze_outline *o, graze_context *context, const turn_order *turns);

/** Walk along the arcs through the interior and through the complement (C138). */
graze_status outline_walks(graze_outline *o, graze_context *context, const turn_order *turns);

/** Find areas and lengths of all arcs, rings and walks, and of the whole (C139). */
graze_status outline_measures(graze_outline *o, graze_context *context);
/** A number of no arcs, and its memory. */
void measure_init(outline_measure *m);
void measure_clear(outline_measure *m);

/** Tell holes from other rings, find the ring around each, and count components (C138). */
graze_status outline_nesting(graze_outline *o, graze_context *context);

/** Find isolated lower points (C140). */
graze_status outline_spots(graze_outline *o, graze_context *context);

#endif
