/* Binary places: how near to 0 a polynomial has no other root.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * With r = 2^-places a sum of terms stays below a constant in absolute value on [-r, r].
 */
#ifndef GRAZE_TOPO_BINARY_PLACES_H
#define GRAZE_TOPO_BINARY_PLACES_H

#include <flint/fmpz_poly.h>

/** Raise the places until a term of `bits` bits and of a degree is below 1 / `terms` of a constant
 * of `constant` bits: it is so from (bits - constant + 1 + log2 terms) / degree places on. */
void places_for_term(ulong *places, ulong constant, ulong bits, ulong degree, ulong terms);

/** Raise them until p, not zero, has no root in [-r, r] but 0. */
void places_below_roots(ulong *places, const fmpz_poly_t p);

#endif
