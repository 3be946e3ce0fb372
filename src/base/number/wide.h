/* Vectors of integers that all have the same number of limbs: signed integers modulo 2^(64 limbs)
 * in two's complement. Sums, products and left shifts are right modulo that number whatever is lost
 * on the way, so only a result whose sign or value is read must fit.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_NUMBER_WIDE_H
#define GRAZE_NUMBER_WIDE_H

#include <flint/fmpz.h>
#include <gmp.h>

/** `count` integers of `limbs` limbs, lowest limb first, one after another. */
typedef struct wide_vector {
    slong count, limbs;
    mp_limb_t *limb;
} wide_vector;

/** Zeros, wide enough for every integer below 2^bits in size. */
void wide_init(wide_vector *v, slong count, ulong bits);
/** Copy the integers into a new vector whose entries have at least as many limbs. */
void wide_init_wider(wide_vector *v, const wide_vector *narrow, ulong bits);
void wide_clear(wide_vector *v);

static inline mp_limb_t *wide_entry(const wide_vector *v, slong i) {
    return v->limb + i * v->limbs;
}

/** Sign of an entry: -1, 0, 1. */
static inline int wide_sign(const wide_vector *v, slong i) {
    const mp_limb_t *entry = wide_entry(v, i);
    if (entry[v->limbs - 1] >> (FLINT_BITS - 1))
        return -1;
    for (slong k = v->limbs - 1; k >= 0; k--)
        if (entry[k])
            return 1;
    return 0;
}

/** Entry i becomes the integer, reduced modulo 2^(64 limbs) if it is too large. */
void wide_set_fmpz(wide_vector *v, slong i, const fmpz_t integer);
void wide_get_fmpz(fmpz_t out, const wide_vector *v, slong i);
/** Entry i becomes its sum with entry j. */
static inline void wide_add(wide_vector *v, slong i, slong j) {
    mpn_add_n(wide_entry(v, i), wide_entry(v, i), wide_entry(v, j), v->limbs);
}
/** Entry i becomes its sum with `factor` times entry j. */
void wide_addmul(wide_vector *v, slong i, slong j, const fmpz_t factor);
/** Entry i is multiplied. */
void wide_mul(wide_vector *v, slong i, const fmpz_t factor);
/** Entry i becomes entry j times 2^bits. */
void wide_shift(wide_vector *v, slong i, slong j, ulong bits);

#endif
