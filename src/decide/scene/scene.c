/* Makes a scene of a solid and a motion, and decides whether the swept solid's first and last
 * configuration meet.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * S^0 and S^1 meet iff S and A S do, A = M(t0)^-1 M(t1). If their boundaries have no point in
 * common then the boundary of S n A S, where that set is not empty, holds a point of one boundary
 * inside the other solid; the component of the boundary it lies on is connected and misses the
 * other boundary, so it lies inside as a whole. One vertex per component, both ways, therefore
 * decides.
 */
#include "decide/scene/scene.h"

#include "base/context/scope.h"
#include "base/number/vector.h"

/* d x (d + 1) affine maps as square homogeneous matrices, so that FLINT multiplies and inverts. */
static void homogeneous_matrix(fmpq_mat_t out, const point_map *map, const fmpq_t u) {
    int d = map->dimension;
    LOCAL_VEC(fmpq, entry, d * (d + 1));
    point_map_at(entry, map, u);
    fmpq_mat_zero(out);
    for (int row = 0; row < d; row++)
        for (int column = 0; column <= d; column++)
            fmpq_set(fmpq_mat_entry(out, row, column), entry + row * (d + 1) + column);
    fmpq_one(fmpq_mat_entry(out, d, d));
}

/* Does the image of one vertex of some boundary component lie inside the solid? None lies on its
 * boundary. */
static graze_status component_inside(int *out, graze_context *context, const graze_solid *solid,
                                     const fmpq_mat_t map) {
    int d = solid->input.dimension;
    FREED(char, seen, calloc(solid->cut.component_count + 1, 1));
    if (!seen)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory");
    LOCAL_VEC(fmpz, x, d + 1);
    LOCAL_VEC(fmpq, moved, d);
    *out = 0;
    for (size_t s = 0; s < solid->cut.count && !*out; s++) {
        const simplex *piece = &solid->cut.item[s];
        if (seen[piece->component])
            continue;
        seen[piece->component] = 1;
        vector_image(moved, map, solid->input.coordinates + (size_t)piece->vertex[0] * d, d);
        _fmpq_vec_get_fmpz_vec_fmpz(x, x + d, moved, d);
        graze_state state = solid_locate(solid, x);
        if (state == GRAZE_STATE_ABSENT)
            return context_fail(context, GRAZE_EINTERNAL,
                                "the crossings of a ray with the solid do not add up");
        *out = state == GRAZE_STATE_I;
        TRY(context_poll(context));
    }
    return GRAZE_OK;
}

static graze_status meet_under(int *out, graze_context *context, const graze_solid *solid,
                               const fmpq_mat_t map) {
    int d = solid->input.dimension;
    LOCAL_VEC(fmpq, rows, d * (d + 1));
    for (int row = 0; row < d; row++)
        for (int column = 0; column <= d; column++)
            fmpq_set(rows + row * (d + 1) + column, fmpq_mat_entry(map, row, column));
    return meeting_find(out, context, solid, rows);
}

/* Whether a polygon or polyhedron meets its image under a map. */
static graze_status polyhedron_meets(int *out, graze_context *context, const graze_solid *solid,
                                     const fmpq_mat_t map, const fmpq_mat_t inverse) {
    TRY(meet_under(out, context, solid, map));
    if (!*out)
        TRY(component_inside(out, context, solid, map));
    if (!*out)
        TRY(component_inside(out, context, solid, inverse));
    return GRAZE_OK;
}

graze_status scene_ends(graze_ends *out, graze_context *context, const graze_solid *solid,
                        const graze_motion *motion) {
    int d = motion->dimension;
    const motion_piece *first = motion->piece, *last = first + motion->piece_count - 1;
    LOCAL_VEC(fmpq, zero, 2);
    fmpq *one = zero + 1;
    fmpq_one(one);
    LOCAL(fmpq_mat, map, d + 1, d + 1);
    LOCAL(fmpq_mat, other, d + 1, d + 1);
    homogeneous_matrix(map, &first->inverse, zero);
    homogeneous_matrix(other, &last->forward, one);
    fmpq_mat_mul(map, map, other);
    int meet = 0;
    *out = GRAZE_ENDS_APART;
    if (!fmpq_mat_inv(other, map))
        return context_fail(context, GRAZE_EINTERNAL, "the motion's end maps are singular");
    if (solid->curved)
        return common_point_ends(out, context, solid->curved, map, other);
    TRY(polyhedron_meets(&meet, context, solid, map, other));
    *out = meet ? GRAZE_ENDS_MEET : GRAZE_ENDS_APART;
    return GRAZE_OK;
}

static graze_status make_memo(scene_memo **out, graze_context *context) {
    scene_memo *memo = calloc(1, sizeof *memo);
    if (!memo || pthread_mutex_init(&memo->lock, NULL) != 0) {
        free(memo);
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for a scene");
    }
    *out = memo;
    return GRAZE_OK;
}

static void free_memo(scene_memo *memo) {
    if (!memo)
        return;
    if (memo->value)
        memo->free(memo->value);
    pthread_mutex_destroy(&memo->lock);
    free(memo);
}

graze_status scene_make(graze_scene *out, graze_context *context, const graze_solid *solid,
                        const graze_motion *motion, const graze_options *options) {
    memset(out, 0, sizeof *out);
    out->solid = solid;
    out->motion = motion;
    if (options)
        out->options = *options;
    if (solid->input.dimension != motion->dimension)
        return context_fail(
            context, GRAZE_EILLEGAL,
            "the solid has dimension %d and the motion dimension %d; expected equal dimensions",
            solid->input.dimension, motion->dimension);
    TRY(scene_ends(&out->ends, context, solid, motion));
    if (out->ends != GRAZE_ENDS_APART && out->options.overlap == GRAZE_OVERLAP_REJECT &&
        out->options.operation == GRAZE_SWEEP)
        return context_fail(context, GRAZE_EILLEGAL,
                            out->ends == GRAZE_ENDS_MEET
                                ? "S^0 and S^1 meet, which overlap `reject` excludes; `extend` "
                                  "classifies all nine cases"
                                : "it is not decided whether S^0 and S^1 meet, which overlap "
                                  "`reject` excludes; `extend` classifies all nine cases");
    TRY(scene_hash(out->sha256, context, solid, motion));
    graze_status status = make_memo(&out->memo, context);
    if (!status)
        status = make_memo(&out->arc_maps, context);
    if (!status && solid->curved)
        status = surface_filter_make(&out->surfaces, context, solid->curved, motion,
                                     out->options.operation);
    else if (!status)
        status = filter_make(&out->filter, context, solid, motion, out->options.operation);
    if (status) {
        free_memo(out->memo);
        free_memo(out->arc_maps);
        filter_clear(&out->filter);
    }
    return status;
}

graze_status scene_at_rest(graze_scene *out, graze_context *context, const graze_solid *solid) {
    static const char *const still[] = {
        "{\"dimension\": 2, \"pieces\": [{\"t\": [0, 1], \"transform\": {\"translate\": [0, 0]}}]}",
        "{\"dimension\": 3, \"pieces\": [{\"t\": [0, 1], \"transform\": {\"translate\": [0, 0, "
        "0]}}]}"};
    const char *text = still[solid->input.dimension - 2];
    graze_motion *standing = NULL;
    TRY(motion_from_text(&standing, context, text, strlen(text)));
    graze_status status = scene_make(out, context, solid, standing, NULL);
    if (status)
        motion_destroy(standing);
    else
        out->standing = standing;
    return status;
}

void scene_clear(graze_scene *scene) {
    free_memo(scene->memo);
    free_memo(scene->arc_maps);
    filter_clear(&scene->filter);
    surface_filter_free(scene->surfaces);
    if (scene->standing)
        motion_destroy(scene->standing);
}
