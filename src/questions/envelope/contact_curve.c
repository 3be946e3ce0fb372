/* Finds all parts of a curve at a time, classifies their middles, and chains them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/context/scope.h"
#include "base/number/vector.h"
#include "questions/envelope/patch_ends.h"

/* An end of a part, and the number of the part. */
typedef struct chain_end {
    const fmpq *at;
    size_t part;
    int dimension;
} chain_end;

static int compare_chain_ends(const void *left, const void *right) {
    const chain_end *a = left, *b = right;
    return vector_compare(a->at, b->at, a->dimension);
}

/* The first part of the chain to which part k belongs. */
static size_t root_of(size_t *parent, size_t k) {
    while (parent[k] != k)
        k = parent[k] = parent[parent[k]];
    return k;
}

static void unite(size_t *parent, size_t a, size_t b) {
    a = root_of(parent, a);
    b = root_of(parent, b);
    parent[a < b ? b : a] = a < b ? a : b;
}

static int is_segment(const curve_part *p) {
    return p->facts.kind == GRAZE_CURVE_SLICE || p->facts.kind == GRAZE_CURVE_RUN;
}

/* List the ends of all segments, sorted by position. */
static size_t list_ends(chain_end *end, const graze_curve *c) {
    size_t count = 0;
    for (size_t k = 0; k < c->count; k++)
        if (is_segment(&c->part[k])) {
            end[count++] = (chain_end){c->part[k].a, k, c->dimension};
            end[count++] = (chain_end){c->part[k].b, k, c->dimension};
        }
    qsort(end, count, sizeof *end, compare_chain_ends);
    return count;
}

/* Join parts at common ends. `form` of a part becomes the worse of the forms at its two ends:
 * closed, open, branching. */
static void join_ends(graze_curve *c, size_t *parent, const chain_end *end, size_t count) {
    for (size_t first = 0, next; first < count; first = next) {
        for (next = first + 1; next < count && compare_chain_ends(&end[first], &end[next]) == 0;
             next++)
            unite(parent, end[first].part, end[next].part);
        graze_chain_form form = next - first == 2   ? GRAZE_CHAIN_CLOSED
                                : next - first == 1 ? GRAZE_CHAIN_OPEN
                                                    : GRAZE_CHAIN_BRANCHING;
        for (size_t k = first; k < next; k++)
            if (form > c->part[end[k].part].facts.form)
                c->part[end[k].part].facts.form = form;
    }
}

/* Join a part that is a whole facet with all segments that end in that facet. */
static void join_whole(graze_curve *c, size_t *parent, const cell_complex *cells, size_t part) {
    size_t facet = c->part[part].number;
    c->part[part].facts.form = GRAZE_CHAIN_BRANCHING;
    for (size_t k = 0; k < c->count; k++)
        if (is_segment(&c->part[k]) && (parts_facet_holds(cells, facet, c->part[k].a) ||
                                        parts_facet_holds(cells, facet, c->part[k].b)))
            unite(parent, part, k);
}

/* Set `chain` and `form` of all parts of a curve (E^3), by the ends that parts share. */
static graze_status chains_find(graze_curve *c, graze_context *context, const cell_complex *cells) {
    size_t number = 0;
    FREED(size_t, parent, malloc((c->count + 1) * sizeof *parent));
    FREED(chain_end, end, malloc((2 * c->count + 1) * sizeof *end));
    if (!parent || !end)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for chains");
    for (size_t k = 0; k < c->count; k++)
        parent[k] = k;
    join_ends(c, parent, end, list_ends(end, c));
    for (size_t k = 0; k < c->count; k++)
        if (c->part[k].facts.kind == GRAZE_CURVE_WHOLE)
            join_whole(c, parent, cells, k);
    for (size_t k = 0; k < c->count; k++) {
        curve_part *first = &c->part[root_of(parent, k)];
        if (c->part[k].facts.form > first->facts.form)
            first->facts.form = c->part[k].facts.form;
        c->part[k].facts.chain = first == &c->part[k] ? number++ : first->facts.chain;
    }
    for (size_t k = 0; k < c->count; k++)
        c->part[k].facts.form = c->part[root_of(parent, k)].facts.form;
    return GRAZE_OK;
}

static graze_status find_parts(graze_curve *c, graze_context *context, const snapshot *s) {
    const cell_complex *cells = &s->e->cells;
    for (size_t k = 0; k < cells->facet_count; k++) {
        TRY(parts_of_facet(c, context, s, k));
        TRY(context_work(context, 1000));
    }
    for (size_t k = 0; k < cells->edge_count && cells->dimension == 3; k++)
        TRY(parts_of_edge(c, context, s, k));
    for (size_t k = 0; k < cells->vertex_count; k++)
        TRY(parts_of_vertex(c, context, s, k));
    return GRAZE_OK;
}

static graze_status judge_parts(graze_curve *c, graze_context *context, const graze_envelope *e) {
    LOCAL_VEC(fmpq, middle, c->dimension);
    for (size_t k = 0; k < c->count; k++) {
        curve_part *part = &c->part[k];
        TRY(parts_look_at_middle(&part->facts.trim, &part->facts.orientation, middle, NULL, context,
                                 e, part, c->t));
        part->facts.chain = k;
    }
    return c->dimension == 3 ? chains_find(c, context, &e->cells) : GRAZE_OK;
}

graze_status contact_curve_find(graze_curve *out, graze_context *context, const graze_envelope *e,
                                const fmpq_t t) {
    ZEROED(snapshot, s);
    contact_curve_init(out, e->cells.dimension);
    fmpq_set(out->t, t);
    graze_status status = snapshot_make(&s, context, e, t);
    if (!status)
        status = find_parts(out, context, &s);
    if (status)
        contact_curve_clear(out);
    return status;
}

graze_status contact_curve_make(graze_curve *out, graze_context *context, const graze_envelope *e,
                                const fmpq_t t) {
    TRY(contact_curve_find(out, context, e, t));
    graze_status status = judge_parts(out, context, e);
    if (status)
        contact_curve_clear(out);
    return status;
}

void contact_curve_init(graze_curve *c, int dimension) {
    *c = (graze_curve){.dimension = dimension};
    fmpq_init(c->t);
}

void contact_curve_clear(graze_curve *c) {
    for (size_t k = 0; k < c->count; k++) {
        _fmpq_vec_clear(c->part[k].a, c->dimension);
        _fmpq_vec_clear(c->part[k].b, c->dimension);
    }
    free(c->part);
    fmpq_clear(c->t);
}
