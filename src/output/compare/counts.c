/* Counts, disagreements kept and depths of a comparison: wrong rows are measured.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/compare/counts.h"

#include "base/context/array.h"
#include "base/context/scope.h"
#include "base/number/rational.h"
#include "base/number/rounding.h"
#include "decide/verdict/verdict.h"

/* The width of an enclosure, in diagonals. */
static const double DEPTH_WIDTH = 1e-13;

const char *const depth_parts[DEPTH_PARTS] = {"1e-12", "1e-9", "1e-6", "1e-3"};

/* Count a row under each part of the size that `least`, the lower bound of its distance, exceeds.
 */
static void count_parts(depths *d, const fmpq_t least) {
    LOCAL(fmpq, scaled);
    fmpq_set(scaled, least);
    for (int k = DEPTH_PARTS - 1; k >= 0; k--) {
        fmpq_mul_ui(scaled, scaled, 1000);
        d->deeper[k] += fmpq_cmp(scaled, d->size) > 0;
    }
}

/* Count a row by the bounds of its signed distance, which are replaced by their absolute values;
 * *out is the larger one. */
static graze_status count_depth(ceiling *out, depths *d, graze_context *context, int pmc,
                                fmpq_t low, fmpq_t high) {
    int apart = fmpq_sgn(low) * fmpq_sgn(high) > 0;
    fmpq_abs(low, low);
    fmpq_abs(high, high);
    int falls = fmpq_cmp(low, high) > 0;
    *out = ceiling_of(falls ? low : high);
    if (apart && !fmpq_is_zero(d->size))
        count_parts(d, falls ? high : low);
    return errors_add(&d->by[pmc], (value_error){*out, out->digits > 0, 0})
               ? GRAZE_OK
               : comparison_no_memory(context);
}

graze_status depth_take(ceiling *out, depths *d, const table *golden, const table_row *row,
                        int pmc) {
    graze_context *context = golden->in.context;
    LOCAL_VEC(fmpq, low, 2);
    d->wrong++;
    for (int k = 0; k < 2; k++)
        TRY(table_number(low + k, context, table_field(golden, row, column_of("sdf") + (column)k)));
    return count_depth(out, d, context, pmc, low, low + 1);
}

int comparison_begin(graze_comparison *c, const graze_context *context, const char *golden,
                     const char *candidate, const graze_compare_options *options) {
    if (options)
        c->options = *options;
    c->rounding = context->rounding;
    fmpq_init(c->tolerance);
    fmpq_init(c->eta);
    fmpq_init(c->depth.size);
    c->golden = strdup(golden);
    c->candidate = strdup(candidate);
    c->solid = strdup(c->options.solid ? c->options.solid : "SOLID");
    c->motion = strdup(c->options.motion ? c->options.motion : "MOTION");
    return c->golden && c->candidate && c->solid && c->motion;
}

char comparison_count(graze_comparison *c, const judgement *j, int answered) {
    char what = !answered ? 'm' : j->any_wrong ? 'w' : j->undecided ? 'u' : 'a';
    c->rows++;
    c->missing += what == 'm';
    c->wrong += what == 'w';
    c->undecided += what == 'u';
    c->agree += what == 'a';
    for (int k = 0; answered && k < COLUMN_OPTIONS; k++)
        c->column_wrong[k] += (unsigned long)j->wrong[k];
    for (int k = 0; answered && k < CONVENTIONS; k++)
        c->wrong_as[k] += (unsigned long)j->wrong_as[k];
    return what;
}

static void drop_shown(disagreement *d) {
    free(d->stratum);
    free(d->point);
    free(d->golden);
    free(d->candidate);
    free(d->golden_row);
    free(d->candidate_row);
}

/* Order the deepest wrong rows first, equally deep ones as they were met, missing or extra rows
 * last. */
static int by_rank(const void *a, const void *b) {
    const disagreement *x = a, *y = b;
    int by = (x->pmc < 0) - (y->pmc < 0);
    by = by ? by : ceiling_compare(y->depth, x->depth);
    return by ? by : (x->order > y->order) - (x->order < y->order);
}

/* Do the rows kept before a wrong row already fill the share of its stratum? */
static int is_crowded(const disagreement *all, size_t count, const disagreement *d) {
    int same = 0;
    for (size_t k = 0; k < count && d->pmc >= 0 && d->stratum; k++)
        same += strcmp(all[k].stratum, d->stratum) == 0;
    return same >= MOST_OF_STRATUM;
}

/* Drop disagreements that are not to be shown; further rows could not bring one of them back. */
static void prune(graze_comparison *c) {
    disagreement *all = c->disagreements;
    size_t left = 0;
    if (c->by_depth && c->shown)
        qsort(all, c->shown, sizeof *all, by_rank);
    for (size_t k = 0; k < c->shown; k++)
        if (left == c->options.show || (c->by_depth && is_crowded(all, left, &all[k])))
            drop_shown(&all[k]);
        else
            all[left++] = all[k];
    c->shown = left;
}

/* Keep every other wrong row, so that those kept stay evenly spread. */
static void thin(graze_comparison *c) {
    size_t left = 0, wrong = 0;
    for (size_t k = 0; k < c->shown; k++)
        if (c->disagreements[k].pmc >= 0 && wrong++ % 2)
            drop_shown(&c->disagreements[k]);
        else
            c->disagreements[left++] = c->disagreements[k];
    c->shown = left;
    c->depth.waiting = (wrong + 1) / 2;
    c->depth.stride *= 2;
}

/* Is a wrong row to wait for the measurement of its distance? */
static int waits(graze_comparison *c) {
    depths *d = &c->depth;
    d->stride += !d->stride;
    if (d->waiting == MOST_MEASURED && d->wrong % d->stride == 0)
        thin(c);
    int one = d->wrong++ % d->stride == 0;
    d->waiting += (size_t)one;
    return one;
}

graze_status comparison_keep(disagreement **out, graze_comparison *c, graze_context *context,
                             int pmc) {
    size_t show = c->options.show;
    int ranked = pmc >= 0 && !c->contacts && (c->enclosed || c->options.scene);
    *out = NULL;
    c->met++;
    if (ranked && !c->enclosed ? !waits(c) : ranked ? !show : c->shown_alone == show)
        return GRAZE_OK;
    c->shown_alone += !ranked;
    c->by_depth = c->enclosed;
    if (c->enclosed && c->shown > MOST_MEASURED && c->shown / 3 > show)
        prune(c);
    if (!array_reserve(&c->disagreements, &c->shown_capacity, c->shown + 1,
                       sizeof *c->disagreements))
        return comparison_no_memory(context);
    *out = &c->disagreements[c->shown++];
    memset(*out, 0, sizeof **out);
    (*out)->order = c->met;
    (*out)->pmc = pmc;
    return GRAZE_OK;
}

/* Enclose the signed distance of a wrong row's point to 1e-13 of the size, count the row, and
 * append the enclosure to its golden answers. */
static graze_status measure_row(disagreement *d, graze_comparison *c, graze_context *context) {
    const graze_scene *scene = c->options.scene;
    slong dimension = scene->motion->dimension;
    const char *point = d->point;
    char low[BOUND_ROOM], high[BOUND_ROOM];
    LOCAL_VEC(fmpq, at, dimension);
    LOCAL_VEC(fmpq, bounds, 2);
    HELD(text, all);
    distance found;
    graze_pmc pmc = GRAZE_PMC_NONE;
    for (slong k = 0; k < dimension; k++) {
        size_t length = strcspn(point, " ");
        TRY(rational_parse(at + k, context, point, length));
        point += length + (point[length] == ' ');
    }
    TRY(distance_at(&found, &pmc, context, scene, at, DEPTH_WIDTH * fmpq_get_d(c->depth.size)));
    TRY(rational_from_double(bounds, context, found.low));
    TRY(rational_from_double(bounds + 1, context, found.high));
    TRY(count_depth(&d->depth, &c->depth, context, d->pmc, bounds, bounds + 1));
    report_bound(low, found.low, 0);
    report_bound(high, found.high, 1);
    text_format(&all, "%s sdf_low=%s sdf_high=%s", d->golden, low, high);
    free(d->golden);
    d->golden = text_take(&all);
    return d->golden ? GRAZE_OK : comparison_no_memory(context);
}

graze_status comparison_finish(graze_comparison *c, graze_context *context) {
    c->by_depth = !c->contacts && (c->enclosed || c->options.scene);
    int measured = c->by_depth && !c->enclosed;
    double diagonal;
    graze_status status = GRAZE_OK;
    if (measured)
        status = distance_diagonal(&diagonal, context, c->options.scene);
    if (measured && !status)
        status = rational_from_double(c->depth.size, context, diagonal);
    for (size_t k = 0; k < c->shown && measured && !status; k++)
        if (c->disagreements[k].pmc >= 0)
            status = measure_row(&c->disagreements[k], c, context);
    if (status == GRAZE_ELIMIT) {
        c->by_depth = 0;
        c->depth.unmeasured = strdup(graze_context_message(context));
        status = c->depth.unmeasured ? GRAZE_OK : comparison_no_memory(context);
    }
    prune(c);
    return status;
}

int comparison_has_no_on(const graze_comparison *c) {
    return c->judged[COLUMN_PMC] && c->golden_on && !c->answered_on;
}

void comparison_clear(graze_comparison *c) {
    for (size_t k = 0; k < c->shown; k++)
        drop_shown(&c->disagreements[k]);
    for (int g = 0; g < GROUPING_COUNT; g++)
        tally_clear(&c->tallies[g]);
    errors_clear(&c->values);
    for (int k = 0; k < 3; k++)
        errors_clear(&c->depth.by[k]);
    fmpq_clear(c->depth.size);
    free(c->depth.unmeasured);
    fmpq_clear(c->tolerance);
    fmpq_clear(c->eta);
    free(c->disagreements);
    free(c->explain_options);
    free(c->golden_columns);
    free(c->candidate_columns);
    free(c->golden);
    free(c->candidate);
    free(c->solid);
    free(c->motion);
}
