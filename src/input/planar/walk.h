/* The search for the boundary of a flat solid: boxes, and pieces of lines in them.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A box is cut in two until few planes matter in it. A plane matters in a closed box if it may meet
 * it and if the expression, with the signs that are certain in the box put in, still depends on it.
 * In a box that is cut no further, the boundary is found along each line in which two planes that
 * matter meet (proofs/curved.md C133). In the plane z = 0 stands for the second plane.
 */
#ifndef GRAZE_INPUT_PLANAR_WALK_H
#define GRAZE_INPUT_PLANAR_WALK_H

#include <flint/fmpq.h>
#include <flint/fmpz.h>
#include "base/context/array.h"
#include "input/planar/planar.h"

/** A line: its direction d, then its moment x cross d, where x is a point of it; six integers that
 * have no common factor, the first one of d that is not zero positive. */
enum { LINE_FORM = 6 };

/** Part of a line, from the points with d . x = from to that with d . x = to, along which a facet
 * ends. The facet lies in a plane and its outer side is that on which the plane's form has the sign
 * `facing`. */
typedef struct flat_piece {
    size_t line, plane;
    signed char facing;
    signed char along; /* the facet is on the left of d if 1, of -d if -1, seen from outside */
    fmpq from, to;
} flat_piece;

typedef struct flat_pieces {
    size_t count, capacity;
    flat_piece *item;
} flat_pieces;

typedef struct flat_lines {
    size_t count, capacity;
    fmpz *item; /* LINE_FORM each */
} flat_lines;

/** The state of a search. The expression has, besides that of the solid, the sides of a large box
 * where no box of the solid is known. */
typedef struct flat_walk {
    graze_context *context;
    int dimension;
    size_t plane_count, node_count, added; /* planes from number `added` on are sides of the box */
    fmpz *form;                            /* 4 for each plane; then that of z = 0 */
    double *near;                          /* the same in doubles, over a power of two */
    csg_node *node;
    size_t *operand;
    signed char *sign;  /* of a plane's form in the box at hand; 0: not certain */
    signed char *truth; /* of a node in the box at hand; UNKNOWN */
    char *matters;      /* of a plane or, behind the planes, a node; 0 between calls */
    numbers stack;      /* planes and nodes that matter in the boxes around the box at hand */
    flat_lines lines;
    flat_pieces pieces;
    int unbounded; /* 1: a piece lies in a side of the large box */
} flat_walk;

enum { UNKNOWN = 2 };

/** Planes and nodes that matter in a box, as ranges of flat_walk.stack; nodes ascend. */
typedef struct flat_live {
    size_t plane, planes, node, nodes;
} flat_live;

/** Prepare a search, which flat_walk_clear clears, also after a failure. */
graze_status flat_walk_begin(flat_walk *w, graze_context *context, const csg *solid);
void flat_walk_clear(flat_walk *w);

/** Find all pieces in a box, low and high in each coordinate; it must hold the solid. */
graze_status flat_walk_box(flat_walk *w, const double *low, const double *high);

/** Count work, as the limit `work` does. */
graze_status flat_spend(flat_walk *w, unsigned long work);

/** Set the truths of nodes for the signs at hand. @return the truth of the last one */
int flat_evaluate(flat_walk *w, const flat_live *live);

/** Append the pieces in a box that is cut no further. */
graze_status flat_pieces_find(flat_walk *w, const flat_live *live, const double *low,
                              const double *high);

/** Set `out` to a point of a line times its denominator |d|^2, which is out[3]: that with
 * d . x = 0. */
void flat_foot(fmpz *out, const fmpz *line);

/* Edges of facets. Pieces of one line and one facet are joined where boxes have cut them, and are
 * cut where any facet along the line ends, so that facets have the edge in common. */

/** An edge of a facet, which is on its left, seen from outside. */
typedef struct flat_edge {
    size_t plane;
    int facing;
    size_t from, to; /* vertices */
} flat_edge;

/** All edges, sorted by plane, facing and `from`. */
typedef struct flat_edges {
    size_t count, capacity;
    flat_edge *item;
} flat_edges;

/** The ends of edges, each vertex once, in the order of their coordinates. */
typedef struct flat_points {
    size_t count, capacity;
    fmpq *at;        /* 3 each, as they are found */
    size_t *number;  /* of the vertex at each */
    size_t vertices; /* how many there are */
    size_t *first;   /* of the points at each vertex */
} flat_points;

void flat_points_clear(flat_points *p);

/** Find the edges and the vertices; both are zero at first and cleared by the caller, also after a
 * failure. The pieces are sorted. */
graze_status flat_edges_find(flat_edges *out, flat_points *points, flat_walk *w);
void flat_edges_clear(flat_edges *e);

/** The end of the edges of one plane and facing that begin at `begin`. */
size_t flat_facet_end(const flat_edges *edges, size_t begin);

/** Order edges by `from`. */
int flat_from_order(const void *left, const void *right);

/** Make facets of the pieces. */
graze_status flat_facets(soup *out, flat_walk *w);

#endif
