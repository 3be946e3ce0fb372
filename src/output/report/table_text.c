/* The table: its head and its rows (src/program/cli/formats.md, Tables).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/report/row_parts.h"

#include "base/context/scope.h"

static void put_hash(text *t, const char *key, const unsigned char sha256[32]) {
    int given = 0;
    for (int k = 0; k < 32; k++)
        given |= sha256[k];
    text_format(t, "# %s ", key);
    for (int k = 0; given && k < 32; k++)
        text_format(t, "%02x", sha256[k]);
    text_put(t, given ? "\n" : "none\n");
}

/* Append the `#` lines of a set of columns. */
static void put_column_note(text *t, graze_context *context, const graze_scene *scene,
                            const column_set *set, const graze_row_options *shown) {
    if (set->asked == ASKED_BY_FLAG)
        text_format(t, "# %s yes\n", set->option);
    else /* the decimal that the option rounds to this double */
        report_put_width(t, set->option, columns_width(set, shown),
                         set->asked == ASKED_BY_WIDTH_DOWN);
    if (set->note)
        set->note(t, context, scene);
}

/* Append the `#` lines. */
static void put_notes(text *t, graze_context *context, const graze_scene *scene, const char *notes,
                      const graze_row_options *shown) {
    const graze_options *options = &scene->options;
    int unsweep = options->operation == GRAZE_UNSWEEP, moves = !shown->at_rest;
    text_format(t, "# graze " GRAZE_VERSION "\n# contract %d\n", scene->solid->curved ? 2 : 1);
    text_format(t, "# dimension %d\n", scene->motion->dimension);
    put_hash(t, "solid-sha256", scene->solid->input.sha256);
    if (moves)
        put_hash(t, "motion-sha256", scene->motion->sha256);
    put_hash(t, "scene-sha256", scene->sha256);
    if (moves)
        text_format(t, "# operation %s\n# overlap %s\n# folds %s\n", unsweep ? "unsweep" : "sweep",
                    options->overlap == GRAZE_OVERLAP_REJECT ? "reject" : "extend",
                    options->folds == GRAZE_FOLDS_COMBINED ? "combined" : "separate");
    text_put(t, moves ? "" : "# at-rest yes\n");
    text_format(t, "# round %s\n", graze_rounding_name(context->rounding));
    for (const column_set *set = NULL; (set = columns_next(set, shown));)
        put_column_note(t, context, scene, set, shown);
    if (shown->columns == GRAZE_COLUMNS_PMC)
        text_put(t, "# columns pmc\n");
    if (notes)
        text_put(t, notes);
    if (moves)
        text_format(t, "# ends-meet %s\n",
                    scene->ends == GRAZE_ENDS_UNDECIDED ? "undecided"
                    : scene->ends == GRAZE_ENDS_MEET    ? "yes"
                                                        : "no");
}

void table_columns(text *t, const graze_scene *scene, const char *columns,
                   const graze_row_options *shown) {
    text_put(t, scene->motion->dimension == 2 ? "x,y" : "x,y,z");
    for (size_t k = 0; k < (shown->columns == GRAZE_COLUMNS_PMC ? 1 : ANSWER_COLUMNS); k++)
        if (scene->options.operation == GRAZE_SWEEP || answer_columns[k].of_unsweep)
            text_format(t, ",%s", answer_columns[k].name);
    if (columns) {
        text_put(t, ",");
        text_put(t, columns);
    }
    columns_put_names(t, scene, shown);
}

graze_status report_header(char **out, graze_context *context, const graze_scene *scene,
                           const char *notes, const char *columns, const graze_row_options *shown) {
    HELD(text, t);
    put_notes(&t, context, scene, notes, shown);
    table_columns(&t, scene, columns, shown);
    text_put(&t, "\n");
    return text_finish(out, context, &t);
}

#define SITE_ANSWERS                                                                               \
    "cell,role,theta,contact_order,orientation,left,right,trimmed,status,near,near_decimal,near_"  \
    "in,near_in_decimal,word"

const char contact_columns[] = "time,bx,by,bz,x,y,z," SITE_ANSWERS ",shift";

/* Columns in the plane and, where they differ, in space. */
static const char *const table_names[][2] = {
    [TABLE_EVENTS] = {"time,time_near,kind,facet,cell,before,after"},
    [TABLE_CURVES] = {"time,kind,cell,ax,ay,bx,by,theta_a,theta_b,orientation,status,chain,form",
                      "time,kind,cell,ax,ay,az,bx,by,bz,theta_a,theta_b,orientation,status,chain,"
                      "form"},
    [TABLE_PATCHES] = {"patch,kind,cell,from,from_near,to,to_near,a,b,theta_a,theta_b,orientation,"
                       "time,bx,by,x,y,status",
                       "patch,kind,cell,from,from_near,to,to_near,a,b,theta_a,theta_b,orientation,"
                       "time,bx,by,bz,x,y,z,status"},
    [TABLE_JOINTS] = {"cell,from,from_near,to,to_near,form,patches"},
    [TABLE_SITES] = {"time,bx,by,x,y," SITE_ANSWERS, "time,bx,by,bz,x,y,z," SITE_ANSWERS},
    [TABLE_ARCS] = {"arc,ring,from_x,from_y,to_x,to_y,kind,cell,piece,begin,end,in_x,in_y,out_x,"
                    "out_y"}};

graze_status report_table_head(char **out, graze_context *context, const graze_scene *scene,
                               report_table table, const char *notes, const char *further) {
    const char *const *names = table_names[table];
    HELD(text, t);
    put_notes(&t, context, scene, notes, &(graze_row_options){0});
    text_put(&t, names[1] && scene->motion->dimension == 3 ? names[1] : names[0]);
    if (further)
        text_format(&t, ",%s", further);
    text_put(&t, "\n");
    return text_finish(out, context, &t);
}

/* Append the fields class, definition, case, i, t. */
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
    if (r->texts.rest)
        text_format(out, ",%s", r->texts.rest);
    for (const column_set *set = NULL; (set = columns_next(set, r->shown));)
        if (set->put)
            set->put(out, r);
        else
            text_format(out, ",%s", set->word(r));
    text_put(out, "\n");
}

/* Add the values of a set's columns: a word, or the doubles nearest to the CSV fields. */
static graze_status put_set_values(text *out, graze_context *context, const row *r,
                                   const column_set *set) {
    if (set->word) {
        values_text(out, set->word(r), strlen(set->word(r)));
        return GRAZE_OK;
    }
    HELD(text, fields);
    set->put(&fields, r);
    field rest = {fields.data + 1, fields.length - 1}, one; /* without the comma before them */
    out->failed |= fields.failed;
    while (!fields.failed && rest.start && field_take(&one, &rest))
        TRY(values_field(out, context, one));
    return GRAZE_OK;
}

graze_status report_values(text *out, graze_context *context, const row *r) {
    const graze_verdict *v = &r->trace->verdict;
    for (int k = 0; k < r->scene->motion->dimension; k++) {
        double nearest = 0;
        graze_status status = values_nearest(&nearest, context, r->point + k);
        if (status)
            return context_at(context, status, "column %c", 'x' + k);
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
    if (r->texts.rest)
        values_text(out, r->texts.rest, strlen(r->texts.rest));
    for (const column_set *set = NULL; (set = columns_next(set, r->shown));)
        TRY(put_set_values(out, context, r, set));
    return GRAZE_OK;
}
