/* Guesses tangent planes, for vertices that are on from their contacts.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A boundary point of the sweep is touched by a facet, whose plane then is the tangent plane, or by
 * an edge, which sweeps a surface whose tangent plane holds the edge and the velocity (E^2: an
 * edge, or a vertex). If P -> A P + b carries points to the solid's frame, a normal n in that frame
 * becomes A^T n.
 */
#include "questions/boundary/sampling.h"

#include <math.h>
#include "base/context/scope.h"
#include "base/number/vector.h"
#include "decide/trace/trace.h"
#include "questions/contact/contact.h"
#include "questions/distance/distance.h"

/* Set `out` to a facet's normal, twice as long as the area of its outer cycle: the sum of the cross
 * products of neighbouring vertices. */
static void facet_normal(fmpq *out, const soup *s, size_t facet) {
    uint32_t cycle = s->facet_start[facet];
    size_t from = s->cycle_start[cycle], end = s->cycle_start[cycle + 1];
    LOCAL_VEC(fmpq, product, 3);
    for (size_t k = from; k < end; k++) {
        size_t next = k + 1 < end ? k + 1 : from;
        vector_cross(product, s->coordinates + 3 * (size_t)s->index[k],
                     s->coordinates + 3 * (size_t)s->index[next]);
        vector_add(out, out, product, 3);
    }
}

/* Set `out`, zeros, to a multiple of the velocity of a point's trajectory. */
static void velocity(fmpq *out, const point_map *map, const fmpq_t u, const fmpq *point) {
    int size = map->dimension + 1;
    LOCAL_VEC(fmpz, rows, 2 * size * size + 3 * size);
    fmpz *at = rows + 2 * size * size, *x = at + size; /* (X, W), then its derivative */
    _fmpq_vec_get_fmpz_vec_fmpz(at, at + size - 1, point, size - 1);
    for (int k = 0; k < 2; k++)
        map_rows(rows + k * size * size, map, u, k);
    for (int k = 0; k < 2 * size; k++)
        _fmpz_vec_dot(x + k, rows + k * size, at, size);
    for (int k = 0; k < size - 1; k++) {
        fmpz_mul(fmpq_numref(out + k), x + size + k, x + size - 1);
        fmpz_submul(fmpq_numref(out + k), x + k, x + 2 * size - 1);
    }
}

/* Find the normal in the solid's frame; zero if the cell gives none. */
static void body_normal(fmpq *out, const graze_scene *scene, const graze_cell *cell,
                        const point_map *map, const fmpq_t u, const fmpq *point) {
    const soup *s = &scene->solid->input;
    int d = s->dimension;
    LOCAL_VEC(fmpq, moves, 3);
    LOCAL_VEC(fmpq, along, 3);
    if (cell->kind == GRAZE_CELL_EDGE)
        vector_sub(along, s->coordinates + cell->b * (size_t)d,
                   s->coordinates + cell->a * (size_t)d, d);
    if (cell->kind != GRAZE_CELL_FACE)
        velocity(moves, map, u, point);
    if (d == 2) {
        const fmpq *span = cell->kind == GRAZE_CELL_EDGE ? along : moves;
        fmpq_set(out, span + 1);
        fmpq_neg(out + 1, span);
    } else if (cell->kind == GRAZE_CELL_FACE) {
        facet_normal(out, s, cell->a);
    } else {
        vector_cross(out, along, moves);
    }
}

/* Find the normal that a contact's first cell gives; zero if that gives none. */
static graze_status contact_normal(fmpq *out, graze_context *context, const graze_scene *scene,
                                   const contact *c, const fmpq *point) {
    const point_map *map =
        motion_tracing(&scene->motion->piece[c->from->piece], scene->options.operation);
    int d = map->dimension;
    LOCAL_VEC(fmpq, body, 3);
    LOCAL_VEC(fmpq, carried, POINT_MAP_ENTRIES);
    LOCAL(fmpq, u);
    TRY(distance_contact_time(u, context, c->from));
    motion_parameter_at(u, &c->from->motion->piece[c->from->piece], u);
    body_normal(body, scene, c->cell, map, u, point);
    point_map_at(carried, map, u);
    for (int j = 0; j < d; j++) {
        fmpq_zero(out + j);
        for (int i = 0; i < d; i++)
            fmpq_addmul(out + j, carried + i * (d + 1) + j, body + i);
    }
    return GRAZE_OK;
}

/* Turn the normal of a form outward, put the plane through a point and find the unit normal. */
static void finish(tangent *t, int d, const fmpq *through, const fmpq *outside,
                   const fmpq *inside) {
    LOCAL_VEC(fmpq, way, d);
    LOCAL_VEC(fmpq, value, 2);
    fmpq *most = value + 1;
    double squares = 0;
    vector_sub(way, outside, inside, d);
    _fmpq_vec_dot(value, t->form, way, d);
    int side = fmpq_sgn(value);
    for (int k = 0; k < d && side < 0; k++)
        fmpq_neg(t->form + k, t->form + k);
    _fmpq_vec_dot(t->form + d, t->form, through, d);
    fmpq_neg(t->form + d, t->form + d);
    (void)vector_widest(most, t->form, d);
    for (int k = 0; k < d && side; k++) {
        fmpq_div(value, t->form + k, most);
        t->unit[k] = fmpq_get_d(value);
        squares += t->unit[k] * t->unit[k];
    }
    for (int k = 0; k < d && side; k++)
        t->unit[k] /= sqrt(squares);
    t->known = side != 0;
}

static graze_status from_contacts(tangent *out, asker *a, const fmpq *outside, const fmpq *point) {
    const struct graze_boundary *b = a->boundary;
    graze_trace trace;
    TRY(trace_point(&trace, a->context, b->scene, (query_point){.rational = point},
                    TRACE_CONTACTS));
    graze_status status = GRAZE_OK;
    a->asked++;
    for (size_t k = 0; k < trace.contact_count && !status && !out->known; k++) {
        status = contact_normal(out->form, a->context, b->scene, &trace.contact[k], point);
        if (!status)
            finish(out, b->dimension, point, outside, point);
    }
    trace_clear(&trace);
    return status;
}

graze_status tangent_find(tangent *out, asker *a, size_t vertex) {
    const struct graze_boundary *b = a->boundary;
    int d = b->dimension, found = 0;
    LOCAL_VEC(fmpq, points, 2 * d);
    fmpq *outside = points, *inside = points + d;
    bisect_between(outside, inside, b, vertex);
    if (b->vertices.value[vertex] == GRAZE_ON) {
        TRY(from_contacts(out, a, outside, inside));
    } else {
        TRY(probe_normal(out->form, &found, a, outside, inside));
        if (found)
            finish(out, d, inside, outside, inside);
    }
    return GRAZE_OK;
}
