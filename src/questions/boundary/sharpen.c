/* Replaces patches by fans of faces about features.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Where the patch of a cell has one rim, a simple closed polygon on the sides of the cell, and the
 * cell has a feature strictly inside, the faces from the feature to the rim's edges replace the
 * patch. From a point inside a convex cell each point of the cell's sides is seen in a direction of
 * its own, so the new faces have no common points except on common edges and the feature, and none
 * is degenerate. The rim does not change, so the surface stays a manifold.
 *
 * Let two such cells have a side in common, features p and q, and let the rims pass that side in
 * one run, from u to v. Where the surface bends between u and v, the faces at the run are replaced
 * by p q u and p q v, and vertices inside the run disappear. The segment p q meets the side in one
 * inner point r, and the side is convex, so in both cells the faces are those of a rim whose run
 * goes from u over r to v: still a simple polygon on the sides. Thus edges of the sweep become
 * edges of the surface.
 *
 * In E^2 the segments of a patch are replaced by two: from its first vertex to the feature, and
 * from there to its last vertex.
 */
#include "questions/boundary/sampling.h"

#include "base/context/array.h"
#include "base/context/scope.h"
#include "base/context/team.h"
#include "base/number/vector.h"

/* A patch that is replaced by a fan about its feature; fan k has feature k. */
typedef struct fan {
    size_t patch, first, count; /* `first`, `count`: of its rim in `rims` */
} fan;

typedef struct sharpening {
    struct graze_boundary *boundary;
    graze_context *context;
    size_t count;         /* number of vertices before sharpening */
    tangent *tangents;    /* of each vertex, found if its `asked` is 1 */
    unsigned char *asked; /* of each vertex: 1 if its tangent is wanted */
    fan *fans;
    size_t fan_count, fan_capacity;
    size_t *rims, rim_count, rim_capacity;
    number_index places; /* places of the fans' cells, in the order of the fans */
    size_t *corners, face_count, corner_capacity; /* the new faces */
} sharpening;

static size_t apex_of(const sharpening *s, size_t fan_index) {
    return s->boundary->vertices.count + fan_index;
}

/* Add a fan about a feature, which moves to the boundary's features: `f` is left empty. */
static graze_status keep_fan(sharpening *s, size_t patch, const rim *r, feature *f) {
    struct graze_boundary *b = s->boundary;
    static const char what[] = "the surface";
    TRY(ARRAY_GROW(s->context, s->fans, s->fan_capacity, s->fan_count + 1, what));
    TRY(ARRAY_GROW(s->context, s->rims, s->rim_capacity, s->rim_count + r->count, what));
    TRY(ARRAY_GROW(s->context, b->features, b->feature_capacity, b->feature_count + 1, what));
    if (!number_index_add(&s->places, lattice_key(b->cells[b->patches[patch].cell].at), 0))
        return context_fail(s->context, GRAZE_ESYSTEM, "out of memory for the surface");
    s->fans[s->fan_count++] = (fan){patch, s->rim_count, r->count};
    memcpy(s->rims + s->rim_count, r->vertex, r->count * sizeof *r->vertex);
    s->rim_count += r->count;
    b->features[b->feature_count++] = *f;
    feature_init(f);
    return GRAZE_OK;
}

/* Find the tangent of one vertex, if it is wanted, as work of a team. */
static graze_status know_tangent(void *data, graze_context *context, int member, size_t vertex) {
    sharpening *s = data;
    asker *a = &s->boundary->askers[member];
    a->context = context;
    TRY(context_poll(context));
    return s->asked[vertex] ? tangent_find(&s->tangents[vertex], a, vertex) : GRAZE_OK;
}

static graze_status know_tangents(sharpening *s) {
    struct graze_boundary *b = s->boundary;
    rim r;
    for (size_t patch = 0; patch < b->patch_count; patch++)
        for (size_t k = 0; rim_find(&r, b, patch) && k < r.count; k++)
            s->asked[r.vertex[k]] = 1;
    graze_status status = team_run(s->context, b->threads, b->vertices.count, know_tangent, s);
    b->askers->context = s->context;
    return status;
}

/* The mean of the rim's vertices. */
static void rim_mean(fmpq *out, const struct graze_boundary *b, const rim *r) {
    LOCAL_VEC(fmpq, at, b->dimension);
    LOCAL(fmpz, count);
    fmpz_set_ui(count, r->count);
    for (size_t k = 0; k < r->count; k++) {
        bisect_vertex(at, b, r->vertex[k]);
        vector_add(out, out, at, b->dimension);
    }
    for (int k = 0; k < b->dimension; k++)
        fmpq_div_fmpz(out + k, out + k, count);
}

static graze_status try_patch(sharpening *s, size_t patch) {
    struct graze_boundary *b = s->boundary;
    const tangent *list[RIM_MOST];
    rim r;
    int found = 0;
    TRY(context_poll(s->context));
    if (!rim_find(&r, b, patch))
        return GRAZE_OK;
    for (size_t k = 0; k < r.count; k++)
        list[k] = &s->tangents[r.vertex[k]];
    LOCAL_VEC(fmpq, mean, b->dimension);
    HELD(feature, f);
    rim_mean(mean, b, &r);
    TRY(feature_find(&f, &found, b->askers, &b->cells[b->patches[patch].cell], list, r.count,
                     mean));
    return found ? keep_fan(s, patch, &r, &f) : GRAZE_OK;
}

static graze_status keep_face(sharpening *s, const size_t *corner) {
    size_t d = (size_t)s->boundary->dimension;
    TRY(ARRAY_GROW(s->context, s->corners, s->corner_capacity, (s->face_count + 1) * d,
                   "the surface"));
    memcpy(s->corners + s->face_count++ * d, corner, d * sizeof *corner);
    return GRAZE_OK;
}

static graze_status add_triangle(sharpening *s, size_t a, size_t b, size_t c) {
    return keep_face(s, (size_t[]){a, b, c});
}

static graze_status keep_patch(sharpening *s, size_t patch) {
    const struct graze_boundary *b = s->boundary;
    size_t first = b->patches[patch].first;
    size_t end = patch + 1 < b->patch_count ? b->patches[patch + 1].first : b->face_count;
    for (size_t k = first; k < end; k++)
        TRY(keep_face(s, b->corners + k * (size_t)b->dimension));
    return GRAZE_OK;
}

/* The number of the fan of the neighbouring cell on one side; fan_count if that cell has none. */
static size_t neighbour(const sharpening *s, const sample_cell *c, int axis, int upper) {
    uint32_t at[3], last = upper ? (1u << c->level) - 1 : 0;
    memcpy(at, c->at, sizeof at);
    if (at[axis] == last)
        return s->fan_count;
    at[axis] += upper ? 1 : (uint32_t)-1;
    return number_index_find(&s->places, lattice_key(at));
}

/* Is a fan joined to another one through this side of its cell? If so, set the run of its rim in
 * the side and the number of the other fan. */
static int is_joined(rim_run *run, size_t *other, const sharpening *s, const fan *f, int axis,
                     int upper) {
    const size_t *vertex = s->rims + f->first;
    const sample_cell *c = s->boundary->cells + s->boundary->patches[f->patch].cell;
    *other = neighbour(s, c, axis, upper);
    if (*other == s->fan_count || !rim_run_at(run, s->boundary, c, vertex, f->count, axis, upper))
        return 0;
    return feature_between(&s->tangents[vertex[run->first]],
                           &s->tangents[vertex[(run->first + run->edges) % f->count]]);
}

/* Add the two triangles at the edge from one fan's apex to the other's. The fan of the lower number
 * adds them for both. */
static graze_status join_fans(sharpening *s, size_t index, size_t other, const rim_run *run) {
    const fan *f = &s->fans[index];
    const size_t *vertex = s->rims + f->first;
    size_t u = vertex[run->first], v = vertex[(run->first + run->edges) % f->count];
    if (other < index)
        return GRAZE_OK;
    TRY(add_triangle(s, apex_of(s, index), u, apex_of(s, other)));
    return add_triangle(s, apex_of(s, index), apex_of(s, other), v);
}

static graze_status spread_in_space(sharpening *s, size_t index) {
    const fan *f = &s->fans[index];
    const size_t *vertex = s->rims + f->first;
    unsigned char joined[RIM_MOST] = {0};
    for (int side = 0; side < 6; side++) {
        rim_run run;
        size_t other;
        if (!is_joined(&run, &other, s, f, side / 2, side % 2))
            continue;
        for (size_t k = 0; k < run.edges; k++)
            joined[(run.first + k) % f->count] = 1;
        TRY(join_fans(s, index, other, &run));
    }
    for (size_t k = 0; k < f->count; k++)
        if (!joined[k])
            TRY(add_triangle(s, apex_of(s, index), vertex[k], vertex[(k + 1) % f->count]));
    return GRAZE_OK;
}

static graze_status spread(sharpening *s, size_t index) {
    const fan *f = &s->fans[index];
    const size_t *vertex = s->rims + f->first;
    if (s->boundary->dimension == 3)
        return spread_in_space(s, index);
    TRY(keep_face(s, (size_t[]){vertex[0], apex_of(s, index)}));
    return keep_face(s, (size_t[]){apex_of(s, index), vertex[f->count - 1]});
}

/* Remove the vertices that no face has; the remaining vertices keep their order. */
static graze_status drop_vertices(sharpening *s) {
    struct graze_boundary *b = s->boundary;
    size_t corners = s->face_count * (size_t)b->dimension, old = b->vertices.count, count = 0;
    FREED(size_t, number, calloc(bisect_count(b) + 1, sizeof *number));
    if (!number)
        return context_fail(s->context, GRAZE_ESYSTEM, "out of memory for the surface");
    for (size_t k = 0; k < corners; k++)
        number[s->corners[k]] = 1;
    b->exact = 0;
    for (size_t v = 0; v < old; v++) {
        if (!number[v])
            continue;
        b->vertices.key[count] = b->vertices.key[v];
        b->vertices.value[count] = b->vertices.value[v];
        for (int k = 0; k < 2; k++)
            fmpq_swap(b->shares + 2 * count + k, b->shares + 2 * v + k);
        b->exact += b->vertices.value[v] == GRAZE_ON && !fmpq_is_one(b->shares + 2 * count + 1);
        number[v] = count++;
    }
    for (size_t v = old; v < bisect_count(b); v++) {
        b->exact += b->features[v - old].pmc == GRAZE_ON;
        number[v] = v - old + count;
    }
    for (size_t k = 0; k < corners; k++)
        s->corners[k] = number[s->corners[k]];
    for (size_t k = 2 * count; k < 2 * old; k++)
        fmpq_clear(b->shares + k);
    b->vertices.count = count;
    return GRAZE_OK;
}

static graze_status rebuild(sharpening *s) {
    struct graze_boundary *b = s->boundary;
    size_t next = 0;
    for (size_t patch = 0; patch < b->patch_count; patch++) {
        if (next < s->fan_count && s->fans[next].patch == patch)
            TRY(spread(s, next++));
        else
            TRY(keep_patch(s, patch));
    }
    TRY(drop_vertices(s));
    free(b->corners);
    b->corners = s->corners;
    b->face_count = s->face_count;
    b->corner_capacity = s->corner_capacity;
    s->corners = NULL;
    return GRAZE_OK;
}

static void sharpening_clear(sharpening *s) {
    for (size_t v = 0; v < s->count && s->tangents; v++)
        for (int k = 0; k < 4; k++)
            fmpq_clear(s->tangents[v].form + k);
    free(s->tangents);
    free(s->asked);
    free(s->fans);
    free(s->rims);
    free(s->corners);
    number_index_clear(&s->places);
}

graze_status boundary_sharpen(graze_context *context, struct graze_boundary *b) {
    ZEROED(sharpening, s);
    s.boundary = b;
    s.context = context;
    s.count = b->vertices.count;
    TRY(MAKE_ARRAY(context, s.tangents, s.count + 1, "the surface"));
    TRY(MAKE_ARRAY(context, s.asked, s.count + 1, "the surface"));
    TRY(know_tangents(&s));
    for (size_t patch = 0; patch < b->patch_count; patch++)
        TRY(try_patch(&s, patch));
    return s.fan_count ? rebuild(&s) : GRAZE_OK;
}
