/* Patches cell by cell: the parts of the curve of contact at one time between two moments that
 * concern the cell. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/envelope/envelope.h"

#include <flint/fmpq_vec.h>
#include <stdlib.h>
#include <string.h>
#include "base/context/array.h"
#include "base/context/scope.h"
#include "decide/bounds/bounds.h"
#include "questions/contact/contact.h"
#include "questions/envelope/patch_ends.h"
#include "questions/envelope/sign_events.h"

/* A kind of cell: its parts at a time, and the moments that concern it. */
typedef graze_status add_parts(graze_curve *c, graze_context *context, const snapshot *s,
                               size_t number);
typedef graze_status add_moments(moment_cuts *cuts, graze_context *context,
                                 const cell_event_list *list, const cell_complex *c, size_t number);

/* The cell that an end is named by: its vertex; the edge on which a slice ends; the facet whose
 * slice bounds a run. */
static graze_cell end_name(const cell_complex *c, graze_curve_kind kind, const part_end *end) {
    return kind == GRAZE_CURVE_POINT || kind == GRAZE_CURVE_WHOLE ? (graze_cell){0, 0, 0}
           : end->vertex != SIZE_MAX                              ? c->vertex[end->vertex].name
           : kind == GRAZE_CURVE_SLICE                            ? c->edge[end->edge].name
                                                                  : c->facet[end->facet].name;
}

/* The sample: the middle of a part. */
static graze_status look_at_sample(patch *made, graze_context *context, const graze_envelope *e,
                                   const curve_part *part) {
    int d = e->cells.dimension;
    graze_site site;
    for (int i = 0; i < d; i++) {
        fmpq_add(made->body + i, part->a + i, part->b + i);
        fmpq_div_2exp(made->body + i, made->body + i, 1);
    }
    TRY(site_make_for(&site, context, e->scene, made->t, made->body, SITE_TRIM));
    made->facts.trim = site.facts.trim;
    made->facts.orientation = site.facts.on_slice ? site.facts.orientation : GRAZE_ORIENTATION_NONE;
    for (int i = 0; i < d; i++)
        fmpq_set(made->world + i, site.world + i);
    site_clear(&site);
    return GRAZE_OK;
}

static graze_status add_patch(graze_patches *p, graze_context *context, const curve_part *part,
                              const fmpq_t t, size_t from, size_t to) {
    const cell_complex *c = &p->envelope->cells;
    TRY(array_grow(context, &p->item, &p->capacity, p->count + 1, sizeof *p->item,
                   "the patches of an envelope"));
    patch *made = &p->item[p->count++];
    memset(made, 0, sizeof *made);
    made->number = part->number;
    made->from = from;
    made->to = to;
    made->facts = (graze_patch){.kind = part->facts.kind,
                                .cell = part->facts.cell,
                                .from = p->moments.time[from],
                                .to = p->moments.time[to],
                                .a = end_name(c, part->facts.kind, &part->end[0]),
                                .b = end_name(c, part->facts.kind, &part->end[1]),
                                .theta_a = part->facts.theta_a,
                                .theta_b = part->facts.theta_b};
    made->end[0] = part->end[0];
    made->end[1] = part->end[1];
    fmpq_init(made->t);
    fmpq_set(made->t, t);
    made->body = _fmpq_vec_init(c->dimension);
    made->world = _fmpq_vec_init(c->dimension);
    return look_at_sample(made, context, p->envelope, part);
}

/* The parts of a cell at one time between two moments. */
static graze_status patches_between(graze_patches *p, graze_context *context, add_parts *find,
                                    size_t number, size_t from, size_t to) {
    snapshot s;
    graze_curve curve = {.dimension = p->envelope->cells.dimension};
    fmpq_init(curve.t);
    graze_status status = moments_between(curve.t, context, &p->moments, from, to);
    if (!status) {
        status = snapshot_make(&s, context, p->envelope, curve.t);
        if (!status)
            status = find(&curve, context, &s, number);
        snapshot_clear(&s);
    }
    for (size_t k = 0; k < curve.count && !status; k++)
        status = add_patch(p, context, &curve.part[k], curve.t, from, to);
    contact_curve_clear(&curve);
    return status;
}

/* The patches of all cells of one kind. */
static graze_status patches_of_cells(graze_patches *p, graze_context *context, add_parts *find,
                                     add_moments *add, size_t count) {
    moment_cuts cuts = {.count = 0};
    graze_status status = GRAZE_OK;
    for (size_t number = 0; number < count && !status; number++) {
        status = cuts_start(&cuts, context, &p->moments);
        if (!status)
            status = add(&cuts, context, &p->changes, &p->envelope->cells, number);
        if (!status)
            cuts_sort(&cuts);
        for (size_t k = 1; k < cuts.count && !status; k++)
            status = patches_between(p, context, find, number, cuts.item[k - 1], cuts.item[k]);
        if (!status)
            status = context_work(context, 1000);
    }
    free(cuts.item);
    return status;
}

graze_status patches_make(graze_patches *out, graze_context *context,
                          const graze_envelope *envelope) {
    const cell_complex *c = &envelope->cells;
    memset(out, 0, sizeof *out);
    out->envelope = envelope;
    graze_status status = moments_make(&out->moments, context, envelope);
    if (!status)
        status = cell_events_make(&out->changes, context, envelope, &out->moments);
    if (!status)
        status = patches_of_cells(out, context, parts_of_facet, cuts_add_of_facet, c->facet_count);
    if (!status && c->dimension == 3)
        status = patches_of_cells(out, context, parts_of_edge, cuts_add_of_edge, c->edge_count);
    if (!status)
        status =
            patches_of_cells(out, context, parts_add_vertex, cuts_add_of_vertex, c->vertex_count);
    if (!status)
        status = joints_find(out, context);
    if (status)
        patches_clear(out);
    return status;
}

void patches_clear(graze_patches *p) {
    int d = p->envelope->cells.dimension;
    for (size_t k = 0; k < p->count; k++) {
        fmpq_clear(p->item[k].t);
        _fmpq_vec_clear(p->item[k].body, d);
        _fmpq_vec_clear(p->item[k].world, d);
    }
    free(p->item);
    free(p->joint);
    free(p->member);
    cell_events_clear(&p->changes);
    moments_clear(&p->moments);
}
