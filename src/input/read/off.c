/* OFF: the counts, one line a vertex, one line a facet.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The head may declare further numbers behind the coordinates of a vertex: N a normal, C a colour,
 * ST a position in a texture. These numbers and the colours behind a facet's indices are skipped;
 * `#` begins a comment.
 */
#include "base/context/scope.h"
#include "base/number/rational.h"
#include "input/read/token_lines.h"

/* Declarations of the head. Each letter stands once, in any order: Geomview writes ST C N, others N
 * C ST. */
typedef struct columns {
    int normal, colour, texture; /* declared? */
    size_t further;              /* numbers behind the coordinates; 0 until the first vertex */
} columns;

/* Read the letters before OFF. Returns 0 if one is unknown or stands twice. */
static int read_letters(columns *c, const char *text, size_t length) {
    size_t k = 0;
    while (k < length) {
        int *which = text[k] == 'N'                                           ? &c->normal
                     : text[k] == 'C'                                         ? &c->colour
                     : text[k] == 'S' && k + 1 < length && text[k + 1] == 'T' ? &c->texture
                                                                              : NULL;
        if (which == NULL || *which)
            return 0;
        *which = 1;
        k += which == &c->texture ? 2 : 1;
    }
    return 1;
}

static graze_status off_head(columns *c, lines *l) {
    token t;
    *c = (columns){.normal = 0};
    int present = lines_any(l, &t);
    size_t letters = t.length < 3 ? 0 : t.length - 3;
    token end = {t.text + letters, t.length - letters};
    if (!present || !token_is(end, "OFF") || !read_letters(c, t.text, letters)) {
        int dimensions = present && token_is(end, "OFF") &&
                         (memchr(t.text, '4', letters) || memchr(t.text, 'n', letters));
        return lines_fail(
            l, GRAZE_EINPUT,
            dimensions ? "the header is '%.*s': vertices of four (4) or of any number (n) of "
                         "coordinates are not read; expected three, as OFF and NOFF have"
                       : "the header is '%.*s'; expected OFF, before it in capitals N if "
                         "vertices have normals, C colours, ST texture coordinates",
            TOKEN_SHOWN(t));
    }
    lines after = *l;
    if (lines_any(&after, &t) && token_is(t, "BINARY"))
        return lines_fail(&after, GRAZE_EINPUT, "a binary OFF is not read; expected a text");
    return GRAZE_OK;
}

static graze_status off_counts(lines *l, size_t *vertices, size_t *facets) {
    token t;
    size_t edges;
    TRY(lines_cells(l, vertices, "vertices"));
    TRY(lines_cells(l, facets, "facets"));
    TRY(lines_cells(l, &edges, "edges"));
    if (lines_token(l, &t))
        return lines_fail(l, GRAZE_EINPUT, "'%.*s' follows the three counts", TOKEN_SHOWN(t));
    return GRAZE_OK;
}

/* Skip the numbers behind the coordinates of a vertex. A colour has 3 or 4 numbers, the same number
 * at every vertex. */
static graze_status pass_columns(columns *c, lines *l, size_t v) {
    size_t least = (c->normal ? 3u : 0u) + (c->texture ? 2u : 0u) + (c->colour ? 3u : 0u);
    size_t most = least + (c->colour ? 1u : 0u), count = 0;
    token t;
    for (; lines_token(l, &t); count++) {
        if (most == 0)
            return lines_fail(l, GRAZE_EINPUT, "vertex %zu: '%.*s' follows its 3 numbers", v,
                              TOKEN_SHOWN(t));
        if (!rational_is_token(t.text, t.length))
            return lines_fail(l, GRAZE_EINPUT,
                              "vertex %zu: '%.*s' follows its coordinates; expected numbers", v,
                              TOKEN_SHOWN(t));
    }
    int first = c->further == 0;
    if (first ? count < least || count > most : count != c->further)
        return lines_fail(l, GRAZE_EINPUT,
                          "vertex %zu: %zu numbers follow its coordinates; expected %zu%s", v,
                          count, first ? least : c->further,
                          !first      ? ", as at vertex 0"
                          : c->colour ? ", or one more if colours have an alpha"
                                      : "");
    c->further = count;
    return GRAZE_OK;
}

static graze_status off_vertices(soup *s, columns *c, lines *l, fmpq *point, size_t count) {
    for (size_t v = 0; v < count; v++) {
        if (!lines_next(l))
            return lines_fail(l, GRAZE_EINPUT, "the file ends after %zu of its %zu vertices", v,
                              count);
        TRY(lines_numbers(l, point, 3, "vertex", v));
        TRY(pass_columns(c, l, v));
        TRY(lines_at(l, soup_add_vertex(s, l->context, point)));
    }
    return GRAZE_OK;
}

/* Skip the colour of a facet: nothing, an index of a colour map, or three or four components. */
static graze_status pass_colours(lines *l, size_t f) {
    token t;
    size_t count = 0;
    while (lines_token(l, &t)) {
        if (!rational_is_token(t.text, t.length))
            return lines_fail(
                l, GRAZE_EINPUT,
                "facet %zu: '%.*s' follows its indices; expected the numbers of a colour", f,
                TOKEN_SHOWN(t));
        count++;
    }
    if (count == 2 || count > 4)
        return lines_fail(
            l, GRAZE_EINPUT,
            "facet %zu: %zu values follow its indices; expected 1, 3 or 4 of a colour", f, count);
    return GRAZE_OK;
}

static graze_status off_facet(soup *s, lines *l, size_t f) {
    token t;
    long long size, v;
    lines_token(l, &t);
    if (!token_integer(t, &size))
        return lines_fail(l, GRAZE_EINPUT, "facet %zu: '%.*s' is not its number of vertices", f,
                          TOKEN_SHOWN(t));
    if (size < 3)
        return lines_fail(l, GRAZE_EINPUT, "facet %zu has %lld vertices; expected at least 3", f,
                          size);
    TRY(lines_at(l, facet_begin(s, l->context)));
    for (long long k = 0; k < size; k++) {
        if (!lines_token(l, &t))
            return lines_fail(l, GRAZE_EINPUT,
                              "facet %zu: the line ends after %lld of its %lld indices", f, k,
                              size);
        if (!token_integer(t, &v) || v < 0 || (size_t)v >= s->vertex_count)
            return lines_fail(l, GRAZE_EINPUT,
                              "facet %zu: '%.*s' is not a vertex; expected an integer from 0 below "
                              "%zu",
                              f, TOKEN_SHOWN(t), s->vertex_count);
        TRY(lines_at(l, soup_add_index(s, l->context, (size_t)v)));
    }
    return pass_colours(l, f);
}

static graze_status read_all(soup *s, lines *l, fmpq *point) {
    size_t vertices = 0, facets = 0;
    columns c;
    TRY(off_head(&c, l));
    TRY(off_counts(l, &vertices, &facets));
    TRY(off_vertices(s, &c, l, point, vertices));
    for (size_t f = 0; f < facets; f++) {
        if (!lines_next(l))
            return lines_fail(l, GRAZE_EINPUT, "the file ends after %zu of its %zu facets", f,
                              facets);
        TRY(off_facet(s, l, f));
    }
    if (lines_next(l))
        return lines_fail(l, GRAZE_EINPUT, "there is text after the last of %zu facets", facets);
    return GRAZE_OK;
}

graze_status read_off(soup *s, graze_context *context, const char *path, const char *text,
                      size_t length) {
    lines l = {.context = context, .path = path, .marks = "", .comment = '#'};
    TRY(lines_start(&l, text, length));
    LOCAL_VEC(fmpq, point, 3);
    return read_all(s, &l, point);
}
