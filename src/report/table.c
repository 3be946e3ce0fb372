/* The CSV table: its head and its rows (formats: Results).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "report/report.h"

static void put_hash(text *t, const char *key, const unsigned char sha256[32]) {
    int given = 0;
    for (int k = 0; k < 32; k++)
        given |= sha256[k];
    text_format(t, "# %s ", key);
    for (int k = 0; given && k < 32; k++)
        text_format(t, "%02x", sha256[k]);
    text_put(t, given ? "\n" : "none\n");
}

static const char *rounding_name(graze_rounding rounding) {
    return rounding == GRAZE_ROUND_BINARY64   ? "binary64"
           : rounding == GRAZE_ROUND_BINARY32 ? "binary32"
                                              : "none";
}

graze_status report_header(char **out, graze_context *context, const graze_scene *scene,
                           const char *notes, const char *columns) {
    const graze_options *options = &scene->options;
    int unsweep = options->operation == GRAZE_UNSWEEP, d = scene->motion->dimension;
    text t;
    text_init(&t);
    text_put(&t, "# graze " GRAZE_VERSION "\n# contract 1\n");
    text_format(&t, "# dimension %d\n", d);
    put_hash(&t, "solid-sha256", scene->solid->input.sha256);
    put_hash(&t, "motion-sha256", scene->motion->sha256);
    put_hash(&t, "scene-sha256", scene->sha256);
    text_format(&t, "# operation %s\n", unsweep ? "unsweep" : "sweep");
    text_format(&t, "# overlap %s\n",
                options->overlap == GRAZE_OVERLAP_REJECT ? "reject" : "extend");
    text_format(&t, "# folds %s\n",
                options->folds == GRAZE_FOLDS_COMBINED ? "combined" : "separate");
    text_format(&t, "# round %s\n", rounding_name(context->rounding));
    if (notes)
        text_put(&t, notes);
    text_format(&t, "# ends-meet %s\n", scene->ends_meet ? "yes" : "no");
    text_put(&t, d == 2 ? "x,y" : "x,y,z");
    text_put(&t, unsweep ? ",pmc,word" : ",pmc,class,definition,case,i,t,word");
    if (columns) {
        text_put(&t, ",");
        text_put(&t, columns);
    }
    text_put(&t, "\n");
    return text_finish(out, context, &t);
}

graze_status report_csv(char **out, graze_context *context, const graze_scene *scene,
                        const fmpq *point, const graze_trace *trace, const char *rest) {
    const graze_verdict *v = &trace->verdict;
    text t;
    text_init(&t);
    for (int k = 0; k < scene->motion->dimension; k++) {
        text_rational(&t, point + k);
        text_put(&t, ",");
    }
    text_put(&t, graze_pmc_name(v->pmc));
    if (scene->options.operation == GRAZE_SWEEP) {
        text_format(&t, ",%s,", graze_class_name(v->class_));
        if (v->definition)
            text_format(&t, "%d", v->definition);
        else
            text_put(&t, "ext");
        text_format(&t, ",%d,%lu,%lu", v->case_, v->i, v->t);
    }
    text_put(&t, ",");
    text_put(&t, trace->word);
    if (rest) {
        text_put(&t, ",");
        text_put(&t, rest);
    }
    text_put(&t, "\n");
    return text_finish(out, context, &t);
}
