/* Germs at irrational times. SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_ROOT_H
#define GRAZE_TOPO_ROOT_H

#include "questions/topo/germ.h"
#include "questions/topo/stand_in.h"

/** The minimal polynomial of an algebraic number, or 0 for one of a degree that is not factored. */
int root_find_minimal(fmpz_poly_t out, const algebraic *time);

/** 1 and the root if a minimal polynomial is that of a rational number. */
int root_is_rational(fmpq_t out, const fmpz_poly_t minimal);

/**
 * Fill a germ, all zeros, at an irrational time strictly inside a piece. A rational point with the
 * same signs against all planes of facets stands for the trajectory's. Where the linear map and the
 * leading direction are rational up to positive factors, the germ has no root and is exact.
 * @param[out] found 0 where what is covered is not known; the germ can be cleared then
 */
graze_status root_set_germ(int *found, germ *g, const germ_place *place, const algebraic *time,
                           const fmpz_poly_t minimal);

#endif
