/* PLY: reads the vertices and faces of a file, which is text, or binary in either byte order.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Other elements and properties are skipped. In a text file every entry has a line of its own.
 * Tokens of coordinates are exact, whatever their declared type is.
 */
#include <stdint.h>
#include <stdio.h>
#include "base/context/scope.h"
#include "base/number/rational.h"
#include "base/number/rounding.h"
#include "input/read/token_lines.h"

typedef struct ply {
    soup *s;
    ply_header header;
    lines l;                   /* of a text file: the place in its body */
    const unsigned char *data; /* binary: the whole file */
    size_t at, size;
    const ply_element *element; /* being read */
    size_t entry;
    fmpq *point; /* 3 */
} ply;

static const struct {
    size_t width;
    int is_signed;
} types[PLY_TYPE_COUNT] = {
    [PLY_INT8] = {1, 1},  [PLY_UINT8] = {1, 0},  [PLY_INT16] = {2, 1},   [PLY_UINT16] = {2, 0},
    [PLY_INT32] = {4, 1}, [PLY_UINT32] = {4, 0}, [PLY_FLOAT32] = {4, 1}, [PLY_FLOAT64] = {8, 1},
};

/* Put file, place, element and entry before the message of a failure. */
static graze_status at_entry(const ply *p, graze_status status) {
    graze_context *context = p->l.context;
    char element[32];
    if (status == GRAZE_OK)
        return status;
    snprintf(element, sizeof element, "%.*s", TOKEN_SHOWN(p->element->name));
    context_item(context, status, element, p->entry, NULL);
    if (p->header.format == PLY_ASCII)
        return lines_at(&p->l, status);
    context_at(context, status, "byte %zu", p->at);
    return context_in(context, status, p->l.path, 0);
}

/* Fail at the entry that is read, with a message as for printf. */
#define fail(p, ...) at_entry(p, context_fail((p)->l.context, GRAZE_EINPUT, __VA_ARGS__))

static graze_status next_token(ply *p, token *out) {
    return lines_token(&p->l, out) ? GRAZE_OK
                                   : fail(p, "the line has fewer values than its properties ask");
}

static graze_status next_bytes(ply *p, ply_type type, uint64_t *out) {
    size_t width = types[type].width;
    if (p->size - p->at < width)
        return fail(p, "the file ends within this entry; %zu are declared", p->element->count);
    *out = 0;
    for (size_t k = 0; k < width; k++) {
        size_t place = p->header.format == PLY_BIG_ENDIAN ? k : width - 1 - k;
        *out = *out << 8 | p->data[p->at + place];
    }
    p->at += width;
    return GRAZE_OK;
}

static graze_status pass_value(ply *p, ply_type type) {
    token t;
    uint64_t bytes;
    return p->header.format == PLY_ASCII ? next_token(p, &t) : next_bytes(p, type, &bytes);
}

/* A value of an integer type. */
static graze_status read_integer(ply *p, ply_type type, long long *out) {
    token t;
    uint64_t bytes;
    if (p->header.format == PLY_ASCII) {
        TRY(next_token(p, &t));
        return token_integer(t, out) ? GRAZE_OK
                                     : fail(p, "'%.*s' is not an integer", TOKEN_SHOWN(t));
    }
    TRY(next_bytes(p, type, &bytes));
    uint64_t sign = (uint64_t)types[type].is_signed << (8 * types[type].width - 1);
    *out = bytes & sign ? (long long)bytes - 2 * (long long)sign : (long long)bytes;
    return GRAZE_OK;
}

static graze_status binary_coordinate(ply *p, ply_type type, fmpq *out) {
    uint64_t bytes;
    double value;
    TRY(next_bytes(p, type, &bytes));
    if (type == PLY_FLOAT64) {
        memcpy(&value, &bytes, sizeof value);
    } else {
        uint32_t image = (uint32_t)bytes;
        float narrow;
        memcpy(&narrow, &image, sizeof narrow);
        value = narrow;
    }
    return at_entry(p, rational_from_double(out, p->l.context, value));
}

static graze_status read_coordinate(ply *p, ply_type type, fmpq *out) {
    graze_context *context = p->l.context;
    long long integer;
    token t;
    if (p->header.format == PLY_ASCII) {
        TRY(next_token(p, &t));
        if (type < PLY_FLOAT32 && !token_integer(t, &integer))
            return fail(p, "'%.*s' is not an integer", TOKEN_SHOWN(t));
        return at_entry(p, rational_parse(out, context, t.text, t.length));
    }
    if (type >= PLY_FLOAT32) {
        TRY(binary_coordinate(p, type, out));
    } else {
        TRY(read_integer(p, type, &integer));
        fmpq_set_si(out, (slong)integer, 1);
    }
    return at_entry(p, rational_round(out, context, context->rounding));
}

static graze_status read_list(ply *p, const ply_property *property) {
    long long size, v;
    int taken = property->role == PLY_INDICES;
    TRY(read_integer(p, property->count_type, &size));
    if (size < 0)
        return fail(p, "a list has the length %lld", size);
    if (taken && size < 3)
        return fail(p, "it has %lld vertices; expected at least 3", size);
    for (long long k = 0; k < size; k++) {
        if (!taken) {
            TRY(pass_value(p, property->type));
            continue;
        }
        TRY(read_integer(p, property->type, &v));
        if (v < 0 || (size_t)v >= p->header.vertex_count)
            return fail(p, "%lld is not a vertex; expected an integer from 0 below %zu", v,
                        p->header.vertex_count);
        TRY(soup_add_index(p->s, p->l.context, (size_t)v));
    }
    return GRAZE_OK;
}

static graze_status read_entry(ply *p) {
    const ply_element *e = p->element;
    if (e->is_face)
        TRY(at_entry(p, facet_begin(p->s, p->l.context)));
    for (size_t k = 0; k < e->property_count; k++) {
        const ply_property *property = p->header.property + e->first + k;
        if (property->is_list)
            TRY(read_list(p, property));
        else if (property->role <= PLY_Z)
            TRY(read_coordinate(p, property->type, p->point + (property->role - PLY_X)));
        else
            TRY(pass_value(p, property->type));
    }
    return e->is_vertex ? at_entry(p, soup_add_vertex(p->s, p->l.context, p->point)) : GRAZE_OK;
}

static graze_status read_ply_element(ply *p) {
    int text = p->header.format == PLY_ASCII;
    for (p->entry = 0; p->entry < p->element->count; p->entry++) {
        token t;
        if (text && !lines_next(&p->l))
            return fail(p, "the file ends before this entry; %zu are declared", p->element->count);
        TRY(read_entry(p));
        if (text && lines_token(&p->l, &t))
            return fail(p, "'%.*s' is more than its properties ask", TOKEN_SHOWN(t));
    }
    return GRAZE_OK;
}

static graze_status read_body(ply *p) {
    for (size_t k = 0; k < p->header.element_count; k++) {
        p->element = p->header.element + k;
        TRY(read_ply_element(p));
    }
    if (p->header.format != PLY_ASCII && p->at < p->size)
        return context_fail_in(p->l.context, GRAZE_EINPUT, p->l.path, 0,
                               "byte %zu: %zu bytes follow the last element", p->at,
                               p->size - p->at);
    if (p->header.format == PLY_ASCII && lines_next(&p->l))
        return lines_fail(&p->l, GRAZE_EINPUT, "there is text after the last element");
    return GRAZE_OK;
}

/* Bytes up to the end of the line `end_header`; behind it the file may be binary. */
static size_t header_length(const char *text, size_t length) {
    static const char last[] = "end_header";
    size_t at = 0;
    int found = 0;
    while (at < length && !found) {
        const char *newline = memchr(text + at, '\n', length - at);
        size_t next = newline == NULL ? length : (size_t)(newline - text) + 1;
        while (at < next && (text[at] == ' ' || text[at] == '\t'))
            at++;
        found = next - at >= sizeof last - 1 && memcmp(text + at, last, sizeof last - 1) == 0;
        at = next;
    }
    return at;
}

/* Go to the byte behind the header and, in a text file, to the line there. */
static graze_status begin_body(ply *p, const char *text, size_t header, size_t length) {
    size_t line = p->l.line;
    p->at = header;
    p->data = (const unsigned char *)text;
    p->size = length;
    if (p->header.format != PLY_ASCII)
        return GRAZE_OK;
    TRY(lines_start(&p->l, text, length));
    if (header > 0) {
        p->l.at = text + header - (text[header - 1] == '\n');
        p->l.line = p->l.where = line;
    }
    return GRAZE_OK;
}

graze_status read_ply(soup *s, graze_context *context, const char *path, const char *text,
                      size_t length) {
    LOCAL_VEC(fmpq, point, 3);
    ply p = {.s = s, .l = {.context = context, .path = path, .marks = ""}, .point = point};
    size_t header = header_length(text, length);
    TRY(lines_start(&p.l, text, header));
    TRY(ply_header_read(&p.header, &p.l));
    graze_status status = begin_body(&p, text, header, length);
    if (status == GRAZE_OK)
        status = read_body(&p);
    ply_header_clear(&p.header);
    return status;
}
