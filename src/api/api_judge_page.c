/* The public function of the page of a mesh that is judged.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "api/api.h"

#include "base/number/rounding.h"
#include "output/draw/draw.h"
#include "output/page/page.h"
#include "questions/judge/judge.h"

/* Most marked places: one for each greatest distance, and one where its search is stuck. */
enum { MOST_PLACES = 2 * GRAZE_JUDGED_COUNT };

typedef struct judge_page {
    draw_mesh mesh;
    double *distance;
    uint32_t *corners;
    fmpq *box, *places; /* box: low, then high; places: 3 coordinates each */
    const char *name[MOST_PLACES];
    size_t place_count;
} judge_page;

/* Take the corners of the triangles, and as distance of a vertex the middle of its enclosure. */
static void take_mesh(judge_page *p, const graze_mesh *mesh, const graze_enclosure *found) {
    const simplices *cut = &mesh->judged.cut;
    size_t vertices = mesh->input.vertex_count;
    for (size_t v = 0; v < vertices; v++)
        p->distance[v] = 0.5 * found[v].low + 0.5 * found[v].high;
    for (size_t k = 0; k < 3 * cut->count; k++)
        p->corners[k] = cut->item[k / 3].vertex[k % 3];
    p->mesh = (draw_mesh){mesh->input.coordinates, vertices, p->corners, cut->count, p->distance};
}

/* Set the box to that of the scene, enlarged to hold the mesh. */
static graze_status box_with_mesh(judge_page *p, graze_context *context, const graze_scene *scene) {
    TRY(scene_box(p->box, p->box + 3, context, scene));
    for (size_t k = 0; k < 3 * p->mesh.vertex_count; k++) {
        const fmpq *x = p->mesh.vertices + k;
        if (fmpq_cmp(x, p->box + k % 3) < 0)
            fmpq_set(p->box + k % 3, x);
        if (fmpq_cmp(x, p->box + 3 + k % 3) > 0)
            fmpq_set(p->box + 3 + k % 3, x);
    }
    return GRAZE_OK;
}

static graze_status mark_place(judge_page *p, graze_context *context, const double *at,
                               const char *name) {
    for (size_t i = 0; i < 3; i++)
        TRY(rational_from_double(p->places + 3 * p->place_count + i, context, at[i]));
    p->name[p->place_count++] = name;
    return GRAZE_OK;
}

static graze_status take_places(judge_page *p, graze_context *context,
                                const graze_judgement *judgement) {
    static const char *const names[] = {"outside", "inside", "sweep"};
    static const char *const open[] = {"outside seam?", "inside seam?", "sweep seam?"};
    for (int k = 0; k < GRAZE_JUDGED_COUNT; k++) {
        graze_judged_distance d = graze_judgement_distance(judgement, (graze_judged)k);
        if (d.low > 0)
            TRY(mark_place(p, context, d.at, names[k]));
        if (d.stuck)
            TRY(mark_place(p, context, d.open, open[k]));
    }
    return GRAZE_OK;
}

graze_status graze_judgement_draw(graze_context *context, const graze_scene *scene,
                                  const graze_judgement *judgement, const char *file,
                                  const graze_enclosure *found, const char *title) {
    PUBLIC(context, scene, judgement, file, found);
    REFUSED(!file_has_extension(file, "html"), "the file is no page; expected a name in .html");
    REFUSED(title && strlen(title) > 512, "title must have at most 512 bytes");
    const graze_mesh *mesh = judgement->mesh;
    LOCAL_VEC(fmpq, box, 6);
    LOCAL_VEC(fmpq, places, 3 * MOST_PLACES);
    FREED(double, distance, calloc(mesh->input.vertex_count + 1, sizeof *distance));
    FREED(uint32_t, corners, calloc(3 * mesh->judged.cut.count + 1, sizeof *corners));
    if (!distance || !corners)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for a page");
    judge_page p = {.distance = distance, .corners = corners, .box = box, .places = places};
    take_mesh(&p, mesh, found);
    TRY(box_with_mesh(&p, context, scene));
    TRY(take_places(&p, context, judgement));
    draw_request request = {.title = title,
                            .times = 5,
                            .low = box,
                            .high = box + 3,
                            .plane_axis = 2,
                            .view = {2, -3, 2},
                            .points = places,
                            .point_count = p.place_count,
                            .names = p.name,
                            .mesh = &p.mesh};
    return page_write(context, scene, file, &request);
}
