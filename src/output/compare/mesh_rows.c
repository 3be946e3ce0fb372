/* Asks a mesh and the scene about points, in threads, and counts in the order of the points.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/context/scope.h"

#include "base/context/team.h"
#include "decide/verdict/verdict.h"
#include "output/compare/judgement.h"

/* The exact answer and the mesh's answer at a point. */
typedef struct mesh_row {
    graze_pmc golden;
    mesh_place place;
    long winding;
    graze_stratum stratum;
} mesh_row;

typedef struct mesh_run {
    graze_context *context;
    const graze_scene *scene;
    const judged_mesh *mesh;
    const mesh_points *points;
    mesh_row *row;
} mesh_run;

/* Find the point of a row; a generated point is borrowed from the sample. */
static graze_status point_of(const fmpq **point, sample *s, graze_context *context,
                             const mesh_points *points, size_t row) {
    *point = points->generator ? s->point : points->point + 3 * row;
    return points->generator ? generator_sample(s, context, points->generator, row) : GRAZE_OK;
}

static graze_status ask_both(void *data, graze_context *context, int member, size_t index) {
    const mesh_run *r = data;
    mesh_row *row = &r->row[index];
    const fmpq *point;
    graze_verdict verdict = {0};
    HELD(sample, s);
    (void)member;
    TRY(point_of(&point, &s, context, r->points, index));
    TRY(classify_answer(&verdict, context, r->scene, (query_point){.rational = point}, TRACE_PMC));
    row->golden = verdict.pmc;
    row->stratum = s.made.stratum;
    row->place = judged_place(&row->winding, r->mesh, point);
    return GRAZE_OK;
}

/* The golden answer, if it is decided, as an index into pmc_words; places of meshes are such
 * indices too. */
static int golden_of(const mesh_row *row) {
    return (int)row->golden - (int)GRAZE_IN;
}

/* Judge a row whose golden answer is decided. */
static judgement judge_row(const graze_comparison *c, const mesh_row *row) {
    judgement j = {.truth = golden_of(row)};
    int given = (int)row->place, apart = given == PMC_ON && j.truth != PMC_ON;
    judge_pmc(&j, c->options.on_as, given);
    if (apart)
        j.wrong_as[GRAZE_ON_AS_ANY] = 0;
    if (apart && c->options.on_as == GRAZE_ON_AS_ANY) {
        j.wrong[COLUMN_PMC] = j.any_wrong = 0;
        j.undecided = 1;
    }
    return j;
}

/* Append coordinates with `between` between them. */
static void put_mesh_point(text *out, const fmpq *point, const char *between) {
    for (int i = 0; i < 3; i++) {
        text_put(out, i ? between : "");
        text_rational(out, point + i);
    }
}

/* Append an answer: the text `pmc` and its pmc; of the mesh also the text `winding` and its winding
 * number, if the mesh has winding numbers. */
static void put_row_answer(text *out, const mesh_run *r, const mesh_row *row, int golden,
                           const char *pmc, const char *winding) {
    text_format(out, "%s%s", pmc, pmc_words[golden ? golden_of(row) : (int)row->place]);
    if (!golden && r->mesh->rule == GRAZE_MESH_WINDING)
        text_format(out, "%s%ld", winding, row->winding);
}

/* Append a row as in a table with the columns that describe() names. */
static void put_mesh_row(text *out, const mesh_run *r, size_t index, const fmpq *point,
                         int golden) {
    const mesh_row *row = &r->row[index];
    text_format(out, "%zu,", index);
    put_mesh_point(out, point, ",");
    if (golden && r->points->generator)
        text_format(out, ",%s", stratum_name(row->stratum));
    put_row_answer(out, r, row, golden, ",", ",");
}

static graze_status keep_row(graze_comparison *c, const mesh_run *r, size_t index) {
    disagreement *d;
    const fmpq *point;
    HELD(sample, s);
    TRY(point_of(&point, &s, r->context, r->points, index));
    graze_status status = comparison_keep(&d, c, r->context, golden_of(&r->row[index]));
    if (!d)
        return status;
    d->row = index;
    if (r->points->generator && !(d->stratum = strdup(stratum_name(r->row[index].stratum))))
        status = comparison_no_memory(r->context);
    text t[5];
    char **to[5] = {&d->point, &d->golden, &d->candidate, &d->golden_row, &d->candidate_row};
    for (int k = 0; k < 5; k++)
        text_init(&t[k]);
    put_mesh_point(&t[0], point, " ");
    put_row_answer(&t[1], r, &r->row[index], 1, "pmc=", "");
    put_row_answer(&t[2], r, &r->row[index], 0, "pmc=", " winding=");
    put_mesh_row(&t[3], r, index, point, 1);
    put_mesh_row(&t[4], r, index, point, 0);
    for (int k = 0; k < 5; k++)
        if (!(*to[k] = text_take(&t[k])))
            status = comparison_no_memory(r->context);
    return status;
}

static graze_status count_mesh_row(graze_comparison *c, const mesh_run *r, size_t index) {
    const mesh_row *row = &r->row[index];
    judgement j = {.undecided = 1};
    int given = (int)row->place;
    if (row->golden == GRAZE_PMC_UNDECIDED) {
        c->open++;
        c->undecided_answers[given]++;
    } else {
        j = judge_row(c, row);
        c->confusion.pmc[j.truth][given]++;
        c->golden_on += j.truth == PMC_ON;
        c->apart += (unsigned long)j.undecided;
    }
    c->answered_on += given == PMC_ON;
    char what = comparison_count(c, &j, 1);
    if (r->points->generator) {
        const char *name = stratum_name(row->stratum);
        TRY(tally_add(&c->tallies[BY_STRATUM], r->context, (field){name, strlen(name)}, what,
                      NULL));
    }
    return what == 'w' ? keep_row(c, r, index) : GRAZE_OK;
}

/* Set names and columns of the golden side and the mesh's side for the report. */
static graze_status describe(graze_comparison *c, const mesh_run *r,
                             const graze_compare_options *options) {
    HELD(text, golden);
    HELD(text, candidate);
    if (!comparison_begin(c, r->context, "", "", options))
        return comparison_no_memory(r->context);
    c->options.question = GRAZE_QUESTION_OPEN;
    c->options.has = GRAZE_HAS_COLUMNS;
    c->options.transient = 1;
    c->rounding = GRAZE_ROUND_NONE;
    c->of_mesh = 1;
    c->judged[COLUMN_PMC] = 1;
    c->grouped[BY_STRATUM] = r->points->generator != NULL;
    text_format(&golden, "id,x,y,z%s,pmc", c->grouped[BY_STRATUM] ? ",stratum" : "");
    text_put(&candidate, "id,x,y,z,pmc");
    text_put(&candidate, r->mesh->rule == GRAZE_MESH_WINDING ? ",winding" : "");
    c->golden_columns = text_take(&golden);
    c->candidate_columns = text_take(&candidate);
    c->explain_options = strdup(r->points->explain_options ? r->points->explain_options : "");
    return c->golden_columns && c->candidate_columns && c->explain_options
               ? GRAZE_OK
               : comparison_no_memory(r->context);
}

graze_status comparison_of_mesh(graze_comparison *out, graze_context *context,
                                const graze_scene *scene, const judged_mesh *mesh,
                                const mesh_points *points, int threads,
                                const graze_compare_options *options) {
    mesh_run r = {context, scene, mesh, points, NULL};
    FREED(mesh_row, row, calloc(points->count + 1, sizeof *row));
    r.row = row;
    TRY(describe(out, &r, options));
    if (!row)
        return comparison_no_memory(context);
    TRY(team_run(context, threads, points->count, ask_both, &r));
    for (size_t k = 0; k < points->count; k++)
        TRY(count_mesh_row(out, &r, k));
    tally_sort(&out->tallies[BY_STRATUM]);
    return comparison_finish(out, context);
}
