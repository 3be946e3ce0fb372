/* Rounds the pieces of a motion to a dyadic grid (convert.h).
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * An entry sum c_k u^k of a piece, u from 0 to 1, is changed into one with the same or rounded
 * values at both ends and with rounded c_k for k from 2 up; c_1 then follows from the values at
 * both ends. With e_0 and e_1 the changes of the values at the ends and e_k that of c_k, the entry
 * changes by e_0 (1 - u) + e_1 u + sum e_k (u^k - u), so by at most max(|e_0|, |e_1|) + sum |e_k|:
 * with g the grid's step and n the degree, n g / 2 at most where n is 1 or more. Both pieces at a
 * break point round the same value, so the motion stays continuous; beside a piece that is kept the
 * value is kept too.
 */
#include "input/convert/angle.h"

#include "base/context/scope.h"

typedef struct rounding_task {
    const graze_motion *motion;
    slong bits;  /* the grid's step is 2^-bits */
    fmpq *worst; /* upper bound of the change of entries so far */
    int turned;  /* an entry of a linear part is changed */
    fmpq *value, *change, *bound;
} rounding_task;

static int has_polynomials(const motion_piece *piece) {
    return fmpz_poly_degree(piece->forward.weight) == 0;
}

/* Round task->value to the nearest multiple of 2^-bits, halves upwards, and set task->change to the
 * absolute change. */
static void round_value(rounding_task *task) {
    LOCAL(fmpz, twice);
    LOCAL(fmpq, scaled);
    fmpq_mul_2exp(scaled, task->value, (ulong)task->bits + 1);
    fmpz_add(twice, fmpq_numref(scaled), fmpq_denref(scaled)); /* floor((2 v 2^bits + 1) / 2) */
    fmpz_mul_2exp(fmpq_denref(scaled), fmpq_denref(scaled), 1);
    fmpz_fdiv_q(twice, twice, fmpq_denref(scaled));
    fmpq_set(task->change, task->value);
    fmpq_set_fmpz(task->value, twice);
    fmpq_div_2exp(task->value, task->value, (ulong)task->bits);
    fmpq_sub(task->change, task->value, task->change);
    fmpq_abs(task->change, task->change);
}

/* Round `from`, one entry of piece k, to `to`; the change is at most task->bound. */
static void round_entry(rounding_task *task, fmpq_poly_t to, const fmpq_poly_t from, size_t k) {
    const graze_motion *m = task->motion;
    int round_start = k == 0 || has_polynomials(m->piece + k - 1);
    int round_end = k + 1 == m->piece_count || has_polynomials(m->piece + k + 1);
    LOCAL(fmpq, slope);
    fmpq_zero(task->bound);
    fmpq_poly_get_coeff_fmpq(task->value, from, 0);
    if (round_start) {
        round_value(task);
        fmpq_set(task->bound, task->change);
    }
    fmpq_poly_set_coeff_fmpq(to, 0, task->value);
    fmpq_neg(slope, task->value);
    fmpq_one(task->value);
    fmpq_poly_evaluate_fmpq(task->value, from, task->value);
    if (round_end) {
        round_value(task);
        if (fmpq_cmp(task->change, task->bound) > 0)
            fmpq_set(task->bound, task->change);
    }
    fmpq_add(slope, slope, task->value);
    for (slong i = 2; i < fmpq_poly_length(from); i++) {
        fmpq_poly_get_coeff_fmpq(task->value, from, i);
        round_value(task);
        fmpq_add(task->bound, task->bound, task->change);
        fmpq_poly_set_coeff_fmpq(to, i, task->value);
        fmpq_sub(slope, slope, task->value);
    }
    fmpq_poly_set_coeff_fmpq(to, 1, slope);
}

/* Round the map of piece k, which is polynomial. Its entries get a common denominator. */
static void round_map(rounding_task *task, point_map *map, size_t k) {
    int d = map->dimension, entries = d * (d + 1);
    LOCAL_VEC(fmpq_poly, made, entries);
    LOCAL(fmpq_poly, from);
    LOCAL(fmpz, weight);
    fmpz_one(weight);
    for (int e = 0; e < entries; e++) {
        fmpq_poly_set_fmpz_poly(from, map->entry + e);
        fmpq_poly_scalar_div_fmpz(from, from, fmpz_poly_lead(map->weight));
        round_entry(task, made + e, from, k);
        fmpz_lcm(weight, weight, fmpq_poly_denref(made + e));
        if (fmpq_cmp(task->bound, task->worst) > 0)
            fmpq_set(task->worst, task->bound);
        task->turned |= e % (d + 1) < d && !fmpq_poly_equal(from, made + e);
    }
    for (int e = 0; e < entries; e++) {
        fmpq_poly_scalar_mul_fmpz(made + e, made + e, weight);
        fmpq_poly_get_numerator(map->entry + e, made + e);
    }
    fmpz_poly_set_fmpz(map->weight, weight);
}

/* The grid whose change of an entry is at most the tolerance: degree 2^-bits / 2 <= tolerance. */
static slong find_bits(const graze_motion *motion, const fmpq_t tolerance) {
    slong degree = 1, bits = 0;
    for (size_t k = 0; k < motion->piece_count; k++)
        for (int e = 0; e < motion->dimension * (motion->dimension + 1); e++) {
            slong own = fmpz_poly_degree(motion->piece[k].forward.entry + e);
            degree = has_polynomials(motion->piece + k) && own > degree ? own : degree;
        }
    LOCAL(fmpq, step);
    fmpq_set_si(step, degree, 2);
    for (; fmpq_cmp(step, tolerance) > 0; bits++)
        fmpq_div_2exp(step, step, 1);
    return bits;
}

static void report_dyadic(text *t, const rounding_task *task) {
    const graze_motion *m = task->motion;
    size_t kept = 0;
    for (size_t k = 0; k < m->piece_count; k++)
        kept += !has_polynomials(m->piece + k);
    text_format(t,
                "dyadic: in %zu of %zu pieces coefficients are rounded to multiples of 2^-%ld, in "
                "the parameter from 0 to 1 along the piece\n",
                m->piece_count - kept, m->piece_count, (long)task->bits);
    put_rational_fact(t, "change: an entry of the matrix is off, at any time, by", task->worst);
    if (task->turned)
        text_put(t, "shape: entries of the linear part are rounded too, so positions of the solid "
                    "are congruent up to that change only\n");
    if (!kept)
        return;
    const motion_piece *piece = m->piece;
    while (has_polynomials(piece))
        piece++;
    text_format(t, "lost: %zu pieces, the first from t = ", kept);
    json_form(t,
              "@ to @, are kept as they are, and the values of other pieces where they meet these: "
              "entries of kept pieces are quotients, which are dyadic at quarter turns at most\n",
              piece->lo, piece->hi);
}

void convert_dyadic(conversion *out, const graze_motion *motion, const fmpq_t tolerance) {
    LOCAL_VEC(fmpq, number, 4);
    rounding_task task = {.motion = motion,
                          .bits = find_bits(motion, tolerance),
                          .worst = number,
                          .value = number + 1,
                          .change = number + 2,
                          .bound = number + 3};
    json_writer w = motion_begin(&out->motion, motion->dimension, "pieces", 0);
    for (size_t k = 0; k < motion->piece_count; k++) {
        motion_piece piece = motion->piece[k];
        HELD(point_map, map, motion->dimension);
        point_map_set(&map, &piece.forward);
        if (has_polynomials(&piece))
            round_map(&task, &map, k);
        piece.forward = map;
        motion_put_piece(&w, &piece);
    }
    motion_end(&w);
    report_dyadic(&out->report, &task);
}
