/* mend: a legal solid of a soup that bounds none, by steps that move no point.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_INPUT_MEND_H
#define GRAZE_INPUT_MEND_H

#include "base/number/text.h"
#include "input/solid/solid.h"
#include "input/soup/soup.h"

/* Mending of meshes that bound no solid. */

/**
 * Make a legal solid of a mesh in E^3 by steps that move no point: equal vertices become one,
 * facets without area are dropped, edges are split at vertices in their middle, and facets are
 * turned round if the mesh is not legal otherwise. If `weld`, a positive distance, is not NULL,
 * vertices within that distance of each other are merged too (weld_vertices), which moves points.
 * @param[out] out the solid; NULL on failure
 * @param[out] report a line for each thing that was done, initialised by the caller
 * @param input taken over, also on failure; one cycle a facet
 * @return GRAZE_EILLEGAL the mended mesh is not legal either; else as solid_create
 */
graze_status mend_solid(graze_solid **out, text *report, graze_context *context, soup *input,
                        unsigned flags, const fmpq *weld);

#endif
