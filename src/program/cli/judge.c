/* graze judge: how far a mesh is from the boundary of a sweep.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "program/cli/values.h"

#include <float.h>
#include "base/context/scope.h"

HELP(judge);

/* Default number of generated points, and number of disagreements shown. */
enum { DEFAULT_POINTS = 1000, POINTS_SHOWN = 5 };

/* For the page's colours, distances are enclosed to the width divided by this number. */
static const double PAGE_SHARE = 64;

typedef struct judge_given {
    scene_options scene; /* rows.sdf is the width */
    unsigned long budget;
    const char *fail_above, *points, *vertices, *answers, *page;
    unsigned long count;
    seed_value seed;
    int on_as; /* a graze_on_as plus 1; 0: not given */
    int no_points, jobs;
    graze_judgement_format format;
} judge_given;

static option_read value_form;
VALUE_OF_WORDS(value_form, graze_judgement_format, "text", "markdown", "json")

static int value_on_as_given(void *to, const char *name, const char *value) {
    graze_on_as on_as = GRAZE_ON_AS_ANY;
    int status = value_on_as(&on_as, name, value);
    *(int *)to = (int)on_as + 1;
    return status;
}

static const option_entry judge_table[] = {
    OPTION("within", judge_given, scene, value_sdf),
    OPTION("budget", judge_given, budget, value_count),
    FILE_READ("points", judge_given, points),
    FILE_WRITTEN("answers", judge_given, answers),
    FILE_WRITTEN("vertices", judge_given, vertices),
    FILE_WRITTEN("page", judge_given, page),
    OPTION("count", judge_given, count, value_count),
    OPTION("seed", judge_given, seed, value_seed),
    FLAG("no-points", judge_given, no_points, value_flag),
    OPTION("on-as", judge_given, on_as, value_on_as_given),
    OPTION("jobs", judge_given, jobs, value_jobs),
    OPTION("fail-above", judge_given, fail_above, value_width),
    OPTION("format", judge_given, format, value_form),
    SOLID_OPTIONS(judge_given, scene.solid_flags, scene.context),
    OPTIONS_END};

static int print_judgement(graze_context *context, const graze_judgement *judgement,
                           const graze_comparison *points, const judge_given *o) {
    FREED(char, report, NULL);
    TRY(complain_of(graze_judgement_report(&report, context, judgement, points, o->format),
                    context));
    return output_text(NULL, report);
}

/* Is one of the judged distances certainly more than the limit, the text of a valid number? */
static int is_too_far(graze_context *context, const graze_judgement *judgement, const char *limit) {
    int far = 0;
    LOCAL(mpq, most);
    LOCAL(mpq, low);
    graze_status status = graze_number_parse(most, context, limit, strlen(limit));
    for (int k = 0; k < GRAZE_JUDGED_COUNT && !status; k++) {
        double least = graze_judgement_distance(judgement, (graze_judged)k).low;
        if (least <= DBL_MAX)
            mpq_set_d(low, least);
        far |= least > DBL_MAX || mpq_cmp(low, most) > 0;
    }
    return far;
}

/* Write the mesh's answers at the given points as a file. */
static int write_mesh_answers(const loaded *l, const judge_given *o, const graze_mesh *mesh,
                              const marks *given) {
    graze_mesh_rule rule = graze_mesh_get_facts(mesh).rule;
    if (rule == GRAZE_MESH_NONE)
        return complain(
            EXIT_INPUT,
            "--answers %s: the mesh is not closed and has no answers; expected a closed "
            "one, or no --answers",
            o->answers);
    FREED(graze_pmc, found, calloc(given->count + 1, sizeof *found));
    if (!found)
        return complain(EXIT_IO, "out of memory for %zu points", given->count);
    graze_rationals points = (graze_rationals)given->value;
    TRY(complain_of(graze_mesh_answers(found, l->context, mesh, points, given->count, o->jobs),
                    l->context));
    return answer_table_write(o->answers, rule == GRAZE_MESH_PARITY, points, found, given->count);
}

/* Compare the mesh's answers at points with the exact ones; a mesh without an inside is left out.
 */
static int ask_mesh_points(graze_comparison **out, const loaded *l, const judge_given *o,
                           const graze_mesh *mesh, const marks *given) {
    graze_mesh_points asked = {.size = sizeof asked,
                               .count = o->count ? o->count : DEFAULT_POINTS,
                               .seed = o->seed.given ? o->seed.seed : 1,
                               .on_as = o->on_as ? (graze_on_as)(o->on_as - 1) : GRAZE_ON_AS_ANY,
                               .show = POINTS_SHOWN,
                               .threads = o->jobs,
                               .solid = o->scene.solid,
                               .motion = o->scene.motion};
    if (o->no_points || graze_mesh_get_facts(mesh).rule == GRAZE_MESH_NONE)
        return EXIT_DONE;
    if (o->points) {
        asked.points = (graze_rationals)given->value;
        asked.count = given->count;
    }
    return complain_of(graze_compare_mesh(out, l->context, l->scene, mesh, &asked), l->context);
}

/* Find the distances of all vertices, and write them as a table, in a page, or both. */
static int write_vertices(const loaded *l, const judge_given *o, const graze_mesh *mesh,
                          const graze_judgement *judgement) {
    size_t count = graze_mesh_get_facts(mesh).vertices;
    FREED(graze_enclosure, found, calloc(count + 1, sizeof *found));
    if (!found)
        return complain(EXIT_IO, "out of memory for %zu vertices", count);
    double width = o->page ? l->rows.sdf / PAGE_SHARE : l->rows.sdf;
    TRY(complain_of(graze_mesh_distances(found, l->context, l->scene, mesh, width, o->jobs),
                    l->context));
    if (o->vertices)
        TRY(vertex_table_write(o->vertices, l->context, mesh, found));
    if (!o->page)
        return EXIT_DONE;
    return complain_of(graze_judgement_draw(l->context, l->scene, judgement, o->page, found, NULL),
                       l->context);
}

/* Does the mesh face inward, or overlap itself? */
static int is_wound_wrongly(const graze_mesh *mesh) {
    int least, most;
    return graze_mesh_windings(&least, &most, mesh) && (least < 0 || most > 1);
}

static int judge_mesh(const loaded *l, const judge_given *o, const char *path) {
    OWNED(graze_mesh, mesh);
    OWNED(graze_judgement, judgement);
    OWNED(graze_comparison, points);
    ZEROED(marks, given);
    given.dimension = 3;
    graze_judge_options options = {
        .size = sizeof options, .within = l->rows.sdf, .budget = o->budget, .threads = o->jobs};
    TRY(complain_of(graze_mesh_read(&mesh, l->context, path, o->scene.solid_flags), l->context));
    if (o->points)
        TRY(marks_read(&given, o->points, l->context));
    if (o->answers)
        TRY(write_mesh_answers(l, o, mesh, &given));
    TRY(complain_of(graze_judge(&judgement, l->context, l->scene, mesh, &options), l->context));
    if (o->vertices || o->page)
        TRY(write_vertices(l, o, mesh, judgement));
    TRY(ask_mesh_points(&points, l, o, mesh, &given));
    TRY(print_judgement(l->context, judgement, points, o));
    int is_wrong = o->fail_above &&
                   (is_wound_wrongly(mesh) || is_too_far(l->context, judgement, o->fail_above));
    return is_wrong ? EXIT_NO : EXIT_DONE;
}

static int run_judge(void *options, const operands *given) {
    judge_given *o = options;
    o->page = output_name(o->page, "-.html");
    o->vertices = output_name(o->vertices, "-.csv");
    TRY(value_ends_in("page", o->page, ".html"));
    if (o->answers && !o->points)
        return complain(EXIT_USAGE, "--answers needs points; expected --points beside it");
    TRY(value_ends_in("vertices", o->vertices, ".csv or .vtk"));
    scene_files(&o->scene, given);
    double within = o->scene.rows.sdf > 0 ? o->scene.rows.sdf : 1e-2;
    int relative = o->scene.sdf_relative || !(o->scene.rows.sdf > 0);
    o->scene.rows.sdf = o->scene.sdf_relative = 0; /* the width is for the judgement alone */
    ZEROED(loaded, l);
    TRY(loaded_read(&l, &o->scene, EXIT_INPUT, NULL));
    TRY(load_takes(l.solid, given->item[0], "judge", TAKES_POLYHEDRA));
    l.rows.sdf = within;
    if (relative)
        TRY(complain_of(graze_scene_width(&l.rows.sdf, l.context, l.scene, within), l.context));
    return judge_mesh(&l, o, given->item[2]);
}

COMMAND(judge, judge_given, .takes = "SOLID, MOTION and MESH", .least = 3, .reads = 3);
