/* Reads enclosures and values exactly, judges the values, and measures the differences of points.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Under a motion error ETA the signed distance lies in [sdf_low - ETA, sdf_high + ETA], and its
 * sign is certain where this interval has one (proofs/distance.md C73).
 */
#include "output/compare/counts.h"

#include <stdio.h>
#include "base/context/scope.h"
#include "base/number/rational.h"
#include "base/number/vector.h"

/* Read the number of an option, 0 if there is none; its sign must be at least `least`. */
static graze_status read_amount(fmpq_t out, graze_context *context, const char *name,
                                const char *value, int least) {
    fmpq_zero(out);
    if (!value)
        return GRAZE_OK;
    graze_status status = table_number(out, context, (field){value, strlen(value)});
    if (!status && fmpq_sgn(out) < least)
        status = context_fail(context, GRAZE_EINPUT, "%.40s; expected a number %s", value,
                              least ? "above 0" : "from 0 up");
    return status ? context_at(context, status, "%s", name) : status;
}

graze_status values_choose(graze_comparison *c, const table *golden) {
    const graze_compare_options *o = &c->options;
    graze_context *context = golden->in.context;
    const char *operation = golden->notes[NOTE_OPERATION];
    const long *bounds = golden->where + column_of("sdf");
    int has = bounds[0] >= 0 && bounds[1] >= 0;
    int sdf = o->has == GRAZE_HAS_SDF;
    const char *asked = o->motion_error    ? "a motion error"
                        : o->sdf_tolerance ? "a tolerance of values"
                        : o->truth         ? "the question of values outside"
                                           : NULL;
    if (asked && !has)
        return table_fail(golden, 0,
                          "has no columns sdf_low and sdf_high, which %s needs; expected a table "
                          "of graze classify --sdf",
                          asked);
    if (o->truth == GRAZE_TRUTH_OUTSIDE && operation && strcmp(operation, "unsweep") == 0)
        return table_fail(golden, 0,
                          "has the distances to an unsweep, which outside of it are lower bounds; "
                          "expected the table of a sweep for values outside");
    c->valued = has && sdf;
    c->enclosed =
        has && (sdf || o->motion_error || golden->sets & columns_known(columns_place("sdf")).bit);
    c->judged[COLUMN_SDF] = c->valued && o->sdf_tolerance;
    TRY(read_amount(c->depth.size, context, "diagonal", golden->notes[NOTE_DIAGONAL], 0));
    TRY(read_amount(c->tolerance, context, "sdf_tolerance", o->sdf_tolerance, 0));
    return read_amount(c->eta, context, "motion_error", o->motion_error, 1);
}

/* Does an enclosure, the lower bound e[0] and the upper bound e[1], have the sign of an answer? */
static int has_sign(const fmpq *e, int pmc) {
    int low = fmpq_sgn(e), high = fmpq_sgn(e + 1);
    if (fmpq_cmp(e, e + 1) > 0)
        return 0;
    return pmc == PMC_IN    ? low < 0 && high <= 0
           : pmc == PMC_OUT ? low >= 0 && high > 0
                            : !low && !high;
}

static graze_status read_bound(fmpq_t out, const table *t, const table_row *row, column which) {
    field f = table_field(t, row, which);
    graze_status status = table_number(out, t->in.context, f);
    if (status)
        context_at(t->in.context, status, "%s", column_name(which));
    return status ? context_in(t->in.context, status, t->in.name, row->line) : status;
}

static graze_status read_enclosure(fmpq *out, const table *t, const table_row *row, int pmc) {
    for (int k = 0; k < 2; k++)
        TRY(read_bound(out + k, t, row, column_of("sdf") + (column)k));
    if (!has_sign(out, pmc))
        return table_fail(t, row->line,
                          "sdf_low and sdf_high do not go with `%s`; expected an enclosure of the "
                          "signed distance",
                          pmc_words[pmc]);
    return GRAZE_OK;
}

static void name_decade(char out[24], const fmpq *e, int pmc) {
    if (pmc == PMC_ON) {
        strcpy(out, "0");
        return;
    }
    LOCAL(fmpq, size);
    fmpq_abs(size, pmc == PMC_IN ? e : e + 1);
    snprintf(out, 24, "%s1e%+03ld", pmc == PMC_IN ? "-" : "", decade_of(size));
}

/* The error of a value against an enclosure. */
static value_error error_of(const fmpq_t value, const fmpq *e, const fmpq_t tolerance) {
    value_error out = {{0, 0}, 0, 0};
    LOCAL(fmpq, by);
    out.side = fmpq_cmp(value, e + 1) > 0 ? 1 : fmpq_cmp(value, e) < 0 ? -1 : 0;
    if (out.side > 0)
        fmpq_sub(by, value, e + 1);
    if (out.side < 0)
        fmpq_sub(by, e, value);
    out.beyond = fmpq_cmp(by, tolerance) > 0;
    out.size = ceiling_of(by);
    return out;
}

/* Widen an enclosure by the motion error. Does the widened one still have the sign of the answer?
 */
static int widen_enclosure(fmpq *e, const fmpq_t eta, int pmc) {
    fmpq_sub(e, e, eta);
    fmpq_add(e + 1, e + 1, eta);
    return fmpq_is_zero(eta) ? 1
           : pmc == PMC_OUT  ? fmpq_sgn(e) > 0
           : pmc == PMC_IN   ? fmpq_sgn(e + 1) < 0
                             : 0;
}

graze_status valuation_read(valuation *out, const graze_comparison *c, const table *golden,
                            const table_row *row, const table *candidate, const table_row *given,
                            int pmc) {
    LOCAL_VEC(fmpq, e, 2);
    LOCAL(fmpq, value);
    *out = (valuation){.certain = 1};
    TRY(read_enclosure(e, golden, row, pmc));
    name_decade(out->decade, e, pmc);
    out->certain = widen_enclosure(e, c->eta, pmc);
    out->judged = c->valued && given && (c->options.truth == GRAZE_TRUTH_PSEUDO || pmc == PMC_OUT);
    if (out->judged) {
        TRY(read_bound(value, candidate, given, COLUMN_SDF));
        out->error = error_of(value, e, c->tolerance);
    }
    return GRAZE_OK;
}

/* Differences of points, which do not affect how rows are judged: they only tell rounded points
 * from points in another order. */

enum { BOX_BITS = 10, SIZE_BITS = 20 };

void key_of_axes(row_key *out, const table *golden, const table *candidate) {
    size_t count = candidate->dimension >= golden->dimension ? (size_t)golden->dimension : 0;
    *out = (row_key){0, count, {COLUMN_X, COLUMN_Y, COLUMN_Z}};
}

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

int drift_is_small(const drift *d) {
    int small = 0;
    LOCAL(fmpq, bound);
    LOCAL_VEC(fmpq, ends, 2);
    for (int k = 0; k < 3 && !small; k++) {
        fmpq_set(ends, d->most + k);
        fmpq_set(ends + 1, d->least + k);
        fmpq_sub(bound, ends, ends + 1);
        fmpq_div_2exp(bound, bound, BOX_BITS);
        small = fmpq_cmp(d->farthest, bound) <= 0;
        vector_widest(bound, ends, 2);
        fmpq_div_2exp(bound, bound, SIZE_BITS);
        small |= fmpq_cmp(d->farthest, bound) <= 0;
    }
    return small;
}
