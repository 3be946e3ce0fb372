/* The table: its head and its rows (src/program/cli/formats.md, Tables).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */

#include "output/report/report.h"

#include <string.h>
#include "base/context/scope.h"
#include "decide/scene/scene.h"
#include "output/report/row_parts.h"
#include "output/table/table.h"
#include "questions/distance/distance.h"

static void put_hash(text *t, const char *key, const unsigned char sha256[32]) {
    int given = 0;
    for (int k = 0; k < 32; k++)
        given |= sha256[k];
    text_format(t, "# %s ", key);
    for (int k = 0; given && k < 32; k++)
        text_format(t, "%02x", sha256[k]);
    text_put(t, given ? "\n" : "none\n");
}

/* Append a `#` line with a number, unless that is 0. */
static void put_width(text *t, const char *name, double width, int up) {
    char number[BOUND_ROOM];
    if (!(width > 0))
        return;
    report_width(number, width, up);
    text_format(t, "# %s %s\n", name, number);
}

/* Append the `#` lines. */
static void put_notes(text *t, graze_context *context, const graze_scene *scene, const char *notes,
                      const graze_row_options *shown) {
    const graze_options *options = &scene->options;
    int unsweep = options->operation == GRAZE_UNSWEEP;
    double diagonal;
    text_format(t, "# graze " GRAZE_VERSION "\n# contract %d\n", scene->solid->curved ? 2 : 1);
    text_format(t, "# dimension %d\n", scene->motion->dimension);
    put_hash(t, "solid-sha256", scene->solid->input.sha256);
    put_hash(t, "motion-sha256", scene->motion->sha256);
    put_hash(t, "scene-sha256", scene->sha256);
    text_format(t, "# operation %s\n", unsweep ? "unsweep" : "sweep");
    text_format(t, "# overlap %s\n",
                options->overlap == GRAZE_OVERLAP_REJECT ? "reject" : "extend");
    text_format(t, "# folds %s\n",
                options->folds == GRAZE_FOLDS_COMBINED ? "combined" : "separate");
    text_format(t, "# round %s\n", graze_rounding_name(context->rounding));
    put_width(t, "sdf", shown->sdf, 1);
    if (shown->sdf > 0 && !distance_diagonal(&diagonal, context, scene))
        put_width(t, "diagonal", diagonal, 0);
    if (shown->boundary)
        text_put(t, "# boundary-distance yes\n");
    put_width(t, "motion-error", shown->motion_error, 0);
    if (shown->moments)
        text_put(t, "# moments yes\n");
    if (shown->topo)
        text_put(t, "# topo yes\n");
    if (shown->regular)
        text_put(t, "# regular yes\n");
    if (shown->columns == GRAZE_COLUMNS_PMC)
        text_put(t, "# columns pmc\n");
    if (notes)
        text_put(t, notes);
    text_format(t, "# ends-meet %s\n",
                scene->ends == GRAZE_ENDS_UNDECIDED ? "undecided"
                : scene->ends == GRAZE_ENDS_MEET    ? "yes"
                                                    : "no");
}

void table_columns(text *t, const graze_scene *scene, const char *columns,
                   const graze_row_options *shown) {
    text_put(t, scene->motion->dimension == 2 ? "x,y,pmc" : "x,y,z,pmc");
    if (shown->columns == GRAZE_COLUMNS_ALL)
        text_put(t, scene->options.operation == GRAZE_UNSWEEP ? ",word"
                                                              : ",class,definition,case,i,t,word");
    if (columns) {
        text_put(t, ",");
        text_put(t, columns);
    }
    if (shown->sdf > 0)
        text_put(t, ",sdf_low,sdf_high,sdf_t");
    if (shown->boundary)
        text_put(t, ",boundary_low");
    if (shown->motion_error > 0)
        text_put(t, ",certain");
    if (shown->moments)
        inside_columns(t, scene->motion);
    if (shown->topo)
        text_put(t, ",topo");
    if (shown->regular)
        text_put(t, ",regular");
}

graze_status report_header(char **out, graze_context *context, const graze_scene *scene,
                           const char *notes, const char *columns, const graze_row_options *shown) {
    text t;
    text_init(&t);
    put_notes(&t, context, scene, notes, shown);
    table_columns(&t, scene, columns, shown);
    text_put(&t, "\n");
    return text_finish(out, context, &t);
}

graze_status table_head(char **out, graze_context *context, const graze_scene *scene,
                        const char *notes, const char *names, const char *further) {
    text t;
    text_init(&t);
    put_notes(&t, context, scene, notes, &(graze_row_options){0});
    text_put(&t, names);
    if (further)
        text_put(&t, ",");
    text_put(&t, further ? further : "");
    text_put(&t, "\n");
    return text_finish(out, context, &t);
}

/* class, definition, case, i, t */
static void put_verdict(text *t, const graze_verdict *v) {
    text_put(t, graze_class_name(v->class_));
    if (v->class_ == GRAZE_CLASS_UNDECIDED) {
        text_put(t, ",,,,,");
        return;
    }
    text_put(t, ",");
    if (v->definition)
        text_count(t, (unsigned long)v->definition);
    else
        text_put(t, "ext");
    text_put(t, ",");
    text_count(t, (unsigned long)v->case_);
    text_put(t, ",");
    text_count(t, v->i);
    text_put(t, ",");
    text_count(t, v->t);
    text_put(t, ",");
}

static void put_boundary(text *t, double low) {
    char decimal[BOUND_ROOM];
    report_bound(decimal, low, 0);
    text_format(t, ",%s", decimal);
}

/* Append the columns behind the answers, a comma before each. */
static void put_further(text *out, const row *r) {
    if (r->texts.rest) {
        text_put(out, ",");
        text_put(out, r->texts.rest);
    }
    if (r->shown->sdf > 0)
        report_distance(out, r->scene, &r->space);
    if (r->shown->boundary)
        put_boundary(out, r->boundary);
    if (r->shown->motion_error > 0)
        text_format(out, ",%s", report_certainty(&r->space, r->shown->motion_error));
    if (r->shown->moments)
        inside_csv(out, &r->inside, r->scene->motion);
    if (r->shown->topo) {
        text_put(out, ",");
        text_put(out, graze_topo_name(r->topo.position));
    }
    if (r->shown->regular) {
        text_put(out, ",");
        text_put(out, graze_regular_name(r->regular.position));
    }
}

void report_csv(text *out, const row *r) {
    for (int k = 0; !r->texts.point && k < r->scene->motion->dimension; k++) {
        text_put(out, k ? "," : "");
        text_rational(out, r->point + k);
    }
    text_put(out, r->texts.point ? r->texts.point : "");
    text_put(out, ",");
    text_put(out, graze_pmc_name(r->trace->verdict.pmc));
    if (r->shown->columns == GRAZE_COLUMNS_ALL) {
        text_put(out, ",");
        if (r->scene->options.operation == GRAZE_SWEEP)
            put_verdict(out, &r->trace->verdict);
        text_put(out, r->trace->word);
    }
    put_further(out, r);
    text_put(out, "\n");
}

graze_status report_values(text *out, graze_context *context, const row *r) {
    const graze_verdict *v = &r->trace->verdict;
    graze_status status = GRAZE_OK;
    for (int k = 0; k < r->scene->motion->dimension && !status; k++) {
        double nearest = 0;
        status = values_nearest(&nearest, context, r->point + k);
        if (status)
            status = context_at(context, status, "column %c", 'x' + k);
        values_coordinate(out, nearest);
    }
    values_code(out, (uint32_t)v->pmc);
    if (r->shown->columns == GRAZE_COLUMNS_ALL) {
        const uint32_t codes[] = {(uint32_t)v->class_, (uint32_t)v->definition, (uint32_t)v->case_,
                                  (uint32_t)v->i, (uint32_t)v->t};
        for (size_t k = 0; r->scene->options.operation == GRAZE_SWEEP && k < 5; k++)
            values_code(out, codes[k]);
        values_text(out, r->trace->word, strlen(r->trace->word));
    }
    HELD(text, further);
    put_further(&further, r);
    if (further.length) /* without the comma before them */
        values_text(out, further.data + 1, further.length - 1);
    out->failed |= further.failed;
    return status;
}
