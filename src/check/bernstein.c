/* Bernstein coefficients.
 * SPDX-License-Identifier: MIT
 */
#include "poly.h"

/* With a = A/D, b = B/D and u = (A + B y) / (D (1 + y)), y from 0 to infinity: D^n (1+y)^n p(u) is
 * the sum of C(n, k) b_k D^n y^k. By Horner: r_n = p_n, r_i = r_(i+1) (A + B y) + p_i (D
 * (1+y))^(n-i). */
void bernstein(mpz_t *out, const poly *p, size_t n, const mpq_t a, const mpq_t b) {
    mpz_t low, high, common, old;
    mpz_t *power = integers(n + 1);
    mpz_inits(low, high, common, old, NULL);
    mpz_lcm(common, mpq_denref(a), mpq_denref(b));
    mpz_divexact(low, common, mpq_denref(a));
    mpz_mul(low, low, mpq_numref(a));
    mpz_divexact(high, common, mpq_denref(b));
    mpz_mul(high, high, mpq_numref(b));
    for (size_t k = 0; k <= n; k++)
        mpz_set_ui(out[k], 0);
    mpz_set_ui(power[0], 1);
    for (size_t step = 0; step <= n; step++) {
        size_t i = n - step; /* power is (D (1+y))^step, out has degree < step */
        for (size_t k = step + 1; k-- > 0 && step > 0;) {
            mpz_mul(old, out[k], low);
            if (k > 0)
                mpz_addmul(old, out[k - 1], high);
            mpz_swap(out[k], old);
        }
        for (size_t k = 0; i < p->n && k <= step; k++)
            mpz_addmul(out[k], power[k], p->c[i]);
        for (size_t k = step + 2; k-- > 0 && step < n;) {
            if (k > 0)
                mpz_add(power[k], power[k], power[k - 1]);
            mpz_mul(power[k], power[k], common);
        }
    }
    integers_free(power, n + 1);
    mpz_clears(low, high, common, old, NULL);
}

int strict_sign(mpz_t *c, size_t count) {
    int sign = count > 0 ? mpz_sgn(c[0]) : 0;
    for (size_t k = 1; k < count; k++)
        if (mpz_sgn(c[k]) != sign)
            return 0;
    return sign;
}
