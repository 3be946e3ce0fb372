/* Triangles or segments with the data for searches, whether they bound a solid or not.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_SOLID_SKIN_H
#define GRAZE_SOLID_SKIN_H

#include "input/solid/tree.h"
#include "input/soup/soup.h"
#include "input/validate/simplices.h"

/** Borrowed parts of a solid or of a mesh. */
typedef struct skin {
    const soup *input;
    const simplices *cut;     /* none is degenerate */
    const double *low, *high; /* bounds of the coordinates, as in a solid (solid.h) */
    const tree *boxes;        /* of the simplices; node_count 0 where there are none */
} skin;

/** Bounds of all coordinates of a soup, malloc'ed, to be freed in any case. GRAZE_ESYSTEM. */
graze_status skin_bounds(double **low, double **high, graze_context *context, const soup *input);

/** The tree over the boxes of simplices; none where there are none. tree_clear in any case.
 * @param s all but the tree
 * @return GRAZE_ESYSTEM */
graze_status skin_tree(tree *out, graze_context *context, const skin *s);

/** The plane form of a simplex, and a side form of it: as solid_plane and solid_side (solid.h). */
int skin_plane(fmpz *out, const skin *s, size_t simplex);
void skin_side(fmpz *out, const skin *s, size_t simplex, const fmpz *plane, int k);

/** The coordinates of a simplex's vertices, d pointers. */
void skin_vertices(const fmpq **vertex, const skin *s, size_t simplex);

#endif
