/* Polygon soups: their arrays.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/soup/soup.h"

#include "base/context/array.h"
#include "base/context/scope.h"

enum { POLL_MASK = 0xffff };

/* Make room for `count` entries of an array. */
static graze_status make_room(graze_context *context, void *items, size_t *capacity, size_t count,
                              size_t size) {
    if (count > UINT32_MAX) {
        return context_fail(context, GRAZE_ELIMIT,
                            "the solid has more than %lu vertices, corners or facets, which is as "
                            "many as can be numbered",
                            (unsigned long)UINT32_MAX);
    }
    return array_grow(context, items, capacity, count, size, "a solid");
}

/* Append an empty part, whose offset is `end`, to the `count` parts with offsets in `start`. */
static graze_status add_part(graze_context *context, uint32_t **start, size_t *capacity,
                             size_t *count, size_t end) {
    TRY(make_room(context, start, capacity, *count + 2, sizeof **start));
    (*start)[*count] = (uint32_t)end;
    (*count)++;
    (*start)[*count] = (uint32_t)end;
    return GRAZE_OK;
}

void soup_init(soup *s, int dimension) {
    *s = (soup){.dimension = dimension};
}

void soup_clear(soup *s) {
    for (size_t k = 0; k < s->vertex_count * (size_t)s->dimension; k++) {
        fmpq_clear(s->coordinates + k);
    }
    free(s->coordinates);
    free(s->index);
    free(s->cycle_start);
    free(s->facet_start);
    soup_init(s, s->dimension);
}

/* Check the limit `cells` and, now and then, call the cancel callback. */
static graze_status may_add(graze_context *context, size_t count, const char *what) {
    if (count >= context->limits[GRAZE_LIMIT_CELLS]) {
        return context_limit(context, GRAZE_LIMIT_CELLS, what);
    }
    return (count & POLL_MASK) == POLL_MASK ? context_poll(context) : GRAZE_OK;
}

graze_status soup_add_vertex(soup *s, graze_context *context, const fmpq *coordinates) {
    size_t d = (size_t)s->dimension;
    size_t count = s->vertex_count * d;
    TRY(may_add(context, s->vertex_count, "vertices"));
    TRY(make_room(context, &s->coordinates, &s->coordinate_capacity, count + d,
                  sizeof *s->coordinates));
    for (size_t k = 0; k < d; k++) {
        fmpq_init(s->coordinates + count + k);
        fmpq_set(s->coordinates + count + k, coordinates + k);
    }
    s->vertex_count++;
    return GRAZE_OK;
}

graze_status soup_add_facet(soup *s, graze_context *context) {
    TRY(may_add(context, s->facet_count, "facets"));
    return add_part(context, &s->facet_start, &s->facet_capacity, &s->facet_count, s->cycle_count);
}

graze_status soup_add_cycle(soup *s, graze_context *context, const size_t *vertex, size_t count) {
    TRY(add_part(context, &s->cycle_start, &s->cycle_capacity, &s->cycle_count, s->index_count));
    s->facet_start[s->facet_count] = (uint32_t)s->cycle_count;
    for (size_t k = 0; k < count; k++)
        TRY(soup_add_index(s, context, vertex[k]));
    return GRAZE_OK;
}

graze_status soup_add_index(soup *s, graze_context *context, size_t vertex) {
    TRY(make_room(context, &s->index, &s->index_capacity, s->index_count + 1, sizeof *s->index));
    s->index[s->index_count++] = (uint32_t)vertex;
    s->cycle_start[s->cycle_count] = (uint32_t)s->index_count;
    return GRAZE_OK;
}
