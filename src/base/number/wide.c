/* Two's complement on top of GMP's unsigned limb kernels, which wrap around as two's complement
 * does.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/number/wide.h"

#include <string.h>

void wide_init(wide_vector *v, slong count, ulong bits) {
    v->count = count;
    v->limbs = (slong)(bits / FLINT_BITS) + 1;
    v->limb = flint_calloc((size_t)(count * v->limbs), sizeof *v->limb);
}

void wide_init_wider(wide_vector *v, const wide_vector *narrow, ulong bits) {
    wide_init(v, narrow->count, bits);
    for (slong i = 0; i < v->count; i++) {
        mp_limb_t *out = wide_entry(v, i);
        memcpy(out, wide_entry(narrow, i), (size_t)narrow->limbs * sizeof *out);
        if (wide_sign(narrow, i) < 0)
            memset(out + narrow->limbs, 0xff, (size_t)(v->limbs - narrow->limbs) * sizeof *out);
    }
}

void wide_clear(wide_vector *v) {
    flint_free(v->limb);
}

void wide_set_fmpz(wide_vector *v, slong i, const fmpz_t integer) {
    fmpz_get_signed_ui_array(wide_entry(v, i), v->limbs, integer);
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

void wide_addmul(wide_vector *v, slong i, slong j, const fmpz_t factor) {
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

void wide_mul(wide_vector *v, slong i, const fmpz_t factor) {
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

void wide_shift(wide_vector *v, slong i, slong j, ulong bits) {
    mp_limb_t *to = wide_entry(v, i);
    const mp_limb_t *from = wide_entry(v, j);
    slong whole = (slong)FLINT_MIN(bits / FLINT_BITS, (ulong)v->limbs);
    memmove(to + whole, from, (size_t)(v->limbs - whole) * sizeof *to);
    memset(to, 0, (size_t)whole * sizeof *to);
    if (bits % FLINT_BITS && whole < v->limbs)
        mpn_lshift(to + whole, to + whole, v->limbs - whole, (unsigned)(bits % FLINT_BITS));
}
