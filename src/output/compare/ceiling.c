/* Rounds numbers up to decimal digits, exactly.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/compare/compare.h"

#include <stdio.h>
#include "base/context/scope.h"
#include "output/compare/counts.h"

enum { KEPT = 100000, NEXT = 1000000, SHORT = 10000 };

/* x 10^power */
static void scale_by_ten(fmpq_t out, const fmpq_t x, long power) {
    LOCAL(fmpz, ten);
    fmpz_set_ui(ten, 10);
    fmpz_pow_ui(ten, ten, (ulong)(power < 0 ? -power : power));
    if (power < 0)
        fmpq_div_fmpz(out, x, ten);
    else
        fmpq_mul_fmpz(out, x, ten);
}

long decade_of(const fmpq_t x) {
    LOCAL(fmpq, scaled);
    /* Digits may be counted one too many, so this is not below k. */
    long k =
        (long)fmpz_sizeinbase(fmpq_numref(x), 10) - (long)fmpz_sizeinbase(fmpq_denref(x), 10) + 1;
    scale_by_ten(scaled, x, -k);
    while (fmpz_cmp(fmpq_numref(scaled), fmpq_denref(scaled)) < 0)
        scale_by_ten(scaled, x, -(--k));
    return k;
}

ceiling ceiling_of(const fmpq_t x) {
    ceiling out = {0, 0};
    if (fmpq_is_zero(x))
        return out;
    LOCAL(fmpq, scaled);
    LOCAL(fmpz, digits);
    out.exponent = decade_of(x);
    scale_by_ten(scaled, x, 5 - out.exponent);
    fmpz_cdiv_q(digits, fmpq_numref(scaled), fmpq_denref(scaled));
    out.digits = fmpz_get_ui(digits);
    if (out.digits == NEXT)
        out = (ceiling){KEPT, out.exponent + 1};
    return out;
}

int ceiling_compare(ceiling a, ceiling b) {
    if (!a.digits || !b.digits || a.exponent == b.exponent)
        return (a.digits > b.digits) - (a.digits < b.digits);
    return a.exponent < b.exponent ? -1 : 1;
}

ceiling ceiling_short(ceiling c) {
    c.digits = (c.digits + SHORT - 1) / SHORT * SHORT;
    if (c.digits == NEXT)
        c = (ceiling){KEPT, c.exponent + 1};
    return c;
}

void ceiling_text(char out[CEILING_ROOM], ceiling c) {
    if (!c.digits) {
        snprintf(out, CEILING_ROOM, "0");
        return;
    }
    unsigned long first = c.digits / KEPT, rest = c.digits % KEPT;
    int places = 5;
    for (; rest && rest % 10 == 0; rest /= 10)
        places--;
    if (rest)
        snprintf(out, CEILING_ROOM, "%lu.%0*lue%+03ld", first, places, rest, c.exponent);
    else
        snprintf(out, CEILING_ROOM, "%lue%+03ld", first, c.exponent);
}
