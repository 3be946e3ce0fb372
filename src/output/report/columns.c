/* The table of columns. SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/report/row_parts.h"

#include <string.h>

static graze_status find_distance(row *r, graze_context *context) {
    return distance_find(&r->space, context, r->scene, r->point, r->trace, r->shown->sdf);
}

static void put_diagonal(text *out, graze_context *context, const graze_scene *scene) {
    double diagonal;
    if (!distance_diagonal(&diagonal, context, scene))
        report_put_width(out, "diagonal", diagonal, 0);
}

static graze_status find_boundary(row *r, graze_context *context) {
    return distance_to_boundary(&r->boundary, context, r->scene, r->point, r->trace->verdict.pmc,
                                &r->space);
}

static void put_boundary(text *out, const row *r) {
    char decimal[BOUND_ROOM];
    report_bound(decimal, r->boundary, 0);
    text_format(out, ",%s", decimal);
}

static void json_boundary(json_writer *w, const row *r) {
    json_bound(w, "boundary_low", r->boundary, 0);
}

/* Does the point have the same pmc for every motion within the error? */
static const char *certain_word(const row *r) {
    return distance_is_certain(&r->space, r->shown->motion_error) ? "yes" : "undecided";
}

static void json_certain(json_writer *w, const row *r) {
    json_text(w, "certain", certain_word(r));
}

static graze_status find_topo(row *r, graze_context *context) {
    return topo_decide(&r->topo, context, r->scene, r->point, r->trace);
}

static const char *topo_word(const row *r) {
    return graze_topo_name(r->topo.position);
}

static void json_topo(json_writer *w, const row *r) {
    json_position(w, "topo", topo_word(r), &r->topo, r->scene->motion->dimension);
}

static graze_status find_regular(row *r, graze_context *context) {
    return topo_regular(&r->regular, context, r->scene, r->point, r->trace);
}

static const char *regular_word(const row *r) {
    return graze_regular_name(r->regular.position);
}

static void json_regular(json_writer *w, const row *r) {
    json_position(w, "regular", regular_word(r), &r->regular, r->scene->motion->dimension);
}

#define MEMBER(name) .at = offsetof(graze_row_options, name)

/* All sets, in the order of their columns. */
static const column_set column_sets[] = {
    {.option = "sdf",
     MEMBER(sdf),
     .asked = ASKED_BY_WIDTH_DOWN,
     .needs = NEEDS_CONTACTS,
     .at_rest = 1,
     .compared = 1,
     .names = {{"sdf_low", 0}, {"sdf_high", 0}, {"sdf_t", '!'}},
     .kind = TYPED_DOUBLE,
     .find = find_distance,
     .put = report_distance,
     .json = json_distance,
     .note = put_diagonal},
    {.option = "boundary-distance",
     MEMBER(boundary),
     .beside_sdf = 1,
     .names = {{"boundary_low", 0}},
     .kind = TYPED_DOUBLE,
     .find = find_boundary,
     .put = put_boundary,
     .json = json_boundary},
    {.option = "motion-error",
     MEMBER(motion_error),
     .asked = ASKED_BY_WIDTH_UP,
     .beside_sdf = 1,
     .names = {{"certain", 0}},
     .kind = TYPED_WORD,
     .word = certain_word,
     .json = json_certain},
    {.option = "moments",
     MEMBER(moments),
     .needs = NEEDS_CONTACTS,
     .is_exact = 1,
     .names = {{"first", 0},
               {"first_near", '?'},
               {"first_piece", 0},
               {"first_row", '*'},
               {"last", 0},
               {"last_near", '?'},
               {"last_piece", 0},
               {"last_row", '*'}},
     .find = inside_find,
     .put = inside_csv,
     .json = inside_json},
    {.option = "topo",
     MEMBER(topo),
     .needs = NEEDS_WORD,
     .undecided = "the position",
     .compared = 1,
     .names = {{"topo", 0}},
     .kind = TYPED_WORD,
     .find = find_topo,
     .word = topo_word,
     .json = json_topo},
    {.option = "regular",
     MEMBER(regular),
     .needs = NEEDS_WORD,
     .undecided = "regular",
     .names = {{"regular", 0}},
     .kind = TYPED_WORD,
     .find = find_regular,
     .word = regular_word,
     .json = json_regular},
};

int columns_flag(const column_set *set, const graze_row_options *shown) {
    return *(const int *)(const void *)((const char *)shown + set->at);
}

double columns_width(const column_set *set, const graze_row_options *shown) {
    return *(const double *)(const void *)((const char *)shown + set->at);
}

enum { COLUMN_SETS = sizeof column_sets / sizeof *column_sets };

/* Was the set asked for? */
static int is_wanted(const column_set *set, const graze_row_options *shown) {
    return set->asked == ASKED_BY_FLAG ? columns_flag(set, shown) != 0
                                       : columns_width(set, shown) != 0;
}

const column_set *columns_next(const column_set *last, const graze_row_options *shown) {
    const column_set *next = last ? last + 1 : column_sets;
    while (next < column_sets + COLUMN_SETS && !is_wanted(next, shown))
        next++;
    return next < column_sets + COLUMN_SETS ? next : NULL;
}

unsigned columns_of_line(field line) {
    field key, value;
    if (!line.length || *line.start != '#')
        return 0;
    field_note(&key, &value, line);
    for (unsigned k = 0; k < COLUMN_SETS && value.length; k++)
        if (field_is(key, column_sets[k].option))
            return column_sets[k].asked != ASKED_BY_FLAG || field_is(value, "yes") ? 1u << k : 0;
    return 0;
}

size_t columns_names(const column_label *out[COLUMNS_MOST], unsigned sets) {
    size_t count = 0;
    for (unsigned k = 0; k < COLUMN_SETS; k++)
        for (const column_label *l = column_sets[k].names; sets >> k & 1 && l->name; l++)
            out[count++] = l;
    return count;
}

known_column columns_known(size_t k) {
    for (unsigned set = 0; set < COLUMN_SETS; set++)
        for (const column_label *l = column_sets[set].names; l->name; l++)
            if (k-- == 0)
                return (known_column){&column_sets[set], l->name, 1u << set};
    return (known_column){NULL, NULL, 0};
}

size_t columns_place(const char *option) {
    size_t k = 0;
    for (const column_set *set = column_sets; strcmp(set->option, option) != 0; set++)
        for (const column_label *l = set->names; l->name; l++)
            k++;
    return k;
}

size_t columns_kinds(typed_kind out[COLUMNS_MOST], const graze_row_options *shown) {
    size_t count = 0;
    for (const column_set *set = NULL; (set = columns_next(set, shown));)
        for (const column_label *l = set->names; l->name; l++)
            if (!shown->at_rest || l->mark != '!')
                out[count++] = set->kind;
    return count;
}

void columns_put_names(text *out, const graze_scene *scene, const graze_row_options *shown) {
    for (const column_set *set = NULL; (set = columns_next(set, shown));)
        for (const column_label *l = set->names; l->name; l++)
            if (!(l->mark == '*' && !scene->motion->has_rows) &&
                !(l->mark == '!' && shown->at_rest))
                text_format(out, ",%s", l->name);
}
