/* Facets of a mesh that is being mended.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <stdarg.h>
#include <stdio.h>
#include "base/context/scope.h"
#include "base/number/vector.h"
#include "input/mend/mesh.h"

enum { FEW = 8 };

graze_status facets_begin(facets *f, graze_context *context, size_t origin) {
    TRY(numbers_add(&f->origin, context, origin, "a solid"));
    TRY(soup_add_facet(&f->of, context));
    return soup_add_cycle(&f->of, context, NULL, 0);
}

void facets_drop_last(facets *f) {
    f->origin.count--;
    f->of.facet_count--;
    f->of.index_count = f->of.cycle_start[--f->of.cycle_count];
}

void facets_clear(facets *f) {
    soup_clear(&f->of);
    numbers_clear(&f->origin);
}

void mesh_replace(mesh *m, facets *f) {
    facets before = m->now;
    m->now = *f;
    *f = before;
}

graze_status mesh_init(mesh *m, graze_context *context, const soup *input) {
    *m = (mesh){.context = context, .input = input};
    text_init(&m->report);
    for (size_t f = 0; f < input->facet_count; f++) {
        size_t cycle = input->facet_start[f];
        TRY(facets_begin(&m->now, context, f));
        for (size_t k = input->cycle_start[cycle]; k < input->cycle_start[cycle + 1]; k++)
            TRY(soup_add_index(&m->now.of, context, input->index[k]));
    }
    return GRAZE_OK;
}

void mesh_clear(mesh *m) {
    facets_clear(&m->now);
    text_clear(&m->report);
}

const fmpq *mesh_point(const mesh *m, uint32_t vertex) {
    return m->input->coordinates + 3 * (size_t)vertex;
}

int mesh_collinear(const mesh *m, uint32_t a, uint32_t b, uint32_t c) {
    return vector_collinear(mesh_point(m, a), mesh_point(m, b), mesh_point(m, c));
}

static int order_of_sides(const void *a, const void *b) {
    const mesh_side *x = a, *y = b;
    if (x->low != y->low)
        return x->low < y->low ? -1 : 1;
    if (x->high != y->high)
        return x->high < y->high ? -1 : 1;
    return (x->corner > y->corner) - (x->corner < y->corner);
}

graze_status mesh_sides(mesh_side **out, size_t *count, const mesh *m) {
    const soup *f = &m->now.of;
    *count = 0;
    TRY(MAKE_ARRAY(m->context, *out, f->index_count + 1, "the sides of facets"));
    for (size_t k = 0; k < f->cycle_count; k++)
        for (size_t c = f->cycle_start[k]; c < f->cycle_start[k + 1]; c++) {
            uint32_t from = f->index[c];
            uint32_t to = f->index[c + 1 < f->cycle_start[k + 1] ? c + 1 : f->cycle_start[k]];
            (*out)[(*count)++] =
                (mesh_side){from < to ? from : to, from < to ? to : from, k, c, from < to};
        }
    qsort(*out, *count, sizeof **out, order_of_sides);
    return GRAZE_OK;
}

size_t mesh_edge_end(const mesh_side *side, size_t count, size_t first) {
    size_t end = first;
    while (end < count && side[end].low == side[first].low && side[end].high == side[first].high)
        end++;
    return end;
}

/* Give a vertex a number in the soup, unless it has one. */
static graze_status number_vertex(soup *out, const mesh *m, uint32_t *number, uint32_t vertex) {
    if (number[vertex] != UINT32_MAX)
        return GRAZE_OK;
    number[vertex] = (uint32_t)out->vertex_count;
    return soup_add_vertex(out, m->context, mesh_point(m, vertex));
}

static graze_status add_soup_facet(soup *out, const mesh *m, uint32_t *number, size_t facet,
                                   int turned) {
    const soup *f = &m->now.of;
    size_t first = f->cycle_start[facet], end = f->cycle_start[facet + 1];
    TRY(soup_add_facet(out, m->context));
    TRY(soup_add_cycle(out, m->context, NULL, 0));
    for (size_t k = first; k < end; k++) {
        uint32_t vertex = f->index[turned ? end - 1 - (k - first) : k];
        TRY(number_vertex(out, m, number, vertex));
        TRY(soup_add_index(out, m->context, number[vertex]));
    }
    return GRAZE_OK;
}

graze_status mesh_soup(soup *out, const mesh *m, const size_t *component, size_t wanted,
                       const unsigned char *turned) {
    size_t n = m->input->vertex_count;
    FREED(uint32_t, number, NULL);
    graze_status status = GRAZE_OK;
    soup_init(out, 3);
    TRY(MAKE_ARRAY(m->context, number, n + 1, "%zu vertices", n));
    memset(number, 0xff, (n + 1) * sizeof *number);
    for (size_t f = 0; f < m->now.of.cycle_count && !status; f++)
        if (!component || component[f] == wanted)
            status = add_soup_facet(out, m, number, f, turned && turned[f]);
    if (status)
        soup_clear(out);
    return status;
}

void few_add(few *f, const char *format, ...) {
    char name[96];
    va_list arguments;
    if (f->count++ >= FEW)
        return;
    va_start(arguments, format);
    vsnprintf(name, sizeof name, format, arguments);
    va_end(arguments);
    text_format(&f->names, "%s%s", f->count > 1 ? ", " : "", name);
}

void few_report(few *f, mesh *m, const char *what, const char *things) {
    if (f->count)
        text_format(&m->report, "%s %zu %s: %s%s\n", what, f->count, things,
                    f->names.data ? f->names.data : "", f->count > FEW ? ", ..." : "");
    m->report.failed |= f->names.failed;
    text_clear(&f->names);
    f->count = 0;
}
