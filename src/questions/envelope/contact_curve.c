/* Finds all parts of a curve, classifies their middles, and chains them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <flint/fmpq_vec.h>
#include <stdlib.h>
#include <string.h>
#include "base/context/scope.h"
#include "questions/envelope/patch_ends.h"

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

static graze_status find_at(graze_curve *out, graze_context *context, const graze_envelope *e,
                            const fmpq_t t) {
    ZEROED(snapshot, s);
    TRY(snapshot_make(&s, context, e, t));
    return find_parts(out, context, &s);
}

graze_status contact_curve_find(graze_curve *out, graze_context *context, const graze_envelope *e,
                                const fmpq_t t) {
    contact_curve_init(out, e->cells.dimension);
    fmpq_set(out->t, t);
    graze_status status = find_at(out, context, e, t);
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
