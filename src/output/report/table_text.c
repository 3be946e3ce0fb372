/* The CSV table: its head and its rows (src/program/cli/formats.md, Tables).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */

#include "output/report/table_text.h"

#include "output/report/enclosure.h"

static void put_hash(text *t, const char *key, const unsigned char sha256[32]) {
    int given = 0;
    for (int k = 0; k < 32; k++)
        given |= sha256[k];
    text_format(t, "# %s ", key);
    for (int k = 0; given && k < 32; k++)
        text_format(t, "%02x", sha256[k]);
    text_put(t, given ? "\n" : "none\n");
}

/* A line of a number that is not 0. */
static void put_width(text *t, const char *name, double width, int up) {
    char number[BOUND_ROOM];
    if (!(width > 0))
        return;
    report_width(number, width, up);
    text_format(t, "# %s %s\n", name, number);
}

void table_notes(text *t, graze_context *context, const graze_scene *scene, const char *notes) {
    const graze_options *options = &scene->options;
    int unsweep = options->operation == GRAZE_UNSWEEP;
    text_put(t, "# graze " GRAZE_VERSION "\n# contract 1\n");
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
    put_width(t, "sdf", scene->tolerance, 1);
    put_width(t, "motion-error", options->motion_error, 0);
    if (options->topo)
        text_put(t, "# topo yes\n");
    if (options->columns == GRAZE_COLUMNS_PMC)
        text_put(t, "# columns pmc\n");
    if (notes)
        text_put(t, notes);
    text_format(t, "# ends-meet %s\n", scene->ends_meet ? "yes" : "no");
}

graze_status report_header(char **out, graze_context *context, const graze_scene *scene,
                           const char *notes, const char *columns) {
    const graze_options *options = &scene->options;
    int unsweep = options->operation == GRAZE_UNSWEEP, d = scene->motion->dimension;
    text t;
    text_init(&t);
    table_notes(&t, context, scene, notes);
    text_put(&t, d == 2 ? "x,y" : "x,y,z");
    text_put(&t, options->columns == GRAZE_COLUMNS_PMC ? ",pmc"
                 : unsweep                             ? ",pmc,word"
                                                       : ",pmc,class,definition,case,i,t,word");
    if (columns) {
        text_put(&t, ",");
        text_put(&t, columns);
    }
    if (scene->tolerance > 0)
        text_put(&t, ",sdf_low,sdf_high,sdf_t");
    if (options->motion_error > 0)
        text_put(&t, ",certain");
    if (options->topo)
        text_put(&t, ",topo");
    text_put(&t, "\n");
    return text_finish(out, context, &t);
}

/* class, definition, case, i, t */
static void put_verdict(text *t, const graze_verdict *v) {
    text_put(t, graze_class_name(v->class_));
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

void report_csv(text *out, const graze_scene *scene, const fmpq *point, const graze_trace *trace,
                const char *rest, const topo_finding *topo, const distance *found) {
    for (int k = 0; k < scene->motion->dimension; k++) {
        text_rational(out, point + k);
        text_put(out, ",");
    }
    text_put(out, graze_pmc_name(trace->verdict.pmc));
    if (scene->options.columns == GRAZE_COLUMNS_ALL) {
        text_put(out, ",");
        if (scene->options.operation == GRAZE_SWEEP)
            put_verdict(out, &trace->verdict);
        text_put(out, trace->word);
    }
    if (rest) {
        text_put(out, ",");
        text_put(out, rest);
    }
    if (found)
        report_distance(out, scene, found);
    if (topo) {
        text_put(out, ",");
        text_put(out, graze_topo_name(topo->position));
    }
    text_put(out, "\n");
}
