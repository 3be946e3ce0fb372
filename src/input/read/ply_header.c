/* The header of a PLY file (token_lines.h).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/context/scope.h"
#include "input/read/token_lines.h"

enum { ENTRIES_MOST = 1000 };

static const char *const type_names[PLY_TYPE_COUNT][2] = {
    [PLY_INT8] = {"char", "int8"},        [PLY_UINT8] = {"uchar", "uint8"},
    [PLY_INT16] = {"short", "int16"},     [PLY_UINT16] = {"ushort", "uint16"},
    [PLY_INT32] = {"int", "int32"},       [PLY_UINT32] = {"uint", "uint32"},
    [PLY_FLOAT32] = {"float", "float32"}, [PLY_FLOAT64] = {"double", "float64"},
};

static int same_word(token a, token b) {
    return a.length == b.length && memcmp(a.text, b.text, a.length) == 0;
}

/* The next word of a header line; `what` names it in the message where it is missing. */
static graze_status word(lines *l, token *out, const char *what) {
    return lines_token(l, out)
               ? GRAZE_OK
               : lines_fail(l, GRAZE_EINPUT, "the header line ends before %s", what);
}

static graze_status line_ends(lines *l) {
    token t;
    return lines_token(l, &t) ? lines_fail(l, GRAZE_EINPUT,
                                           "'%.*s' is too much on this header line", TOKEN_SHOWN(t))
                              : GRAZE_OK;
}

static graze_status read_type(lines *l, ply_type *out) {
    token t;
    TRY(word(l, &t, "a type"));
    for (*out = 0; *out < PLY_TYPE_COUNT; ++*out)
        if (token_is(t, type_names[*out][0]) || token_is(t, type_names[*out][1]))
            return GRAZE_OK;
    return lines_fail(l, GRAZE_EINPUT,
                      "'%.*s' is not a type of PLY; expected char, uchar, short, ushort, int, "
                      "uint, float, double, int8 ... float64",
                      TOKEN_SHOWN(t));
}

static graze_status read_format(ply_header *h, lines *l) {
    token t, version;
    if (!lines_next(l) || !lines_token(l, &t) || !token_is(t, "format"))
        return lines_fail(l, GRAZE_EINPUT,
                          "expected 'format' at the beginning of the line after 'ply'");
    TRY(word(l, &t, "the format's name"));
    TRY(word(l, &version, "the version"));
    if (token_is(t, "ascii")) {
        h->format = PLY_ASCII;
    } else if (token_is(t, "binary_little_endian")) {
        h->format = PLY_LITTLE_ENDIAN;
    } else if (token_is(t, "binary_big_endian")) {
        h->format = PLY_BIG_ENDIAN;
    } else {
        return lines_fail(l, GRAZE_EINPUT,
                          "'%.*s' is not a format; expected ascii, binary_little_endian or "
                          "binary_big_endian",
                          TOKEN_SHOWN(t));
    }
    if (!token_is(version, "1.0"))
        return lines_fail(l, GRAZE_EINPUT, "version '%.*s'; expected 1.0", TOKEN_SHOWN(version));
    return line_ends(l);
}

static graze_status read_element(ply_header *h, lines *l) {
    ply_element *e = h->element + h->element_count;
    *e = (ply_element){.first = h->property_count};
    TRY(word(l, &e->name, "the element's name"));
    for (size_t k = 0; k < h->element_count; k++)
        if (same_word(h->element[k].name, e->name))
            return lines_fail(l, GRAZE_EINPUT, "element '%.*s' is declared twice",
                              TOKEN_SHOWN(e->name));
    TRY(lines_cells(l, &e->count, "an element's entries"));
    e->is_vertex = token_is(e->name, "vertex");
    e->is_face = token_is(e->name, "face");
    h->vertex_count = e->is_vertex ? e->count : h->vertex_count;
    h->element_count++;
    return line_ends(l);
}

static ply_role role_of(const ply_element *e, token name) {
    static const char *const axis[3] = {"x", "y", "z"};
    for (int k = 0; e->is_vertex && k < 3; k++)
        if (token_is(name, axis[k]))
            return (ply_role)(PLY_X + k);
    int indices = token_is(name, "vertex_indices") || token_is(name, "vertex_index");
    return e->is_face && indices ? PLY_INDICES : PLY_PASSED;
}

static graze_status check_property(const ply_header *h, const lines *l, const ply_element *e,
                                   const ply_property *p) {
    for (size_t k = e->first; k < h->property_count; k++) {
        const ply_property *q = h->property + k;
        if (same_word(q->name, p->name) || (p->role != PLY_PASSED && q->role == p->role))
            return lines_fail(l, GRAZE_EINPUT, "property '%.*s' is declared twice",
                              TOKEN_SHOWN(p->name));
    }
    if (p->is_list && p->count_type >= PLY_FLOAT32)
        return lines_fail(l, GRAZE_EINPUT, "expected an integer type for the length of a list");
    if (p->role == PLY_INDICES && (!p->is_list || p->type >= PLY_FLOAT32))
        return lines_fail(l, GRAZE_EINPUT, "'%.*s'; expected a list of an integer type",
                          TOKEN_SHOWN(p->name));
    if (p->role <= PLY_Z && p->is_list)
        return lines_fail(l, GRAZE_EINPUT, "coordinate '%.*s' is a list; expected a number",
                          TOKEN_SHOWN(p->name));
    return GRAZE_OK;
}

static graze_status read_property(ply_header *h, lines *l) {
    if (h->element_count == 0)
        return lines_fail(l, GRAZE_EINPUT, "a property stands before the first element");
    ply_element *e = h->element + h->element_count - 1;
    ply_property *p = h->property + h->property_count;
    *p = (ply_property){.count_type = PLY_INT8};
    lines before = *l;
    token t;
    TRY(word(l, &t, "a type"));
    p->is_list = token_is(t, "list");
    if (p->is_list)
        TRY(read_type(l, &p->count_type));
    else
        *l = before;
    TRY(read_type(l, &p->type));
    TRY(word(l, &p->name, "the property's name"));
    p->role = role_of(e, p->name);
    TRY(check_property(h, l, e, p));
    h->property_count++;
    e->property_count++;
    return line_ends(l);
}

/* Check that there are vertices and faces with the properties that Graze needs, and that every
 * element has properties. */
static graze_status check_header(const ply_header *h, const lines *l) {
    int vertex = 0, face = 0;
    for (size_t k = 0; k < h->element_count; k++) {
        const ply_element *e = h->element + k;
        int needed = e->is_vertex ? 3 : e->is_face;
        for (size_t p = e->first; p < e->first + e->property_count; p++)
            needed -= h->property[p].role != PLY_PASSED;
        if (e->property_count == 0 || needed > 0)
            return lines_fail(l, GRAZE_EINPUT, "element '%.*s' lacks %s", TOKEN_SHOWN(e->name),
                              e->is_vertex ? "one of its properties x, y, z"
                              : e->is_face ? "a property vertex_indices"
                                           : "properties");
        vertex |= e->is_vertex;
        face |= e->is_face;
    }
    if (!vertex || !face)
        return lines_fail(l, GRAZE_EINPUT, "the header has no element '%s'",
                          vertex ? "face" : "vertex");
    return GRAZE_OK;
}

static graze_status read_entries(ply_header *h, lines *l) {
    for (;;) {
        token t;
        if (!lines_next(l) || !lines_token(l, &t))
            return lines_fail(l, GRAZE_EINPUT,
                              "the file ends within the header; its last line is "
                              "'end_header'");
        if (h->element_count + h->property_count == ENTRIES_MOST)
            return lines_fail(l, GRAZE_EINPUT,
                              "the header has more than %d elements and properties", ENTRIES_MOST);
        if (token_is(t, "end_header")) {
            TRY(line_ends(l));
            return check_header(h, l);
        }
        if (token_is(t, "element"))
            TRY(read_element(h, l));
        else if (token_is(t, "property"))
            TRY(read_property(h, l));
        else if (!token_is(t, "comment") && !token_is(t, "obj_info"))
            return lines_fail(l, GRAZE_EINPUT,
                              "'%.*s' is no header line; expected element, property, comment, "
                              "end_header",
                              TOKEN_SHOWN(t));
    }
}

graze_status ply_header_read(ply_header *out, lines *l) {
    token t;
    *out = (ply_header){.format = PLY_ASCII};
    if (!lines_token(l, &t) || !token_is(t, "ply"))
        return lines_fail(l, GRAZE_EINPUT, "the file begins with '%.*s'; expected 'ply'",
                          TOKEN_SHOWN(t));
    out->element = malloc(ENTRIES_MOST * sizeof *out->element);
    out->property = malloc(ENTRIES_MOST * sizeof *out->property);
    graze_status status = out->element == NULL || out->property == NULL
                              ? context_fail(l->context, GRAZE_ESYSTEM, "no memory for a header")
                              : line_ends(l);
    if (status == GRAZE_OK)
        status = read_format(out, l);
    if (status == GRAZE_OK)
        status = read_entries(out, l);
    if (status != GRAZE_OK)
        ply_header_clear(out);
    return status;
}

void ply_header_clear(ply_header *header) {
    free(header->element);
    free(header->property);
    *header = (ply_header){.format = PLY_ASCII};
}
