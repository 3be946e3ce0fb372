/* Patches, cell by cell. Between neighbouring moments of a cell its patches are its parts of the
 * curve of contact at one time. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/context/scope.h"
#include "questions/envelope/patch_ends.h"

/* Functions for one kind of cell: one adds a cell's parts at a time, the other the moments at which
 * these may change.
 */
typedef graze_status add_parts(graze_curve *c, graze_context *context, const snapshot *s,
                               size_t number);
typedef graze_status add_moments(numbers *cuts, graze_context *context, const cell_event_list *list,
                                 const cell_complex *c, size_t number);

/* The cell that names an end of a part: the vertex there, else the edge on which a slice ends or
 * the facet whose slice bounds a run. The ends of points and whole facets have no name. */
static graze_cell end_name(const cell_complex *c, graze_curve_kind kind, const part_end *end) {
    return kind == GRAZE_CURVE_POINT || kind == GRAZE_CURVE_WHOLE ? (graze_cell){0, 0, 0}
           : end->vertex != SIZE_MAX                              ? c->vertex[end->vertex].name
           : kind == GRAZE_CURVE_SLICE                            ? c->edge[end->edge].name
                                                                  : c->facet[end->facet].name;
}

static graze_status add_patch(graze_patches *p, graze_context *context, const curve_part *part,
                              const fmpq_t t, size_t from, size_t to) {
    const cell_complex *c = &p->envelope->cells;
    TRY(LIST_GROW(context, p, "the patches of an envelope"));
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
    memcpy(made->end, part->end, sizeof made->end);
    fmpq_init(made->t);
    fmpq_set(made->t, t);
    made->body = _fmpq_vec_init(c->dimension);
    made->world = _fmpq_vec_init(c->dimension);
    return parts_look_at_middle(&made->facts.trim, &made->facts.orientation, made->body,
                                made->world, context, p->envelope, part, t);
}

/* Add the patches of a cell between two moments, from the cell's parts at one time between them. */
static graze_status patches_between(graze_patches *p, graze_context *context, add_parts *find,
                                    size_t number, size_t from, size_t to) {
    HELD(contact_curve, curve, p->envelope->cells.dimension);
    ZEROED(snapshot, s);
    TRY(moments_between(curve.t, context, &p->moments, from, to));
    TRY(snapshot_make(&s, context, p->envelope, curve.t));
    TRY(find(&curve, context, &s, number));
    for (size_t k = 0; k < curve.count; k++)
        TRY(add_patch(p, context, &curve.part[k], curve.t, from, to));
    return GRAZE_OK;
}

/* Add the patches of all cells of one kind. */
static graze_status patches_of_cells(graze_patches *p, graze_context *context, add_parts *find,
                                     add_moments *add, size_t count) {
    ZEROED(numbers, cuts);
    for (size_t number = 0; number < count; number++) {
        TRY(cuts_start(&cuts, context, &p->moments));
        TRY(add(&cuts, context, &p->changes, &p->envelope->cells, number));
        numbers_sort(&cuts);
        for (size_t k = 1; k < cuts.count; k++)
            TRY(patches_between(p, context, find, number, cuts.item[k - 1], cuts.item[k]));
        TRY(context_work(context, 1000));
    }
    return GRAZE_OK;
}

static graze_status find_patches(graze_patches *out, graze_context *context) {
    const graze_envelope *e = out->envelope;
    const cell_complex *c = &e->cells;
    TRY(moments_make(&out->moments, context, e));
    TRY(cell_events_make(&out->changes, context, e, &out->moments));
    TRY(patches_of_cells(out, context, parts_of_facet, cuts_add_of_facet, c->facet_count));
    if (c->dimension == 3)
        TRY(patches_of_cells(out, context, parts_of_edge, cuts_add_of_edge, c->edge_count));
    TRY(patches_of_cells(out, context, parts_add_vertex, cuts_add_of_vertex, c->vertex_count));
    return joints_find(out, context);
}

graze_status patches_make(graze_patches *out, graze_context *context,
                          const graze_envelope *envelope) {
    *out = (graze_patches){.envelope = envelope};
    graze_status status = find_patches(out, context);
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
