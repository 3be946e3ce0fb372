/* outline: finds the exact boundary of a planar sweep or unsweep: vertices, arcs, rings, area.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_QUESTIONS_OUTLINE_H
#define GRAZE_QUESTIONS_OUTLINE_H

#include <flint/fmpq.h>
#include <flint/fmpz_mpoly.h>
#include <flint/fmpz_poly.h>
#include "base/number/algebraic.h"
#include "decide/scene/scene.h"
#include "graze/outline.h"
#include "input/motion/motion.h"
#include "input/solid/solid.h"

/** An interval of numbers with binary places that are kept elsewhere (bracket.h). */
typedef struct bracket {
    fmpz_t low, high;
} bracket;

/* Candidates: curves that hold the boundary (proofs/outline.md C134). */

typedef enum curve_source { SOURCE_PATH, SOURCE_EDGE, SOURCE_ENVELOPE } curve_source;
/** Their names: path, edge, envelope. */
extern const char *const curve_source_names[3];

/**
 * A curve: the path of vertex `a`; or the edge from `a` to `b`, at the time `at` of the piece or as
 * its envelope over the piece. Its point at s is (x[0] / x[2], x[1] / x[2])(s), from <= s <= to.
 * The parameter s is the piece's for a path and an envelope. For an edge it runs from 0 at `a` to 1
 * at `b`; at an irrational time it is a coordinate, `axis`. Then, if `slant`, the line is
 * irrational too: it is x[0](u) x + x[1](u) y + x[2](u) = 0 at the time u.
 */
typedef struct outline_curve {
    curve_source source;
    size_t piece, a, b;
    algebraic at;
    int axis, slant; /* axis: 0 or 1; -1 where the parameter is no coordinate */
    fmpz_poly_struct x[3];
    algebraic from, to;
    size_t equation, group;
    int proper;                /* every point that is not singular has one parameter */
    algebraic_list mark;       /* parameters inside at which a status may change */
    algebraic_list cut_number; /* all cuts, with repetitions and in no order */
    size_t cut_count;
    algebraic **cut; /* cuts in order, the ends included */
    box box;
} outline_curve;

/** An irreducible equation of curves, with integer polynomials of one variable whose roots are the
 * coordinates, along `axis`, of points at which all curves of the equation are cut. */
typedef struct outline_equation {
    fmpz_mpoly_t form;
    slong degree;
    int axis;
    size_t curve_count;
    int proper;
    size_t point_count, point_capacity;
    fmpz_poly_struct *point;
} outline_equation;

/** Both coordinates of a point. */
typedef struct point_place {
    bracket xy[2];
} point_place;

/** A part of a curve between neighbouring cuts. */
typedef struct outline_piece {
    size_t curve, cut; /* from cut number `cut` to the next one */
    size_t same;       /* the first piece that is this point set */
    size_t next_same;  /* the next one, or OUTLINE_NONE */
    box box;
    int turn;       /* 1: the set is on the left in the curve's direction; -1: on its right; 0: the
                       piece is no boundary */
    int lower;      /* 1: a lower part; -1: undecided whether it is one */
    fmpq sample[4]; /* ends of its crossing segment: of a boundary the one in the set first */
    size_t end[2];  /* vertices of a boundary piece at its lower and its higher cut */
} outline_piece;

/** A point of the boundary at which pieces end. `reference`: a cut of a curve, which is the point.
 * The coordinates are made when they are asked for. */
typedef struct outline_point {
    size_t curve, cut;
    bracket place[2]; /* with POINT_PLACES places */
    size_t vertex;    /* of the boundary; the index of a point that is the same one */
    int made;
    algebraic coordinate[2];
} outline_point;

enum { POINT_PLACES = 100 };

/** The number of an enclosure: `exact` if `is_exact`, else between both bounds, which have `places`
 * binary places. */
typedef struct outline_measure {
    int is_exact;
    fmpq_t exact;
    bracket bounds;
} outline_measure;

/** Boundary pieces of one curve that follow each other, with the same sources, in the direction
 * that has the set on its left: entries first to first + count - 1 of `arc_piece`. */
typedef struct outline_arc {
    size_t first, count;
    size_t from, to;              /* points */
    outline_measure area, length; /* the integral of (x dy - y dx) / 2 along the arc */
} outline_arc;

/** A closed walk along arcs: entries first to first + count - 1 of `ring_arc`. */
typedef struct outline_ring {
    size_t first, count;
    size_t walk;   /* number of the walk through the set's interior that holds the ring */
    size_t within; /* for a hole: the ring around it; else its own number */
    int hole;
    outline_measure area, length;
} outline_ring;

/** The solid at `count` times, `each` of them in a piece of the motion, from its beginning on:
 * vertices, each within 2^-51 `size`, which no coordinate exceeds, and boxes around all. */
typedef struct covering {
    size_t each, count;
    double *vertex, size;
    box *around;
} covering;

/** `ring`: simple rings. `around`: walks through the complement, after the rings in `ring_arc`. */
struct graze_outline {
    const graze_scene *scene;
    double width; /* relative width of areas and lengths */
    fmpz_mpoly_ctx_t ring_of_forms;
    covering cover;
    size_t curve_count, curve_capacity, equation_count, equation_capacity;
    outline_curve *curve;
    outline_equation *equation;
    size_t all_cuts, fixed_count, fixed_capacity;
    fmpq *fixed; /* points at which a path or an envelope rests, two coordinates each */
    size_t piece_count, piece_capacity, point_count, point_capacity;
    outline_piece *piece;
    outline_point *point;
    size_t arc_count, arc_capacity, ring_count, ring_capacity, around_count, around_capacity;
    size_t *arc_piece, *ring_arc;
    outline_arc *arc;
    outline_ring *ring, *around;
    size_t vertex_count, walk_count, components, interior_components, holes;
    long euler;
    outline_measure area, length;
    ulong places; /* of the bounds of measures */
    size_t spot_count, spot_capacity, undecided;
    fmpq *spot; /* isolated lower points, two coordinates each */
};

/** Part of an arc as an edge of a polygon. It begins at `at`, integers in units of 2^-places, in
 * the direction that has the set on its left, and ends where edge `next` begins. `node`: edges with
 * one number begin at one point of the outline. `where` holds the part's parameters, of a curved
 * arc.
 */
typedef struct polygon_edge {
    size_t arc, node, next;
    slong at[2];
    dyadic_interval where;
    int curved, fine, split;
} polygon_edge;

/** Rings as polylines: ring r begins with edge first[r]; within[r] is the ring around a hole, else
 * r. `distance`: in units, of an arc from its edges. */
typedef struct outline_polygon {
    const graze_outline *o;
    graze_context *context;
    ulong places;
    double distance;
    size_t count, capacity, ring_count, *first, *within;
    polygon_edge *edge;
} outline_polygon;

/** Find the outline of a scene in the plane. `out` is zeroed; the caller calls outline_clear in any
 * case. GRAZE_ELIMIT, GRAZE_ECANCELED, GRAZE_ESYSTEM, GRAZE_EINTERNAL. */
graze_status outline_make(graze_outline *out, graze_context *context, const graze_scene *scene,
                          double width);
void outline_clear(graze_outline *o);

/** Make both coordinates of a point: roots of minimal polynomials. */
graze_status outline_point_make(const graze_outline *o, graze_context *context, outline_point *p);

/** The sign of a measure; 0 where it is not known, or zero. */
int outline_sign(const outline_measure *m);
/** The piece of `arc`'s last class that continues a piece of its first class. */
const outline_piece *outline_last_of(const graze_outline *o, const outline_arc *arc,
                                     const outline_piece *first);

/** The source of an arc. */
curve_source outline_arc_source(const graze_outline *o, size_t arc);

/** Bounds of a measure. */
void outline_rational_bounds(fmpq_t low, fmpq_t high, const graze_outline *o,
                             const outline_measure *m);
void outline_bounds(double *low, double *high, const graze_outline *o, const outline_measure *m);
/** Make simple rings within a distance of the outline, nested as its own (proofs/outline.md C145).
 * The caller calls outline_polygon_clear in any case. GRAZE_ELIMIT, GRAZE_ECANCELED, GRAZE_ESYSTEM.
 */
graze_status outline_polygon_make(outline_polygon *out, const graze_outline *o,
                                  graze_context *context, double within);
/** Make simple rings on one side of the outline, whose edges are within a distance of it (C148), as
 * outline_polygon_make does. */
graze_status outline_polygon_beside(outline_polygon *out, const graze_outline *o,
                                    graze_context *context, double within, graze_polygon_side side);
void outline_polygon_clear(outline_polygon *p);
/** The number of lower arcs: pieces between cuts. */
size_t outline_lower_count(const graze_outline *o);

/** No piece: the end of a list. */
static const size_t OUTLINE_NONE = (size_t)-1;

#endif
