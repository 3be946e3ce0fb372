/* OBJ: the vertices and polygons of a Wavefront file.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The text is read twice, first for `v`, then for `f`, so that a facet may stand before its
 * vertices. A negative index counts back from the vertices above its line. Normals, textures,
 * groups and materials are skipped; curves, lines and points do not belong to a boundary and are
 * refused.
 */
#include "base/context/scope.h"
#include "base/number/rational.h"
#include "input/read/token_lines.h"

static int is_one_of(token t, const char *const *words) {
    while (*words != NULL && (strlen(*words) != t.length || memcmp(*words, t.text, t.length) != 0))
        words++;
    return *words != NULL;
}

static const char *const passed_over[] = {
    "vn",     "vt",    "g",        "o",        "s",   "mg",         "usemtl",    "mtllib", "usemap",
    "maplib", "bevel", "c_interp", "d_interp", "lod", "shadow_obj", "trace_obj", NULL};
static const char *const refused[] = {"l",    "p",     "vp",   "cstype", "deg",  "bmat", "step",
                                      "curv", "curv2", "surf", "parm",   "trim", "hole", "scrv",
                                      "sp",   "end",   "con",  "call",   "csh",  NULL};

/* Read x y z, followed by nothing, by the weight 1, or by a colour of three numbers. */
static graze_status obj_vertex(soup *s, lines *l, fmpq *number) {
    size_t v = s->vertex_count;
    int count = 3;
    token t;
    TRY(lines_numbers(l, number, 3, "vertex", v));
    while (lines_token(l, &t)) {
        if (count == 6)
            return lines_fail(l, GRAZE_EINPUT,
                              "vertex %zu has more than 6 numbers; expected x y z, x y z 1 or "
                              "x y z and a colour",
                              v);
        graze_status status = rational_parse(number + count++, l->context, t.text, t.length);
        TRY(lines_at(l, context_item(l->context, status, "vertex", v, NULL)));
    }
    if (count == 5 || (count == 4 && !fmpq_is_one(number + 3)))
        return lines_fail(l, GRAZE_EINPUT,
                          count == 5 ? "vertex %zu has 5 numbers; expected 3, 4 or 6"
                                     : "vertex %zu has a weight other than 1",
                          v);
    return lines_at(l, soup_add_vertex(s, l->context, number));
}

/* Return the part of *rest before its first slash; *rest becomes the part behind the slash. */
static token cut_token(token *rest, int *slash) {
    const char *p = memchr(rest->text, '/', rest->length);
    token head = {rest->text, p == NULL ? rest->length : (size_t)(p - rest->text)};
    *slash = p != NULL;
    rest->text += head.length + (size_t)*slash;
    rest->length -= head.length + (size_t)*slash;
    return head;
}

/* The index v of a corner v, v/vt, v//vn or v/vt/vn; 0 if the token has no such form or v is 0. */
static long long obj_corner(token t) {
    long long v, other;
    int slash;
    token part = cut_token(&t, &slash);
    if (!token_integer(part, &v))
        return 0;
    if (!slash)
        return v;
    token texture = cut_token(&t, &slash);
    if (texture.length > 0 ? !token_integer(texture, &other) : !slash)
        return 0;
    return slash && !token_integer(t, &other) ? 0 : v;
}

static graze_status obj_facet(soup *s, lines *l, size_t above) {
    size_t f = s->facet_count, size = 0;
    token t;
    TRY(lines_at(l, facet_begin(s, l->context)));
    for (; lines_token(l, &t); size++) {
        long long v = obj_corner(t);
        if (v == 0)
            return lines_fail(l, GRAZE_EINPUT,
                              "facet %zu: '%.*s' is not a corner; expected 1, 1/2, 1//3, 1/2/3 "
                              "or negative numbers, counted from 1",
                              f, TOKEN_SHOWN(t));
        if (v > 0 ? (size_t)v > s->vertex_count : (size_t)-v > above)
            return lines_fail(l, GRAZE_EINPUT,
                              "facet %zu: there is no vertex %lld; the file has %zu, and %zu stand "
                              "above this line",
                              f, v, s->vertex_count, above);
        size_t index = v > 0 ? (size_t)v - 1 : above - (size_t)-v;
        TRY(lines_at(l, soup_add_index(s, l->context, index)));
    }
    if (size < 3)
        return lines_fail(l, GRAZE_EINPUT, "facet %zu has %zu corners; expected at least 3", f,
                          size);
    return GRAZE_OK;
}

static graze_status check_keyword(lines *l, token t) {
    if (is_one_of(t, refused))
        return lines_fail(l, GRAZE_EINPUT,
                          "'%.*s': points, lines, curves and free-form surfaces bound no polygonal "
                          "solid; expected facets (f)",
                          TOKEN_SHOWN(t));
    if (!is_one_of(t, passed_over))
        return lines_fail(l, GRAZE_EINPUT, "'%.*s' is not a keyword of OBJ; expected v or f",
                          TOKEN_SHOWN(t));
    return GRAZE_OK;
}

static graze_status obj_vertices(soup *s, lines l, fmpq *number) {
    token t;
    for (int more = 1; more; more = lines_next(&l)) {
        if (!lines_token(&l, &t))
            continue;
        if (token_is(t, "v"))
            TRY(obj_vertex(s, &l, number));
        else if (!token_is(t, "f"))
            TRY(check_keyword(&l, t));
    }
    return GRAZE_OK;
}

static graze_status read_facets(soup *s, lines l) {
    size_t above = 0;
    token t;
    for (int more = 1; more; more = lines_next(&l)) {
        if (!lines_token(&l, &t))
            continue;
        if (token_is(t, "v"))
            above++;
        else if (token_is(t, "f"))
            TRY(obj_facet(s, &l, above));
    }
    return GRAZE_OK;
}

graze_status read_obj(soup *s, graze_context *context, const char *path, const char *text,
                      size_t length) {
    lines l = {.context = context, .path = path, .marks = "", .comment = '#', .continued = 1};
    TRY(lines_start(&l, text, length));
    LOCAL_VEC(fmpq, number, 6);
    TRY(obj_vertices(s, l, number));
    return read_facets(s, l);
}
