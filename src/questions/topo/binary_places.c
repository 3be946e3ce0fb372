/* Places by bits of coefficients. SPDX-License-Identifier: GPL-3.0-or-later */
#include <flint/fmpz.h>
#include "questions/topo/eliminate.h"

void places_for_term(ulong *places, ulong constant, ulong bits, ulong degree, ulong terms) {
    ulong needed = bits + 1 + FLINT_BIT_COUNT(terms);
    if (needed > constant)
        *places = FLINT_MAX(*places, (needed - constant + degree - 1) / degree);
}

void places_below_roots(ulong *places, const fmpz_poly_t p) {
    slong zeros = 0, length = fmpz_poly_length(p);
    while (fmpz_is_zero(fmpz_poly_get_coeff_ptr(p, zeros)))
        zeros++;
    ulong constant = fmpz_bits(fmpz_poly_get_coeff_ptr(p, zeros));
    for (slong k = zeros + 1; k < length; k++)
        if (!fmpz_is_zero(fmpz_poly_get_coeff_ptr(p, k)))
            places_for_term(places, constant, fmpz_bits(fmpz_poly_get_coeff_ptr(p, k)),
                            (ulong)(k - zeros), (ulong)length);
}
