/* Radii r = 2^-places about 0 within which polynomials have no root but 0.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The radius is made so small that a polynomial's terms cannot cancel its lowest one on [-r, r].
 */
#ifndef GRAZE_TOPO_BINARY_PLACES_H
#define GRAZE_TOPO_BINARY_PLACES_H

#include <flint/fmpz_poly.h>

/** Raise the number of places until, on [-r, r], a term of a degree whose coefficient has `bits`
 * bits is below 1 / `terms` of a constant of `constant` bits: (bits - constant + 1 + log2 terms) /
 * degree places suffice. */
void places_for_term(ulong *places, ulong constant, ulong bits, ulong degree, ulong terms);

/** Raise the number of places until p, not zero, has no root in [-r, r] but 0. */
void places_below_roots(ulong *places, const fmpz_poly_t p);

#endif
