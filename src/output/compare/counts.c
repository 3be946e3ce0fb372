/* Counts, disagreements kept and depths of a comparison.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/compare/compare.h"

#include <stdlib.h>
#include <string.h>
#include "base/context/array.h"
#include "base/context/scope.h"
#include "decide/filter/filter.h"
#include "output/compare/counts.h"

graze_status comparison_no_memory(graze_context *context) {
    return context_fail(context, GRAZE_ESYSTEM, "out of memory");
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
    for (int k = 0; answered && k < COLUMN_COUNT; k++)
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

/* The deepest wrong rows first, of equals the first; rows missing or extra last. */
static int by_rank(const void *a, const void *b) {
    const disagreement *x = a, *y = b;
    int by = (x->pmc < 0) - (y->pmc < 0);
    by = by ? by : ceiling_compare(y->depth, x->depth);
    return by ? by : (x->order > y->order) - (x->order < y->order);
}

/* Do the rows before a wrong row fill the share of its stratum? */
static int is_crowded(const disagreement *all, size_t count, const disagreement *d) {
    int same = 0;
    for (size_t k = 0; k < count && d->pmc >= 0 && d->stratum; k++)
        same += strcmp(all[k].stratum, d->stratum) == 0;
    return same >= MOST_OF_STRATUM;
}

/* Keep the disagreements to show. One that is dropped would be dropped after further rows too. */
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

/* Is a wrong row one of those that wait for their distance? */
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

/* Measure a wrong row, and put the enclosure behind its golden answers. */
static graze_status measure_row(disagreement *d, graze_comparison *c, graze_context *context) {
    depth_bounds found;
    HELD(text, all);
    TRY(depth_measure(&found, &c->depth, context, c->options.scene, d->point, d->pmc));
    d->depth = found.size;
    text_format(&all, "%s sdf_low=%s sdf_high=%s", d->golden, found.low, found.high);
    free(d->golden);
    d->golden = text_take(&all);
    return d->golden ? GRAZE_OK : comparison_no_memory(context);
}

graze_status comparison_finish(graze_comparison *c, graze_context *context) {
    c->by_depth = !c->contacts && (c->enclosed || c->options.scene);
    int measured = c->by_depth && !c->enclosed;
    graze_status status = measured ? depth_scale(&c->depth, context, c->options.scene) : GRAZE_OK;
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
    depth_clear(&c->depth);
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
