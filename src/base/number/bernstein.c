/* Bernstein coefficients of integer polynomials on dyadic intervals, integers throughout.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/number/bernstein.h"

#include "base/context/scope.h"

/* Vectors of integers of one width, on top of GMP's unsigned limb kernels, which wrap around as
 * two's complement does. Sums, products and left shifts are right modulo 2^(64 limbs) whatever is
 * lost on the way, so only a result whose sign or value is read must fit. */

/* Zeros, wide enough for every integer below 2^bits in size. */
static void wide_init(wide_vector *v, slong count, ulong bits) {
    v->count = count;
    v->limbs = (slong)(bits / FLINT_BITS) + 1;
    v->limb = flint_calloc((size_t)(count * v->limbs), sizeof *v->limb);
}

/* Copy the integers into a new vector whose entries have at least as many limbs. */
static void wide_init_wider(wide_vector *v, const wide_vector *narrow, ulong bits) {
    wide_init(v, narrow->count, bits);
    for (slong i = 0; i < v->count; i++) {
        mp_limb_t *out = wide_entry(v, i);
        memcpy(out, wide_entry(narrow, i), (size_t)narrow->limbs * sizeof *out);
        if (wide_sign(narrow, i) < 0)
            memset(out + narrow->limbs, 0xff, (size_t)(v->limbs - narrow->limbs) * sizeof *out);
    }
}

void wide_get_fmpz(fmpz_t out, const wide_vector *v, slong i) {
    fmpz_set_signed_ui_array(out, wide_entry(v, i), v->limbs);
}

/* The limbs of |integer|, lowest first; `small` holds them if there is one. */
static const mp_limb_t *magnitude(slong *limbs, mp_limb_t *small, const fmpz_t integer) {
    if (COEFF_IS_MPZ(*integer)) {
        const __mpz_struct *big = COEFF_TO_PTR(*integer);
        *limbs = (slong)mpz_size(big);
        return mpz_limbs_read(big);
    }
    *small = (mp_limb_t)FLINT_ABS(*integer);
    *limbs = *small != 0;
    return small;
}

/* Entry i becomes its sum with entry j. */
static void wide_add(wide_vector *v, slong i, slong j) {
    mpn_add_n(wide_entry(v, i), wide_entry(v, i), wide_entry(v, j), v->limbs);
}

/* Entry i becomes its sum with `factor` times entry j. */
static void wide_addmul(wide_vector *v, slong i, slong j, const fmpz_t factor) {
    slong limbs;
    mp_limb_t small, *to = wide_entry(v, i);
    const mp_limb_t *digit = magnitude(&limbs, &small, factor), *from = wide_entry(v, j);
    for (slong k = 0; k < limbs && k < v->limbs; k++)
        if (fmpz_sgn(factor) > 0)
            mpn_addmul_1(to + k, from, v->limbs - k, digit[k]);
        else
            mpn_submul_1(to + k, from, v->limbs - k, digit[k]);
}

/* Multiply in place, from the highest limb down: each limb is replaced by the lowest one of its
 * product, and the others are added to the limbs above. */
static void mul_magnitude(mp_limb_t *entry, slong limbs, const mp_limb_t *factor, slong digits) {
    for (slong at = limbs - 1; at >= 0; at--) {
        mp_limb_t own = entry[at];
        slong count = FLINT_MIN(digits, limbs - at);
        entry[at] = 0;
        mp_limb_t carry = mpn_addmul_1(entry + at, factor, count, own);
        if (at + count < limbs)
            mpn_add_1(entry + at + count, entry + at + count, limbs - at - count, carry);
    }
}

static void wide_mul(wide_vector *v, slong i, const fmpz_t factor) {
    slong digits;
    mp_limb_t small, *entry = wide_entry(v, i);
    const mp_limb_t *digit = magnitude(&digits, &small, factor);
    if (digits == 0)
        memset(entry, 0, (size_t)v->limbs * sizeof *entry);
    else if (digits == 1)
        mpn_mul_1(entry, entry, v->limbs, *digit);
    else
        mul_magnitude(entry, v->limbs, digit, digits);
    if (fmpz_sgn(factor) < 0)
        mpn_neg(entry, entry, v->limbs);
}

/* Entry i becomes entry j times 2^bits. */
static void wide_shift(wide_vector *v, slong i, slong j, ulong bits) {
    mp_limb_t *to = wide_entry(v, i);
    const mp_limb_t *from = wide_entry(v, j);
    slong whole = (slong)FLINT_MIN(bits / FLINT_BITS, (ulong)v->limbs);
    memmove(to + whole, from, (size_t)(v->limbs - whole) * sizeof *to);
    memset(to, 0, (size_t)whole * sizeof *to);
    if (bits % FLINT_BITS && whole < v->limbs)
        mpn_lshift(to + whole, to + whole, v->limbs - whole, (unsigned)(bits % FLINT_BITS));
}

/* The least common multiple of the binomials C(n, 0) ... C(n, n) for n = 0 to 24. */
static const ulong COMMON_BINOMIAL[] = {
    1,        1,        2,        3,        12,        10,        60,        105,    280,
    252,      2520,     2310,     27720,    25740,     24024,     45045,     720720, 680680,
    12252240, 11639628, 11085360, 10581480, 232792560, 223092870, 1070845776};

void common_binomial(fmpz_t out, slong n) {
    if (n < (slong)(sizeof COMMON_BINOMIAL / sizeof *COMMON_BINOMIAL)) {
        fmpz_set_ui(out, COMMON_BINOMIAL[n]);
        return;
    }
    LOCAL(fmpz, binomial);
    fmpz_one(out);
    for (slong i = 1; 2 * i <= n; i++) {
        fmpz_bin_uiui(binomial, (ulong)n, (ulong)i);
        fmpz_lcm(out, out, binomial);
    }
}

/* Entries 0 ... n become the coefficients of 2^(e n) p((low + (high - low) v) / 2^e) in powers of
 * v. */
static void pull_to_unit(wide_vector *out, const fmpz_poly_t p, const dyadic_interval *interval) {
    slong n = out->count - 1, degree = fmpz_poly_degree(p);
    for (slong i = 0; i <= degree; i++) {
        fmpz_get_signed_ui_array(wide_entry(out, i), out->limbs, p->coeffs + i);
        if (interval->exponent)
            wide_shift(out, i, i, interval->exponent * (ulong)(n - i));
    }
    if (!fmpz_is_zero(interval->low))
        for (slong level = 0; level < degree; level++)
            for (slong i = degree - 1; i >= level; i--)
                wide_addmul(out, i, i + 1, interval->low);
    LOCAL(fmpz, width);
    fmpz_sub(width, interval->high, interval->low);
    if (!fmpz_is_one(width))
        for (slong level = 1; level <= degree; level++)
            for (slong i = level; i <= degree; i++)
                wide_mul(out, i, width);
}

/* The least k with |x| <= 2^k. */
static ulong ceil_log(const fmpz_t x) {
    ulong bits = fmpz_bits(x);
    return bits > 0 && fmpz_val2(x) + 1 == bits ? bits - 1 : bits;
}

/* Bits of the coefficients: by C22 (b) each is a value of the polar form at the interval's ends, at
 * most sum |p_i| r^i in absolute value, where r is the largest of 1 and the ends' absolute values.
 * It is then multiplied by 2^(e n) and by `common`.
 */
static ulong coefficient_bits(const fmpz_poly_t p, slong n, const dyadic_interval *interval,
                              const fmpz_t common) {
    ulong low = ceil_log(interval->low), high = ceil_log(interval->high);
    ulong reach = FLINT_MAX(FLINT_MAX(low, high), interval->exponent);
    return (ulong)FLINT_ABS(fmpz_poly_max_bits(p)) + FLINT_BIT_COUNT(n + 1) + (ulong)n * reach +
           fmpz_bits(common);
}

/* b_j = sum_{i <= j} C(j, i) a_i / C(n, i): multiply by a common multiple of the binomials, divide
 * by each, then add as in Pascal's triangle. */
void bernstein_form_init(bernstein_form *out, const fmpz_poly_t p, slong n,
                         const dyadic_interval *interval) {
    LOCAL(fmpz, common);
    LOCAL(fmpz, binomial);
    fmpz_set_ui(binomial, 1);
    LOCAL(fmpz, factor);
    common_binomial(common, n);
    out->bits = coefficient_bits(p, n, interval, common);
    wide_init(&out->c, n + 1, out->bits);
    pull_to_unit(&out->c, p, interval);
    for (slong i = 0; i < fmpz_poly_length(p); i++) {
        fmpz_divexact(factor, common, binomial);
        wide_mul(&out->c, i, factor);
        fmpz_mul_ui(binomial, binomial, (ulong)(n - i));
        fmpz_divexact_ui(binomial, binomial, (ulong)(i + 1));
    }
    for (slong level = 1; level <= n; level++)
        for (slong i = n; i >= level; i--)
            wide_add(&out->c, i, i - 1);
}

void bernstein_form_clear(bernstein_form *form) {
    flint_free(form->c.limb);
}

void bernstein_from_poly(fmpz *out, const fmpz_poly_t p, slong n, const dyadic_interval *interval) {
    HELD(bernstein_form, form, p, n, interval);
    for (slong i = 0; i <= n; i++)
        wide_get_fmpz(out + i, &form.c, i);
}

/* Sums replace the averages of de Casteljau's scheme: entry i of level k is 2^k times too large, so
 * the left half's coefficient k is scaled by 2^(n - k), the right half's coefficient n - k too. */
void bernstein_split(fmpz *left, fmpz *right, const fmpz *c, slong degree) {
    _fmpz_vec_set(right, c, degree + 1);
    fmpz_mul_2exp(left, right, (ulong)degree);
    for (slong level = 1; level <= degree; level++) {
        for (slong i = 0; i <= degree - level; i++)
            fmpz_add(right + i, right + i, right + i + 1);
        fmpz_mul_2exp(left + level, right, (ulong)(degree - level));
    }
    for (slong i = 0; i <= degree; i++)
        fmpz_mul_2exp(right + i, right + i, (ulong)i);
}

/* Whether all coefficients are equal, so that the polynomial is constant. */
static int is_constant(const wide_vector *c) {
    size_t size = (size_t)c->limbs * sizeof *c->limb;
    slong i = 1;
    while (i < c->count && memcmp(wide_entry(c, i), c->limb, size) == 0)
        i++;
    return i == c->count;
}

/* De Casteljau's scheme on entries of one width. The coefficients of either half are means of those
 * of the whole (C25), so they grow by the factor 2^n at most. */
void bernstein_form_split(bernstein_form *form, bernstein_form *right) {
    slong n = form->c.count - 1, sums = is_constant(&form->c) ? 0 : n;
    wide_vector left;
    right->bits = form->bits + (ulong)n;
    wide_init_wider(&right->c, &form->c, right->bits);
    wide_init(&left, n + 1, right->bits);
    for (slong i = 0; i <= n; i++) {
        memcpy(wide_entry(&left, i), wide_entry(&right->c, 0),
               (size_t)left.limbs * sizeof *left.limb);
        wide_shift(&left, i, i, (ulong)(sums > 0 ? n - i : n));
        for (slong k = 0; k < sums - i; k++)
            wide_add(&right->c, k, k + 1);
    }
    for (slong i = 0; i <= n; i++)
        wide_shift(&right->c, i, i, (ulong)(sums > 0 ? i : n));
    flint_free(form->c.limb);
    form->c = left;
    form->bits = right->bits;
}

slong bernstein_variations(const bernstein_form *form) {
    slong variations = 0;
    int last = 0;
    for (slong i = 0; i < form->c.count; i++) {
        int sign = wide_sign(&form->c, i);
        variations += sign * last < 0;
        last = sign ? sign : last;
    }
    return variations;
}

int bernstein_one_sign(const bernstein_form *form) {
    int one = 0;
    for (slong i = 0; i < form->c.count; i++) {
        int sign = wide_sign(&form->c, i);
        if (sign * one < 0)
            return 0;
        one = sign ? sign : one;
    }
    return one;
}
