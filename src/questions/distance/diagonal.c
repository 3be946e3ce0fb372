/* The diagonal of S^0's box. SPDX-License-Identifier: GPL-3.0-or-later */
#include "questions/distance/distance.h"

#include <math.h>
#include "base/context/scope.h"

/* Squares of numbers between these bounds, and of much smaller ones, are in the range of doubles.
 */
static const double LEAST_DIAGONAL = 0x1p-300, MOST_DIAGONAL = 0x1p300;

/* sqrt of a sum of squares, rounded down. */
static double length_down(const fmpq *low, const fmpq *high, int d) {
    LOCAL_VEC(fmpq, sum, 2);
    fmpq *side = sum + 1;
    LOCAL(fmpz, n);
    for (int i = 0; i < d; i++) {
        fmpq_sub(side, high + i, low + i);
        fmpq_mul(side, side, side);
        fmpq_add(sum, sum, side);
    }
    /* n = floor(sqrt(sum 4^k)), with k such that n has 60 to 62 bits */
    slong k = 61 - ((slong)fmpz_bits(fmpq_numref(sum)) - (slong)fmpz_bits(fmpq_denref(sum))) / 2;
    if (k >= 0)
        fmpq_mul_2exp(sum, sum, 2 * (ulong)k);
    else
        fmpq_div_2exp(sum, sum, 2 * (ulong)-k);
    fmpz_fdiv_q(n, fmpq_numref(sum), fmpq_denref(sum));
    fmpz_sqrt(n, n);
    return ldexp(fmpz_get_d(n), (int)-k); /* FLINT cuts what a double has no place for */
}

/* Extend the box by the image of a vertex, without the translation, which changes no length of the
 * box's sides. */
static void extend(fmpq *low, fmpq *high, const fmpq *map, const fmpq *vertex, int d, int first) {
    LOCAL(fmpq, value);
    for (int i = 0; i < d; i++) {
        fmpq_zero(value);
        for (int j = 0; j < d; j++)
            fmpq_addmul(value, map + i * (d + 1) + j, vertex + j);
        if (first || fmpq_cmp(value, low + i) < 0)
            fmpq_set(low + i, value);
        if (first || fmpq_cmp(value, high + i) > 0)
            fmpq_set(high + i, value);
    }
}

graze_status distance_diagonal(double *out, graze_context *context, const graze_scene *scene) {
    const graze_solid *solid = scene->solid;
    int d = scene->motion->dimension;
    LOCAL_VEC(fmpq, map, d * (d + 1));
    LOCAL_VEC(fmpq, low, d);
    LOCAL_VEC(fmpq, high, d);
    point_map_at(map, &scene->motion->piece[0].forward, &(fmpq){0, 1});
    for (size_t s = 0; s < solid->cut.count; s++) {
        for (int c = 0; c < d; c++)
            extend(low, high, map,
                   solid->input.coordinates + (size_t)solid->cut.item[s].vertex[c] * d, d,
                   s == 0 && c == 0);
        if (s % 1024 == 1023)
            TRY(context_poll(context));
    }
    *out = length_down(low, high, d);
    if (!(*out >= LEAST_DIAGONAL && *out <= MOST_DIAGONAL))
        return context_fail(context, GRAZE_ELIMIT,
                            "the diagonal of the solid's box at the start is beyond what "
                            "distances are computed for; expected between 2^-300 and 2^300");
    return GRAZE_OK;
}
