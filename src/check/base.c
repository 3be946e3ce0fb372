/* Arrays, integers, and the count of work.
 * SPDX-License-Identifier: MIT
 */
#include "base.h"

#include <stdlib.h>

static size_t work_left;

void work_begin(void) {
    work_left = MOST_WORK;
}

void work_allow(size_t more) {
    work_left = more < MOST_WORK - work_left ? work_left + more : MOST_WORK;
}

void work_on(const mpz_t a, const mpz_t b) {
    size_t work = (mpz_size(a) + 1) * (mpz_size(b) + 1) + 64; /* the call itself */
    if (work > work_left)
        give_up("numbers of %zu and %zu words are too much work here; see section K14 of "
                "proofs/certificate.md",
                mpz_size(a), mpz_size(b));
    work_left -= work;
}

void *room_for(void *items, size_t count, size_t *room, size_t size) {
    if (count < *room)
        return items;
    *room = 2 * count + 8;
    return grow(items, *room, size);
}

mpz_t *integers(size_t count) {
    mpz_t *out = grow(NULL, count, sizeof *out);
    for (size_t k = 0; k < count; k++)
        mpz_init(out[k]);
    return out;
}

void integers_free(mpz_t *x, size_t count) {
    for (size_t k = 0; k < count; k++)
        mpz_clear(x[k]);
    free(x);
}

void integers_of(mpz_t *out, mpq_srcptr const *x, size_t count) {
    mpz_set(out[count], mpq_denref(x[0]));
    for (size_t k = 1; k < count; k++)
        mpz_lcm(out[count], out[count], mpq_denref(x[k]));
    for (size_t k = 0; k < count; k++) {
        mpz_divexact(out[k], out[count], mpq_denref(x[k]));
        mpz_mul(out[k], out[k], mpq_numref(x[k]));
    }
}
