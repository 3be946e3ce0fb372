/* STL, text and binary: triangles, whose corners become vertices where they are exactly equal.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Vertices are numbered in order of first appearance. Normals and attributes are skipped. A binary
 * file may begin with "solid" too, so its size decides: 84 + 50 n bytes for n triangles.
 */
#include "base/context/scope.h"
#include "base/context/slots.h"
#include "base/number/rounding.h"
#include "base/number/vector.h"
#include "input/read/token_lines.h"

enum { HEADER = 84, RECORD = 50 };

typedef struct merger {
    soup *s;
    graze_context *context;
    slots positions; /* of the vertices */
    fmpq *point;     /* 3 */
} merger;

static uint64_t stl_hash(const fmpq *point) {
    const ulong prime = 2147483647;
    uint64_t hash = 0;
    for (int k = 0; k < 3; k++) {
        hash = hash * 0x9e3779b97f4a7c15u + fmpz_fdiv_ui(fmpq_numref(point + k), prime);
        hash = hash * 0x9e3779b97f4a7c15u + fmpz_fdiv_ui(fmpq_denref(point + k), prime);
    }
    return hash ^ hash >> 29;
}

/* The number of the vertex at m->point, or SLOTS_NONE. */
static size_t find_vertex(const merger *m, uint64_t hash) {
    size_t at = 0, vertex;
    while ((vertex = slots_next(&m->positions, hash, &at)) != SLOTS_NONE) {
        if (vector_compare(m->s->coordinates + 3 * vertex, m->point, 3) == 0)
            break;
    }
    return vertex;
}

/* Append m->point to the last cycle, as a new vertex if its position is new. */
static graze_status add_corner(merger *m) {
    uint64_t hash = stl_hash(m->point);
    size_t vertex = find_vertex(m, hash);
    if (vertex == SLOTS_NONE) {
        vertex = m->s->vertex_count;
        TRY(soup_add_vertex(m->s, m->context, m->point));
        if (!slots_add(&m->positions, hash))
            return context_fail(m->context, GRAZE_ESYSTEM, "no memory to merge %zu vertices",
                                m->s->vertex_count);
    }
    return soup_add_index(m->s, m->context, vertex);
}

static uint32_t little_endian(const unsigned char *p) {
    return p[0] | (uint32_t)p[1] << 8 | (uint32_t)p[2] << 16 | (uint32_t)p[3] << 24;
}

static graze_status binary_corner(merger *m, const unsigned char *p) {
    for (int k = 0; k < 3; k++) {
        uint32_t image = little_endian(p + 4 * k);
        float value;
        memcpy(&value, &image, sizeof value);
        TRY(rational_from_double(m->point + k, m->context, value));
        TRY(rational_round(m->point + k, m->context, m->context->rounding));
    }
    return add_corner(m);
}

static graze_status read_binary(merger *m, const char *path, const unsigned char *data,
                                size_t count) {
    for (size_t f = 0; f < count; f++) {
        graze_status status = facet_begin(m->s, m->context);
        for (size_t k = 0; k < 3 && status == GRAZE_OK; k++)
            status = binary_corner(m, data + HEADER + RECORD * f + 12 + 12 * k);
        if (status != GRAZE_OK) {
            context_item(m->context, status, "facet", f, NULL);
            context_at(m->context, status, "byte %zu", HEADER + RECORD * f);
            return context_in(m->context, status, path, 0);
        }
    }
    return GRAZE_OK;
}

static graze_status stl_expect(lines *l, const char *word, size_t f) {
    token t;
    if (!lines_any(l, &t))
        return lines_fail(l, GRAZE_EINPUT, "the file ends; expected '%s' of facet %zu", word, f);
    if (!token_is(t, word))
        return lines_fail(l, GRAZE_EINPUT, "facet %zu: '%.*s'; expected '%s'", f, TOKEN_SHOWN(t),
                          word);
    return GRAZE_OK;
}

/* Read a facet from behind its word "facet". */
static graze_status stl_facet(merger *m, lines *l) {
    size_t f = m->s->facet_count;
    token ignored;
    TRY(stl_expect(l, "normal", f));
    for (int k = 0; k < 3; k++)
        if (!lines_token(l, &ignored))
            return lines_fail(l, GRAZE_EINPUT, "facet %zu: its normal has %d numbers; expected 3",
                              f, k);
    TRY(stl_expect(l, "outer", f));
    TRY(stl_expect(l, "loop", f));
    TRY(lines_at(l, facet_begin(m->s, m->context)));
    for (int k = 0; k < 3; k++) {
        TRY(stl_expect(l, "vertex", f));
        TRY(lines_numbers(l, m->point, 3, "a vertex of facet", f));
        TRY(lines_at(l, add_corner(m)));
    }
    TRY(stl_expect(l, "endloop", f));
    return stl_expect(l, "endfacet", f);
}

/* Read one "solid ... endsolid"; both words may be followed by a name up to the line's end. */
static graze_status read_part(merger *m, lines *l) {
    token t;
    while (lines_token(l, &t)) {
    }
    for (;;) {
        if (!lines_any(l, &t))
            return lines_fail(l, GRAZE_EINPUT, "the file ends before 'endsolid', after %zu facets",
                              m->s->facet_count);
        if (token_is(t, "endsolid"))
            break;
        if (!token_is(t, "facet"))
            return lines_fail(l, GRAZE_EINPUT, "'%.*s'; expected 'facet' or 'endsolid'",
                              TOKEN_SHOWN(t));
        TRY(stl_facet(m, l));
    }
    while (lines_token(l, &t)) {
    }
    return GRAZE_OK;
}

static graze_status read_text(merger *m, const char *path, const char *text, size_t length) {
    lines l = {.context = m->context, .path = path, .marks = ""};
    TRY(lines_start(&l, text, length));
    token t;
    while (lines_any(&l, &t)) {
        if (!token_is(t, "solid"))
            return lines_fail(&l, GRAZE_EINPUT, "'%.*s'; expected 'solid'", TOKEN_SHOWN(t));
        TRY(read_part(m, &l));
    }
    return GRAZE_OK;
}

static int begins_as_text(const char *text, size_t length) {
    lines l = {.marks = ""};
    token t;
    lines_begin(&l, text, length);
    return lines_any(&l, &t) && token_is(t, "solid");
}

static graze_status read_either(merger *m, const char *path, const char *text, size_t length) {
    const unsigned char *data = (const unsigned char *)text;
    size_t count = length < HEADER ? 0 : little_endian(data + HEADER - 4);
    if (length >= HEADER && length == HEADER + RECORD * count) {
        if (count > m->context->limits[GRAZE_LIMIT_CELLS]) {
            context_limit(m->context, GRAZE_LIMIT_CELLS, "facets");
            context_at(m->context, GRAZE_ELIMIT, "byte %d", HEADER - 4);
            return context_in(m->context, GRAZE_ELIMIT, path, 0);
        }
        return read_binary(m, path, data, count);
    }
    if (begins_as_text(text, length))
        return read_text(m, path, text, length);
    if (length < HEADER)
        return context_fail_in(m->context, GRAZE_EINPUT, path, 0,
                               "neither begins with 'solid' nor has the %d bytes of a binary "
                               "STL's header",
                               HEADER);
    return context_fail_in(m->context, GRAZE_EINPUT, path, 0,
                           "has %zu bytes; expected %zu, as a binary STL of %zu facets has", length,
                           HEADER + RECORD * count, count);
}

graze_status read_stl(soup *s, graze_context *context, const char *path, const char *text,
                      size_t length) {
    LOCAL_VEC(fmpq, point, 3);
    merger m = {.s = s, .context = context, .point = point};
    graze_status status = read_either(&m, path, text, length);
    slots_clear(&m.positions);
    return status;
}
