/* Measures the differences of points exactly.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The differences do not affect how rows are judged: they only tell rounded points from points in
 * another order.
 */
#include "output/compare/compare.h"

#include <flint/fmpq_vec.h>
#include "base/context/scope.h"
#include "base/number/rational.h"
#include "input/delimited/delimited.h"
#include "output/compare/counts.h"
#include "output/compare/rows.h"

enum { BOX_BITS = 10, SIZE_BITS = 20 };

void drift_init(drift *d, const table *golden, const table *candidate) {
    *d = (drift){.golden = golden, .candidate = candidate};
    key_of_axes(&d->axes, golden, candidate);
    d->farthest = _fmpq_vec_init(7);
    d->least = d->farthest + 1;
    d->most = d->farthest + 4;
}

void drift_clear(drift *d) {
    if (d->farthest)
        _fmpq_vec_clear(d->farthest, 7);
}

static graze_status read_drifting(fmpq_t out, const table *t, const table_row *row, column which) {
    field f = table_field(t, row, which);
    graze_status status = rational_parse(out, t->in.context, f.start, f.length);
    return status ? context_in(t->in.context, status, t->in.name, row->line) : status;
}

/* Count a golden coordinate and its difference from the candidate's. */
static void take_coordinate(drift *d, size_t axis, const fmpq_t right, fmpq_t difference) {
    if (!d->any || fmpq_cmp(right, d->least + axis) < 0)
        fmpq_set(d->least + axis, right);
    if (!d->any || fmpq_cmp(right, d->most + axis) > 0)
        fmpq_set(d->most + axis, right);
    fmpq_abs(difference, difference);
    if (fmpq_cmp(difference, d->farthest) > 0)
        fmpq_set(d->farthest, difference);
}

static int same_fields(const drift *d, const table_row *right, const table_row *given) {
    int same = 1;
    for (size_t k = 0; k < d->axes.count && same; k++)
        same = field_equal(table_field(d->golden, right, d->axes.at[k]),
                           table_field(d->candidate, given, d->axes.at[k]));
    return same;
}

graze_status drift_add(drift *d, const table_row *right, const table_row *given) {
    int differs = 0;
    if (same_fields(d, right, given))
        return GRAZE_OK;
    LOCAL_VEC(fmpq, a, 2);
    fmpq *b = a + 1;
    for (size_t k = 0; k < d->axes.count; k++) {
        TRY(read_drifting(a, d->golden, right, d->axes.at[k]));
        TRY(read_drifting(b, d->candidate, given, d->axes.at[k]));
        fmpq_sub(b, a, b);
        differs |= !fmpq_is_zero(b);
        take_coordinate(d, k, a, b);
    }
    d->any = 1;
    d->rows += differs != 0;
    return GRAZE_OK;
}

/* The larger of two numbers' absolute values. */
static void larger_size(fmpq_t out, const fmpq_t a, const fmpq_t b) {
    LOCAL(fmpq, size);
    fmpq_abs(out, a);
    fmpq_abs(size, b);
    if (fmpq_cmp(size, out) > 0)
        fmpq_swap(size, out);
}

int drift_is_small(const drift *d) {
    int small = 0;
    LOCAL(fmpq, bound);
    for (int k = 0; k < 3 && !small; k++) {
        fmpq_sub(bound, d->most + k, d->least + k);
        fmpq_div_2exp(bound, bound, BOX_BITS);
        small = fmpq_cmp(d->farthest, bound) <= 0;
        larger_size(bound, d->most + k, d->least + k);
        fmpq_div_2exp(bound, bound, SIZE_BITS);
        small |= fmpq_cmp(d->farthest, bound) <= 0;
    }
    return small;
}
