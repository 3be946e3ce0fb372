/* WKT: POLYGON and MULTIPOLYGON in the plane.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Every position is a vertex of its own, in order of appearance, except the last one of a ring,
 * which repeats the ring's first. Rings come in either orientation; turning one changes the order
 * in its cycle, never the numbers of vertices.
 */
#include "base/context/scope.h"
#include "base/number/rational.h"
#include "base/number/vector.h"
#include "input/read/token_lines.h"
#include "input/validate/validate.h"

typedef struct wkt {
    soup *s;
    lines l;
    size_t polygon, ring; /* being read, for messages */
    fmpq *point;          /* 2 */
} wkt;

static graze_status expect(wkt *w, const char *mark, const char *what) {
    token t;
    if (!lines_any(&w->l, &t))
        return lines_fail(&w->l, GRAZE_EINPUT, "the file ends; expected '%s' %s", mark, what);
    if (!token_is(t, mark))
        return lines_fail(&w->l, GRAZE_EINPUT, "'%.*s'; expected '%s' %s", TOKEN_SHOWN(t), mark,
                          what);
    return GRAZE_OK;
}

/* Read what follows an entry of a list; *more is 1 where another entry follows. */
static graze_status list_goes_on(wkt *w, int *more, const char *what) {
    token t;
    if (!lines_any(&w->l, &t))
        return lines_fail(&w->l, GRAZE_EINPUT, "the file ends within %s", what);
    *more = token_is(t, ",");
    if (!*more && !token_is(t, ")"))
        return lines_fail(
            &w->l, GRAZE_EINPUT,
            "'%.*s' stands in %s; expected ',' or ')', and positions in the plane, x y",
            TOKEN_SHOWN(t), what);
    return GRAZE_OK;
}

/* Put polygon and ring before the message of a failure. */
static graze_status at_ring(const wkt *w, graze_status status) {
    char ring[32];
    snprintf(ring, sizeof ring, "ring %zu", w->ring);
    return context_item(w->l.context, status, "polygon", w->polygon, ring);
}

static graze_status read_position(wkt *w) {
    for (int k = 0; k < 2; k++) {
        token t;
        if (!lines_any(&w->l, &t))
            return lines_fail(&w->l, GRAZE_EINPUT, "the file ends within polygon %zu, ring %zu",
                              w->polygon, w->ring);
        TRY(lines_at(&w->l,
                     at_ring(w, rational_parse(w->point + k, w->l.context, t.text, t.length))));
    }
    return GRAZE_OK;
}

/* The sum of x_i y_(i+1) - x_(i+1) y_i over part of a ring, summed by halves, so that only few sums
 * have large denominators and a long ring takes little more time than reading it. */
static void area_sum(fmpq_t out, const soup *s, const uint32_t *ring, size_t n, size_t lo,
                     size_t hi) {
    LOCAL(fmpq, half);
    if (hi - lo == 1) {
        const fmpq *a = s->coordinates + 2 * ring[lo];
        const fmpq *b = s->coordinates + 2 * ring[(lo + 1) % n];
        fmpq_mul(out, a, b + 1);
        fmpq_mul(half, b, a + 1);
        fmpq_sub(out, out, half);
    } else {
        area_sum(out, s, ring, n, lo, lo + (hi - lo) / 2);
        area_sum(half, s, ring, n, lo + (hi - lo) / 2, hi);
        fmpq_add(out, out, half);
    }
}

/* Turn the last cycle: ring 0 counter-clockwise, the others clockwise. */
static graze_status turn_ring(wkt *w) {
    soup *s = w->s;
    uint32_t *ring = s->index + s->cycle_start[s->cycle_count - 1];
    size_t n = s->index_count - s->cycle_start[s->cycle_count - 1];
    LOCAL(fmpq, area);
    area_sum(area, s, ring, n, 0, n);
    int sign = fmpq_sgn(area);
    if (sign == 0) {
        graze_status status = validate_crossing(w->l.context, s, s->cycle_count - 1);
        if (status == GRAZE_OK)
            status = context_fail(w->l.context, GRAZE_EILLEGAL, "its area is zero");
        return lines_at(&w->l, at_ring(w, status));
    }
    if ((sign > 0) != (w->ring == 0)) {
        for (size_t a = 1, b = n - 1; a < b; a++, b--) {
            uint32_t keep = ring[a];
            ring[a] = ring[b];
            ring[b] = keep;
        }
    }
    return GRAZE_OK;
}

/* Check that the last position of a ring, w->point, is its first. */
static graze_status close_ring(wkt *w, size_t first, size_t count) {
    if (count < 4)
        return lines_fail(&w->l, GRAZE_EINPUT,
                          "polygon %zu, ring %zu has %zu positions; expected at least 4, the last "
                          "repeating the first",
                          w->polygon, w->ring, count);
    if (vector_compare(w->s->coordinates + 2 * first, w->point, 2) != 0)
        return lines_fail(&w->l, GRAZE_EINPUT,
                          "polygon %zu, ring %zu is not closed; expected its first position, "
                          "exactly, as its last",
                          w->polygon, w->ring);
    return turn_ring(w);
}

static graze_status read_ring(wkt *w) {
    size_t first = w->s->vertex_count, count = 0;
    TRY(expect(w, "(", "before a ring"));
    TRY(soup_add_cycle(w->s, w->l.context, NULL, 0));
    for (int more = 1; more; count++) {
        TRY(read_position(w));
        TRY(list_goes_on(w, &more, "a ring"));
        if (!more)
            continue;
        TRY(lines_at(&w->l, soup_add_index(w->s, w->l.context, w->s->vertex_count)));
        TRY(lines_at(&w->l, soup_add_vertex(w->s, w->l.context, w->point)));
    }
    return close_ring(w, first, count);
}

static graze_status read_polygon(wkt *w) {
    TRY(expect(w, "(", "before the rings of a polygon"));
    TRY(soup_add_facet(w->s, w->l.context));
    w->ring = 0;
    for (int more = 1; more; w->ring++) {
        TRY(read_ring(w));
        TRY(list_goes_on(w, &more, "a polygon"));
    }
    return GRAZE_OK;
}

static graze_status read_multipolygon(wkt *w) {
    TRY(expect(w, "(", "before the polygons"));
    for (int more = 1; more; w->polygon++) {
        TRY(read_polygon(w));
        TRY(list_goes_on(w, &more, "a multipolygon"));
    }
    return GRAZE_OK;
}

/* Read the word before the first bracket; *multi is 1 for MULTIPOLYGON. */
static graze_status read_kind(wkt *w, int *multi) {
    token t;
    if (!lines_any(&w->l, &t))
        return lines_fail(&w->l, GRAZE_EINPUT, "there is no text; expected POLYGON ((x y, ...))");
    *multi = token_is(t, "MULTIPOLYGON");
    if (t.length >= 4 && token_is((token){t.text, 4}, "SRID"))
        return lines_fail(&w->l, GRAZE_EINPUT,
                          "a reference system ('%.*s'); expected none, the plane is Euclidean",
                          TOKEN_SHOWN(t));
    if (!*multi && !token_is(t, "POLYGON"))
        return lines_fail(&w->l, GRAZE_EINPUT,
                          "'%.*s' is no solid of the plane; expected POLYGON or MULTIPOLYGON",
                          TOKEN_SHOWN(t));
    lines ahead = w->l;
    if (!lines_any(&ahead, &t))
        return lines_fail(&ahead, GRAZE_EINPUT, "the file ends before the first '('");
    if (token_is(t, "EMPTY"))
        return lines_fail(&ahead, GRAZE_EILLEGAL, "empty interior: EMPTY is no solid");
    if (token_is(t, "Z") || token_is(t, "M") || token_is(t, "ZM"))
        return lines_fail(&ahead, GRAZE_EINPUT, "coordinates %.*s; expected x y", TOKEN_SHOWN(t));
    return GRAZE_OK;
}

graze_status read_wkt(soup *s, graze_context *context, const char *path, const char *text,
                      size_t length) {
    LOCAL_VEC(fmpq, point, 2);
    wkt w = {.s = s, .l = {.context = context, .path = path, .marks = "(),"}, .point = point};
    token t;
    int multi = 0;
    TRY(lines_start(&w.l, text, length));
    TRY(read_kind(&w, &multi));
    TRY(multi ? read_multipolygon(&w) : read_polygon(&w));
    if (lines_any(&w.l, &t))
        return lines_fail(&w.l, GRAZE_EINPUT, "'%.*s' follows the last ')'; expected one geometry",
                          TOKEN_SHOWN(t));
    return GRAZE_OK;
}
