/* OFF: the counts, one line a vertex, one line a facet.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Only the plain OFF of three coordinates is read. Colours behind a facet's indices are passed
 * over; `#` begins a comment.
 */
#include "number/rational.h"
#include "solid/lines.h"
#include "solid/readers.h"

static graze_status read_counts(lines *l, size_t *vertices, size_t *facets) {
    token t;
    if (!lines_any(l, &t) || !token_is(t, "OFF")) {
        return lines_fail(l, GRAZE_EINPUT,
                          "the header is '%.*s'; right is OFF (of its variants with colours, "
                          "normals, textures or other dimensions none is read)",
                          TOKEN_SHOWN(t));
    }
    lines after = *l;
    if (lines_any(&after, &t) && token_is(t, "BINARY")) {
        return lines_fail(&after, GRAZE_EINPUT, "a binary OFF is not read; write it as text");
    }
    size_t edges;
    graze_status status = lines_cells(l, vertices, "vertices");
    if (status == GRAZE_OK) {
        status = lines_cells(l, facets, "facets");
    }
    if (status == GRAZE_OK) {
        status = lines_cells(l, &edges, "edges");
    }
    if (status == GRAZE_OK && lines_token(l, &t)) {
        return lines_fail(l, GRAZE_EINPUT, "'%.*s' follows the three counts", TOKEN_SHOWN(t));
    }
    return status;
}

static graze_status read_vertices(soup *s, lines *l, fmpq *point, size_t count) {
    for (size_t v = 0; v < count; v++) {
        token t;
        if (!lines_next(l)) {
            return lines_fail(l, GRAZE_EINPUT, "the file ends after %zu of its %zu vertices", v,
                              count);
        }
        graze_status status = lines_numbers(l, point, 3, "vertex", v);
        if (status != GRAZE_OK) {
            return status;
        }
        if (lines_token(l, &t)) {
            return lines_fail(l, GRAZE_EINPUT, "vertex %zu: '%.*s' follows its 3 numbers", v,
                              TOKEN_SHOWN(t));
        }
        status = soup_add_vertex(s, l->context, point);
        if (status != GRAZE_OK) {
            return lines_at(l, status);
        }
    }
    return GRAZE_OK;
}

/* Colours are none, one index of a colour map, or three or four components. */
static graze_status pass_colours(lines *l, size_t f) {
    token t;
    size_t count = 0;
    while (lines_token(l, &t)) {
        if (!rational_is_token(t.text, t.length)) {
            return lines_fail(l, GRAZE_EINPUT,
                              "facet %zu: '%.*s' follows its indices; a colour is of numbers", f,
                              TOKEN_SHOWN(t));
        }
        count++;
    }
    if (count == 2 || count > 4) {
        return lines_fail(l, GRAZE_EINPUT,
                          "facet %zu: %zu values follow its indices; a colour has 1, 3 or 4", f,
                          count);
    }
    return GRAZE_OK;
}

static graze_status read_facet(soup *s, lines *l, size_t f) {
    token t;
    long long size, v;
    lines_token(l, &t);
    if (!token_integer(t, &size)) {
        return lines_fail(l, GRAZE_EINPUT, "facet %zu: '%.*s' is not its number of vertices", f,
                          TOKEN_SHOWN(t));
    }
    if (size < 3) {
        return lines_fail(l, GRAZE_EINPUT, "facet %zu has %lld vertices; a facet has at least 3", f,
                          size);
    }
    graze_status status = soup_add_facet(s, l->context);
    if (status == GRAZE_OK) {
        status = soup_add_cycle(s, l->context, NULL, 0);
    }
    for (long long k = 0; k < size && status == GRAZE_OK; k++) {
        if (!lines_token(l, &t)) {
            return lines_fail(l, GRAZE_EINPUT,
                              "facet %zu: the line ends after %lld of its %lld indices", f, k,
                              size);
        }
        if (!token_integer(t, &v) || v < 0 || (size_t)v >= s->vertex_count) {
            return lines_fail(l, GRAZE_EINPUT,
                              "facet %zu: '%.*s' is not a vertex; right are integers from 0 below "
                              "%zu",
                              f, TOKEN_SHOWN(t), s->vertex_count);
        }
        status = soup_add_index(s, l->context, (size_t)v);
    }
    return status == GRAZE_OK ? pass_colours(l, f) : lines_at(l, status);
}

static graze_status read_all(soup *s, lines *l, fmpq *point) {
    size_t vertices, facets;
    graze_status status = read_counts(l, &vertices, &facets);
    if (status == GRAZE_OK) {
        status = read_vertices(s, l, point, vertices);
    }
    for (size_t f = 0; f < facets && status == GRAZE_OK; f++) {
        if (!lines_next(l)) {
            return lines_fail(l, GRAZE_EINPUT, "the file ends after %zu of its %zu facets", f,
                              facets);
        }
        status = read_facet(s, l, f);
    }
    if (status == GRAZE_OK && lines_next(l)) {
        return lines_fail(l, GRAZE_EINPUT, "there is text after the last of %zu facets", facets);
    }
    return status;
}

graze_status read_off(soup *s, graze_context *context, const char *path, const char *text,
                      size_t length) {
    lines l = {.context = context, .path = path, .marks = "", .comment = '#'};
    graze_status status = lines_start(&l, text, length);
    if (status != GRAZE_OK) {
        return status;
    }
    fmpq point[3];
    for (int k = 0; k < 3; k++) {
        fmpq_init(point + k);
    }
    status = read_all(s, &l, point);
    for (int k = 0; k < 3; k++) {
        fmpq_clear(point + k);
    }
    return status;
}
