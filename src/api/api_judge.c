/* The public functions of meshes that are judged. SPDX-License-Identifier: GPL-3.0-or-later */
#include "api/api.h"

#include <math.h>
#include "base/context/team.h"
#include "base/number/rounding.h"
#include "input/read/read.h"
#include "output/compare/compare.h"
#include "questions/generate/generate.h"
#include "questions/judge/judge.h"

enum { DEFAULT_BUDGET = 10000000 };

/* Points that a mesh is asked about, at most. */
static const size_t MOST_POINTS = 1000000000;

/* The facts of a mesh whose soup is there. */
static graze_status mesh_of_soup(graze_mesh *m, graze_context *context, unsigned flags) {
    if (m->input.dimension != 3)
        return context_fail(context, GRAZE_EINPUT,
                            "polygons in the plane; expected a mesh in space");
    TRY(judged_mesh_make(&m->judged, context, &m->input, flags));
    judged_windings(&m->judged);
    return GRAZE_OK;
}

static graze_status mesh_from_file(graze_mesh *m, graze_context *context, const char *path,
                                   unsigned flags) {
    TRY(soup_read_any(&m->input, context, path));
    return context_in(context, mesh_of_soup(m, context, flags), path, 0);
}

graze_status graze_mesh_read(graze_mesh **out, graze_context *context, const char *path,
                             unsigned flags) {
    PUBLIC_OUT(out, context, path);
    REFUSED(flags & ~GRAZE_SOLID_TRIANGULATE, "an unknown flag is set");
    CREATE(out, made, graze_mesh_destroy, mesh_from_file(made, context, path, flags));
}

static graze_status take_triangles(soup *s, graze_context *context, const size_t *triangles,
                                   size_t count) {
    for (size_t k = 0; k < 3 * count; k++) {
        if (triangles[k] >= s->vertex_count)
            return context_item(context,
                                context_fail(context, GRAZE_EINPUT,
                                             "vertex %zu of %zu; expected a number below that",
                                             triangles[k], s->vertex_count),
                                "triangle", k / 3, NULL);
        if (k % 3 == 0)
            TRY(soup_add_facet(s, context));
        if (k % 3 == 0)
            TRY(soup_add_cycle(s, context, triangles + k, 0));
        TRY(soup_add_index(s, context, triangles[k]));
    }
    return GRAZE_OK;
}

static graze_status mesh_from_arrays(graze_mesh *m, graze_context *context, const double *vertices,
                                     size_t vertex_count, const size_t *triangles,
                                     size_t triangle_count) {
    soup_init(&m->input, 3);
    TRY(api_vertices(&m->input, context, NULL, vertices, vertex_count));
    TRY(take_triangles(&m->input, context, triangles, triangle_count));
    return mesh_of_soup(m, context, 0);
}

graze_status graze_mesh_create(graze_mesh **out, graze_context *context, const double *vertices,
                               size_t vertex_count, const size_t *triangles,
                               size_t triangle_count) {
    EMPTY(out);
    REFUSED(!out || !context || (!vertices && vertex_count) || (!triangles && triangle_count),
            "out, context, vertices and triangles must not be NULL");
    IN_ENVIRONMENT();
    CREATE(out, made, graze_mesh_destroy,
           mesh_from_arrays(made, context, vertices, vertex_count, triangles, triangle_count));
}

DESTROYER(graze_mesh, (judged_mesh_clear(&of->judged), soup_clear(&of->input)))

graze_mesh_facts graze_mesh_get_facts(const graze_mesh *mesh) {
    graze_mesh_facts out = {0};
    if (!mesh)
        return out;
    const judged_mesh *m = &mesh->judged;
    out.vertices = mesh->input.vertex_count;
    out.facets = mesh->input.facet_count;
    out.triangles = m->cut.count;
    out.flat = m->flat_count;
    out.components = m->cut.component_count;
    out.odd_edges = m->open.odd_count;
    out.unbalanced_edges = m->open.unbalanced_count;
    out.rule = m->rule;
    return out;
}

int graze_mesh_volume(mpq_t out, const graze_mesh *mesh) {
    if (!mesh || mesh->judged.rule != GRAZE_MESH_WINDING)
        return 0;
    fmpq_get_mpq(out, mesh->judged.volume);
    return 1;
}

int graze_mesh_windings(int *least, int *most, const graze_mesh *mesh) {
    if (!mesh || !least || !most || mesh->judged.rule != GRAZE_MESH_WINDING)
        return 0;
    *least = (int)mesh->judged.least;
    *most = (int)mesh->judged.most;
    return 1;
}

void graze_mesh_vertex(mpq_t *point, const graze_mesh *mesh, size_t index) {
    if (!mesh || index >= mesh->input.vertex_count)
        return;
    api_point_out(point, mesh->input.coordinates + 3 * index, 3);
}

void graze_mesh_triangle(size_t *vertex, const graze_mesh *mesh, size_t index) {
    if (!mesh || index >= mesh->judged.cut.count)
        return;
    for (int k = 0; k < 3; k++)
        vertex[k] = mesh->judged.cut.item[index].vertex[k];
}

/* A run over the vertices. */
typedef struct vertex_run {
    graze_enclosure *out;
    const graze_scene *scene;
    const fmpq *coordinates;
    double tolerance;
} vertex_run;

static graze_status enclose_vertex(void *data, graze_context *context, int member, size_t index) {
    const vertex_run *r = data;
    (void)member;
    return context_item(
        context,
        api_enclose(r->out + index, context, r->scene, r->coordinates + 3 * index, r->tolerance),
        "vertex", index, NULL);
}

graze_status graze_mesh_distances(graze_enclosure *out, graze_context *context,
                                  const graze_scene *scene, const graze_mesh *mesh,
                                  double tolerance, int threads) {
    PUBLIC(out, context, scene, mesh);
    REFUSED(!(tolerance > 0 && isfinite(tolerance)) || threads < 0 || threads > TEAM_MOST,
            "tolerance must be positive and finite, threads at most 1024");
    TRY(api_takes(context, __func__, scene->solid));
    vertex_run r = {out, scene, mesh->input.coordinates, tolerance};
    return team_run(context, threads ? threads : 1, mesh->input.vertex_count, enclose_vertex, &r);
}

static graze_status check_has_inside(graze_context *context, const graze_mesh *mesh) {
    if (mesh->judged.rule != GRAZE_MESH_NONE)
        return GRAZE_OK;
    return context_fail(context, GRAZE_EINPUT,
                        "the mesh has no inside: edges with an odd number of triangles; expected a "
                        "closed one");
}

/* A run over points. */
typedef struct answer_run {
    graze_pmc *out;
    const judged_mesh *mesh;
    graze_rationals points;
} answer_run;

static graze_status answer_point(void *data, graze_context *context, int member, size_t index) {
    const answer_run *r = data;
    LOCAL_VEC(fmpq, point, 3);
    long winding;
    (void)member;
    TRY(context_poll(context));
    for (int k = 0; k < 3; k++)
        TRY(api_coordinate(context,
                           api_rational(point + k, context, r->points[3 * index + (size_t)k]),
                           "point", index, (size_t)k));
    r->out[index] = (graze_pmc)(GRAZE_IN + judged_place(&winding, r->mesh, point));
    return GRAZE_OK;
}

graze_status graze_mesh_answers(graze_pmc *out, graze_context *context, const graze_mesh *mesh,
                                graze_rationals points, size_t n, int threads) {
    REFUSED(!context || !mesh || (n && (!out || !points)),
            "context and mesh, and with n > 0 also out and points, must not be NULL");
    REFUSED(threads < 0 || threads > TEAM_MOST, "threads must be at most 1024");
    IN_ENVIRONMENT();
    TRY(check_has_inside(context, mesh));
    answer_run r = {out, &mesh->judged, points};
    return team_run(context, threads ? threads : 1, n, answer_point, &r);
}

static graze_status check_judged(graze_context *context, const graze_scene *scene,
                                 const graze_judge_options *o) {
    if (!(o->within > 0 && isfinite(o->within)) || o->threads < 0 || o->threads > TEAM_MOST)
        return api_misuse(
            context, "graze_judge",
            "options.within must be positive and finite, options.threads at most 1024");
    TRY(api_takes(context, "graze_judge", scene->solid));
    if (scene->options.operation == GRAZE_UNSWEEP)
        return context_fail(context, GRAZE_EILLEGAL,
                            "an unsweep; expected a sweep to judge a mesh by");
    return GRAZE_OK;
}

static graze_status judge_by(graze_judgement *made, graze_context *context,
                             const graze_scene *scene, const graze_mesh *mesh,
                             const graze_judge_options *o) {
    made->mesh = mesh;
    return suprema_find(&made->searched, context, scene, &mesh->judged, o->within,
                        o->budget ? o->budget : DEFAULT_BUDGET, o->threads ? o->threads : 1);
}

graze_status graze_judge(graze_judgement **out, graze_context *context, const graze_scene *scene,
                         const graze_mesh *mesh, const graze_judge_options *options) {
    PUBLIC_OUT(out, context, scene, mesh, options);
    graze_judge_options checked;
    TRY(api_options(&checked, sizeof checked, context, __func__, options));
    TRY(check_judged(context, scene, &checked));
    CREATE(out, made, graze_judgement_destroy, judge_by(made, context, scene, mesh, &checked));
}

DESTROYER(graze_judgement, suprema_clear(&of->searched))

graze_judged_distance graze_judgement_distance(const graze_judgement *judgement,
                                               graze_judged which) {
    graze_judged_distance out = {0};
    if (!judgement || (unsigned)which >= GRAZE_JUDGED_COUNT)
        return out;
    const supremum *s = &judgement->searched.found[which];
    out.low = s->low;
    out.high = s->high;
    out.time = s->time;
    out.reached = s->reached;
    out.stuck = s->stuck;
    memcpy(out.at, s->at, sizeof out.at);
    memcpy(out.open, s->open, sizeof out.open);
    return out;
}

void graze_judgement_volume(mpq_t low, mpq_t high, const graze_judgement *judgement) {
    if (!judgement)
        return;
    fmpq_get_mpq(low, judgement->searched.volume + 2 * IN_SWEEP);
    fmpq_get_mpq(high, judgement->searched.volume + 2 * IN_SWEEP + 1);
}

int graze_judgement_difference(mpq_t missing_low, mpq_t missing_high, mpq_t excess_low,
                               mpq_t excess_high, const graze_judgement *judgement) {
    if (!judgement || !judgement->searched.has_difference)
        return 0;
    fmpq_get_mpq(missing_low, judgement->searched.volume + 2 * MISSING);
    fmpq_get_mpq(missing_high, judgement->searched.volume + 2 * MISSING + 1);
    fmpq_get_mpq(excess_low, judgement->searched.volume + 2 * EXCESS);
    fmpq_get_mpq(excess_high, judgement->searched.volume + 2 * EXCESS + 1);
    return 1;
}

FACT(unsigned long, graze_judgement_cost, graze_judgement,
     of->searched.space.decided + of->searched.asked, 0)

graze_status graze_judgement_report(char **out, graze_context *context,
                                    const graze_judgement *judgement,
                                    const graze_comparison *points, graze_judgement_format format) {
    PUBLIC_OUT(out, context, judgement);
    REFUSED((unsigned)format > GRAZE_JUDGEMENT_JSON,
            "there is no such format; expected text, Markdown or JSON");
    HELD(text, t);
    TRY(judge_report(&t, context, judgement, points, format));
    return text_finish(out, context, &t);
}

static graze_status check_mesh_points(graze_context *context, const graze_scene *scene,
                                      const graze_mesh *mesh, const graze_mesh_points *p) {
    if ((unsigned)p->on_as > GRAZE_ON_AS_OUT || p->threads < 0 || p->threads > TEAM_MOST)
        return api_misuse(context, "graze_compare_mesh", "an option has an unknown value");
    if (p->count > MOST_POINTS)
        return context_fail(context, GRAZE_ELIMIT, "%zu points; expected at most %zu", p->count,
                            MOST_POINTS);
    TRY(api_takes(context, "graze_compare_mesh", scene->solid));
    return check_has_inside(context, mesh);
}

/* Points of the caller's, taken over. */
static graze_status take_mesh_points(fmpq **out, graze_context *context, const graze_scene *scene,
                                     const graze_mesh_points *p) {
    *out = _fmpq_vec_init((slong)(3 * p->count));
    for (size_t k = 0; k < p->count; k++)
        TRY(context_item(context, api_point(*out + 3 * k, context, scene, p->points + 3 * k),
                         "point", k, NULL));
    return GRAZE_OK;
}

/* Compare at the caller's points, or at generated ones. */
static graze_status compare_at(graze_comparison *c, graze_context *context,
                               const graze_scene *scene, const graze_mesh *mesh,
                               const graze_mesh_points *p) {
    graze_compare_options options = {.size = sizeof options,
                                     .on_as = p->on_as,
                                     .show = p->show,
                                     .solid = p->solid,
                                     .motion = p->motion,
                                     .scene =
                                         solid_kind_of(scene->solid) & SOLID_CURVED ? NULL : scene};
    mesh_points asked = {.count = p->count};
    graze_generator *generator = NULL;
    fmpq *given = NULL;
    graze_status status =
        p->points ? take_mesh_points(&given, context, scene, p)
                  : graze_generator_create(&generator, context, scene, p->seed, NULL, 0);
    asked.generator = generator;
    asked.point = given;
    if (!status)
        status = comparison_of_mesh(c, context, scene, &mesh->judged, &asked,
                                    p->threads ? p->threads : 1, &options);
    if (given)
        _fmpq_vec_clear(given, (slong)(3 * p->count));
    graze_generator_destroy(generator);
    return status;
}

graze_status graze_compare_mesh(graze_comparison **out, graze_context *context,
                                const graze_scene *scene, const graze_mesh *mesh,
                                const graze_mesh_points *points) {
    PUBLIC_OUT(out, context, scene, mesh, points);
    graze_mesh_points taken;
    TRY(api_options(&taken, sizeof taken, context, __func__, points));
    TRY(check_mesh_points(context, scene, mesh, &taken));
    CREATE(out, made, graze_comparison_destroy, compare_at(made, context, scene, mesh, &taken));
}
