/* The search of a curve for the surfaces of a curved solid that it meets.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_FILTER_SURFACE_SEARCH_H
#define GRAZE_FILTER_SURFACE_SEARCH_H

#include "decide/filter/filter.h"

/**
 * Find all surfaces that a point's trajectory meets: findings, whose simplices are surfaces, are in
 * the workspace until the next search, and the signs at the start in its truths
 * (proofs/surfaces.md C106).
 * @param exactly let every time be asked: one window a piece
 * @return 0 if the filter cannot be used for this point, or without memory
 */
int surfaces_search(filter_workspace *w, const surface_filter *f, const filter_point *point,
                    int exactly);

#endif
