/* Polygon soups: their arrays.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * An array of n entries has room for the power of two at or above n, so no capacity is kept.
 */
#include "soup/soup.h"

#include <stdlib.h>

enum { ROOM_LEAST = 16, POLL_MASK = 0xffff };

static size_t room(size_t count) {
    if (count <= ROOM_LEAST) {
        return count == 0 ? 0 : ROOM_LEAST;
    }
    return (size_t)1 << FLINT_BIT_COUNT(count - 1);
}

/* Make room for `more` entries behind the `count` there are. */
static graze_status grow(graze_context *context, void **array, size_t count, size_t more,
                         size_t entry) {
    if (count + more > UINT32_MAX) {
        return context_fail(context, GRAZE_ELIMIT,
                            "the solid has more than %lu vertices, corners or facets, which is as "
                            "many as can be numbered",
                            (unsigned long)UINT32_MAX);
    }
    size_t size = room(count + more);
    if (size == room(count)) {
        return GRAZE_OK;
    }
    void *grown = realloc(*array, size * entry);
    if (grown == NULL) {
        return context_fail(context, GRAZE_ESYSTEM, "no memory for a solid's %zu bytes",
                            size * entry);
    }
    *array = grown;
    return GRAZE_OK;
}

/* One more part behind `count` parts of which `start` has the offsets; it begins and ends at
 * `end`. */
static graze_status add_part(graze_context *context, uint32_t **start, size_t *count, size_t end) {
    size_t stored = *count == 0 ? 0 : *count + 1;
    void *array = *start;
    graze_status status = grow(context, &array, stored, *count + 2 - stored, sizeof **start);
    *start = array;
    if (status != GRAZE_OK) {
        return status;
    }
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

/* The cells limit and, now and then, the cancel callback. */
static graze_status may_add(graze_context *context, size_t count, const char *what) {
    if (count >= context->limits[GRAZE_LIMIT_CELLS]) {
        return context_limit(context, GRAZE_LIMIT_CELLS, what);
    }
    return (count & POLL_MASK) == POLL_MASK ? context_poll(context) : GRAZE_OK;
}

graze_status soup_add_vertex(soup *s, graze_context *context, const fmpq *coordinates) {
    size_t d = (size_t)s->dimension;
    size_t count = s->vertex_count * d;
    graze_status status = may_add(context, s->vertex_count, "vertices");
    if (status == GRAZE_OK) {
        void *array = s->coordinates;
        status = grow(context, &array, count, d, sizeof *s->coordinates);
        s->coordinates = array;
    }
    if (status != GRAZE_OK) {
        return status;
    }
    for (size_t k = 0; k < d; k++) {
        fmpq_init(s->coordinates + count + k);
        fmpq_set(s->coordinates + count + k, coordinates + k);
    }
    s->vertex_count++;
    return GRAZE_OK;
}

graze_status soup_add_facet(soup *s, graze_context *context) {
    graze_status status = may_add(context, s->facet_count, "facets");
    if (status != GRAZE_OK) {
        return status;
    }
    return add_part(context, &s->facet_start, &s->facet_count, s->cycle_count);
}

graze_status soup_add_cycle(soup *s, graze_context *context, const size_t *vertex, size_t count) {
    graze_status status = add_part(context, &s->cycle_start, &s->cycle_count, s->index_count);
    if (status == GRAZE_OK) {
        s->facet_start[s->facet_count] = (uint32_t)s->cycle_count;
    }
    for (size_t k = 0; k < count && status == GRAZE_OK; k++) {
        status = soup_add_index(s, context, vertex[k]);
    }
    return status;
}

graze_status soup_add_index(soup *s, graze_context *context, size_t vertex) {
    void *array = s->index;
    graze_status status = grow(context, &array, s->index_count, 1, sizeof *s->index);
    s->index = array;
    if (status == GRAZE_OK) {
        s->index[s->index_count++] = (uint32_t)vertex;
        s->cycle_start[s->cycle_count] = (uint32_t)s->index_count;
    }
    return status;
}
