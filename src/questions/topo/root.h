/* Germs at irrational times. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_TOPO_ROOT_H
#define GRAZE_TOPO_ROOT_H

#include "questions/topo/germ.h"
#include "questions/topo/stand_in.h"

/** Find the minimal polynomial of an algebraic number; 0 if its polynomial's degree is too large to
 * be factored. */
int root_find_minimal(fmpz_poly_t out, const algebraic *time);

/** 1 and the root if a minimal polynomial is linear, else 0. */
int root_is_rational(fmpq_t out, const fmpz_poly_t minimal);

/** Set a germ, all zeros, at an irrational time inside a piece. For the local cone a rational point
 * takes the trajectory's place, with the same signs against all planes of facets. If the linear map
 * and the leading direction are rational up to positive factors, the germ has no root and is exact.
 * @param[out] found 0 if the cover is not known; the caller can still clear the germ */
graze_status root_set_germ(int *found, germ *g, const germ_place *place, const algebraic *time,
                           const fmpz_poly_t minimal);

#endif
