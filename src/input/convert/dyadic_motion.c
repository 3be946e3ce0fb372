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
#include "input/convert/convert.h"

#include <flint/fmpq_poly.h>
#include <stdlib.h>
#include "base/context/scope.h"
#include "input/convert/angle.h"
#include "input/motion/motion.h"

typedef struct rounding_task {
    const graze_motion *motion;
    slong bits;   /* the grid's step is 2^-bits */
    fmpq_t worst; /* upper bound of the change of entries so far */
    int turned;   /* an entry of a linear part is changed */
    fmpq_poly_t from, to;
    fmpq_t value, change, bound;
} rounding_task;

static int has_polynomials(const motion_piece *piece) {
    return fmpz_poly_degree(piece->forward.weight) == 0;
}

/* The multiple of 2^-bits nearest to a number, halves upwards. */
static void round_dyadic(fmpq_t out, const fmpq_t value, slong bits) {
    LOCAL(fmpz, twice);
    LOCAL(fmpq, scaled);
    fmpq_mul_2exp(scaled, value, (ulong)bits + 1);
    fmpz_add(twice, fmpq_numref(scaled), fmpq_denref(scaled)); /* floor((2 v 2^bits + 1) / 2) */
    fmpz_mul_2exp(fmpq_denref(scaled), fmpq_denref(scaled), 1);
    fmpz_fdiv_q(twice, twice, fmpq_denref(scaled));
    fmpq_set_fmpz(out, twice);
    fmpq_div_2exp(out, out, (ulong)bits);
}

/* Round task->value, and set task->change to the absolute change. */
static void round_value(rounding_task *task) {
    fmpq_set(task->change, task->value);
    round_dyadic(task->value, task->value, task->bits);
    fmpq_sub(task->change, task->value, task->change);
    fmpq_abs(task->change, task->change);
}

/* Round task->from, one entry of piece k, to task->to; the change is at most task->bound. */
static void round_entry(rounding_task *task, size_t k) {
    const graze_motion *m = task->motion;
    int round_start = k == 0 || has_polynomials(m->piece + k - 1);
    int round_end = k + 1 == m->piece_count || has_polynomials(m->piece + k + 1);
    LOCAL(fmpq, slope);
    fmpq_zero(task->bound);
    fmpq_poly_zero(task->to);
    fmpq_poly_get_coeff_fmpq(task->value, task->from, 0);
    if (round_start) {
        round_value(task);
        fmpq_set(task->bound, task->change);
    }
    fmpq_poly_set_coeff_fmpq(task->to, 0, task->value);
    fmpq_neg(slope, task->value);
    fmpq_set_si(task->value, 1, 1);
    fmpq_poly_evaluate_fmpq(task->value, task->from, task->value);
    if (round_end) {
        round_value(task);
        if (fmpq_cmp(task->change, task->bound) > 0)
            fmpq_set(task->bound, task->change);
    }
    fmpq_add(slope, slope, task->value);
    for (slong i = 2; i < fmpq_poly_length(task->from); i++) {
        fmpq_poly_get_coeff_fmpq(task->value, task->from, i);
        round_value(task);
        fmpq_add(task->bound, task->bound, task->change);
        fmpq_poly_set_coeff_fmpq(task->to, i, task->value);
        fmpq_sub(slope, slope, task->value);
    }
    fmpq_poly_set_coeff_fmpq(task->to, 1, slope);
}

/* The rounded map of piece k, which is polynomial. Its entries get a common denominator. */
static void round_map(rounding_task *task, point_map *out, size_t k) {
    const point_map *map = &task->motion->piece[k].forward;
    int d = map->dimension, entries = d * (d + 1);
    fmpq_poly_t made[POINT_MAP_ENTRIES];
    LOCAL(fmpz, weight);
    fmpz_set_ui(weight, 1);
    LOCAL(fmpz, factor);
    for (int e = 0; e < entries; e++) {
        fmpq_poly_init(made[e]);
        fmpz_poly_get_coeff_fmpz(factor, map->weight, 0);
        fmpq_poly_set_fmpz_poly(task->from, map->entry + e);
        fmpq_poly_scalar_div_fmpz(task->from, task->from, factor);
        round_entry(task, k);
        fmpq_poly_set(made[e], task->to);
        fmpz_lcm(weight, weight, fmpq_poly_denref(made[e]));
        if (fmpq_cmp(task->bound, task->worst) > 0)
            fmpq_set(task->worst, task->bound);
        task->turned |= e % (d + 1) < d && !fmpq_poly_equal(task->from, task->to);
    }
    for (int e = 0; e < entries; e++) {
        fmpq_poly_scalar_mul_fmpz(made[e], made[e], weight);
        fmpq_poly_get_numerator(out->entry + e, made[e]);
        fmpq_poly_clear(made[e]);
    }
    fmpz_poly_set_fmpz(out->weight, weight);
}

static void copy_map(point_map *out, const point_map *map) {
    for (int e = 0; e < map->dimension * (map->dimension + 1); e++)
        fmpz_poly_set(out->entry + e, map->entry + e);
    fmpz_poly_set(out->weight, map->weight);
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
    for (size_t k = 0; k < m->piece_count; k++) {
        const motion_piece *piece = m->piece + k;
        if (has_polynomials(piece))
            continue;
        text_format(t, "lost: %zu pieces, the first from t = ", kept);
        text_rational(t, piece->lo);
        text_put(t, " to ");
        text_rational(t, piece->hi);
        text_put(t, ", are kept as they are, and the values of other pieces where they meet these: "
                    "entries of kept pieces are quotients, which are dyadic at quarter turns at "
                    "most\n");
        break;
    }
}

graze_status convert_dyadic(conversion *out, graze_context *context, const graze_motion *motion,
                            const fmpq_t tolerance) {
    rounding_task task = {.motion = motion, .bits = find_bits(motion, tolerance)};
    graze_motion made = {.dimension = motion->dimension, .piece_count = motion->piece_count};
    made.piece = calloc(motion->piece_count, sizeof *made.piece);
    if (!made.piece)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory");
    fmpq_init(task.worst);
    fmpq_poly_init(task.from);
    fmpq_poly_init(task.to);
    fmpq_init(task.value);
    fmpq_init(task.change);
    fmpq_init(task.bound);
    for (size_t k = 0; k < motion->piece_count; k++) {
        const motion_piece *piece = motion->piece + k;
        point_map_init(&made.piece[k].forward, motion->dimension);
        fmpq_init(made.piece[k].lo);
        fmpq_init(made.piece[k].hi);
        fmpq_set(made.piece[k].lo, piece->lo);
        fmpq_set(made.piece[k].hi, piece->hi);
        made.piece[k].row = piece->row;
        if (has_polynomials(piece))
            round_map(&task, &made.piece[k].forward, k);
        else
            copy_map(&made.piece[k].forward, &piece->forward);
    }
    motion_write(&out->motion, &made);
    report_dyadic(&out->report, &task);
    for (size_t k = 0; k < motion->piece_count; k++) {
        point_map_clear(&made.piece[k].forward);
        fmpq_clear(made.piece[k].lo);
        fmpq_clear(made.piece[k].hi);
    }
    free(made.piece);
    fmpq_clear(task.worst);
    fmpq_poly_clear(task.from);
    fmpq_poly_clear(task.to);
    fmpq_clear(task.value);
    fmpq_clear(task.change);
    fmpq_clear(task.bound);
    return GRAZE_OK;
}
