/* The edges of a boundary by position, cut where parts touch.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_ENVELOPE_EDGES_H
#define GRAZE_ENVELOPE_EDGES_H

#include "questions/envelope/cells.h"

/** Fill `edge` but for names and kinds, and append crossings of edges to the vertices' positions.
 * Facets, corners and positions of the solid's vertices are there. */
graze_status edges_find(cell_complex *c, graze_context *context);

#endif
