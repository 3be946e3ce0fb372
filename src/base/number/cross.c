/* Cross products; those of rationals by integers over one denominator.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/number/cross.h"

#include <flint/fmpq_vec.h>
#include <flint/fmpz_vec.h>
#include "base/context/scope.h"

void cross_integers(fmpz_t out, const fmpz *p, const fmpz *q, const fmpz *r, int i, int j) {
    LOCAL(fmpz, a);
    LOCAL(fmpz, b);
    fmpz_sub(a, q + i, p + i);
    fmpz_sub(b, r + j, p + j);
    fmpz_mul(out, a, b);
    fmpz_sub(a, q + j, p + j);
    fmpz_sub(b, r + i, p + i);
    fmpz_submul(out, a, b);
}

void cross_rationals(fmpq_t out, const fmpq *p, const fmpq *q, const fmpq *r, int i, int j) {
    const fmpq borrowed[] = {p[i], p[j], q[i], q[j], r[i], r[j]};
    LOCAL_VEC(fmpz, at, 8);
    fmpz *common = at + 6, *product = at + 7;
    _fmpq_vec_get_fmpz_vec_fmpz(at, common, borrowed, 6);
    cross_integers(product, at, at + 2, at + 4, 0, 1);
    fmpz_mul(common, common, common);
    fmpq_set_fmpz_frac(out, product, common);
}
