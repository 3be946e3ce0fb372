/* All parts of a curve, their middles and chains. SPDX-License-Identifier: GPL-3.0-or-later */
#include "questions/envelope/envelope.h"

#include <flint/fmpq_vec.h>
#include <stdlib.h>
#include <string.h>
#include "base/context/scope.h"
#include "questions/contact/contact.h"
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

/* The verdict and orientation of a part's middle. */
static graze_status look_at_middle(curve_part *part, graze_context *context, const snapshot *s) {
    int d = s->dimension;
    graze_site site;
    LOCAL_VEC(fmpq, middle, d);
    for (int i = 0; i < d; i++) {
        fmpq_add(middle + i, part->a + i, part->b + i);
        fmpq_div_2exp(middle + i, middle + i, 1);
    }
    TRY(site_make_for(&site, context, s->e->scene, s->t, middle, SITE_TRIM));
    part->facts.trim = site.facts.trim;
    part->facts.orientation = site.facts.on_slice ? site.facts.orientation : GRAZE_ORIENTATION_NONE;
    site_clear(&site);
    return GRAZE_OK;
}

static graze_status judge_parts(graze_curve *c, graze_context *context, const snapshot *s) {
    graze_status status = GRAZE_OK;
    for (size_t k = 0; k < c->count && !status; k++)
        status = look_at_middle(&c->part[k], context, s);
    if (!status && c->dimension == 3)
        status = chains_find(c, context, &s->e->cells);
    for (size_t k = 0; k < c->count && c->dimension == 2; k++)
        c->part[k].facts.chain = k;
    return status;
}

static graze_status make_contact_curve(graze_curve *out, graze_context *context,
                                       const graze_envelope *e, const fmpq_t t, int whole) {
    snapshot s;
    memset(out, 0, sizeof *out);
    out->dimension = e->cells.dimension;
    fmpq_init(out->t);
    fmpq_set(out->t, t);
    graze_status status = snapshot_make(&s, context, e, t);
    if (!status)
        status = find_parts(out, context, &s);
    if (!status && whole)
        status = judge_parts(out, context, &s);
    snapshot_clear(&s);
    if (status)
        contact_curve_clear(out);
    return status;
}

graze_status contact_curve_find(graze_curve *out, graze_context *context, const graze_envelope *e,
                                const fmpq_t t) {
    return make_contact_curve(out, context, e, t, 0);
}

graze_status contact_curve_make(graze_curve *out, graze_context *context, const graze_envelope *e,
                                const fmpq_t t) {
    return make_contact_curve(out, context, e, t, 1);
}

void contact_curve_clear(graze_curve *c) {
    for (size_t k = 0; k < c->count; k++) {
        _fmpq_vec_clear(c->part[k].a, c->dimension);
        _fmpq_vec_clear(c->part[k].b, c->dimension);
    }
    free(c->part);
    fmpq_clear(c->t);
}
