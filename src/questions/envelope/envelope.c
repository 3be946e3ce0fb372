/* Makes cells and fields, and gathers events and findings of each cell.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/context/scope.h"
#include "questions/envelope/patch_ends.h"

/* Refuse a piece whose polynomials demand too much work. For each facet, roots of many minors and
 * products of these polynomials are sought; numbers of facets and pieces, which the files fix, do
 * not count. */
static graze_status check_demand(graze_context *context, const derivatives *field) {
    enum { FUNCTIONS = 128 };
    double demand = 0;
    for (int k = 0; k < FIELD_ORDERS; k++)
        for (int i = 0; i < field->dimension * (field->dimension + 1); i++)
            demand += FUNCTIONS * demand_of_roots(&field->entry[k][i]);
    return demand > (double)context->limits[GRAZE_LIMIT_WORK]
               ? context_limit(context, GRAZE_LIMIT_WORK, "the events of an envelope")
               : GRAZE_OK;
}

static graze_status make_fields(graze_envelope *e, graze_context *context) {
    const graze_motion *motion = e->scene->motion;
    size_t n = motion->piece_count;
    TRY(MAKE_ARRAY(context, e->field, n, "the pieces of a motion"));
    TRY(MAKE_ARRAY(context, e->is_break, n, "the pieces of a motion"));
    TRY(MAKE_ARRAY(context, e->still, n * e->cells.facet_count, "the pieces of a motion"));
    for (size_t k = 0; k < n; k++) {
        site_side side[2] = {{.present = 1, .piece = k ? k - 1 : 0}, {.present = 1, .piece = k}};
        e->is_break[k] = (unsigned char)(k > 0 && sides_break(side, motion));
        graze_status status = piece_field_make(&e->field[k], context, &motion->piece[k], &e->cells);
        e->piece_count++;
        TRY(status);
        TRY(check_demand(context, &e->field[k]));
        TRY(context_poll(context));
    }
    return GRAZE_OK;
}

static graze_status gather_facet(graze_envelope *e, graze_context *context, size_t facet) {
    const cell_complex *c = &e->cells;
    for (size_t j = c->facet_edges.start[facet]; j < c->facet_edges.start[facet + 1]; j++)
        TRY(gather_slice(e, context, facet, c->facet_edges.item[j]));
    if (c->dimension == 3)
        TRY(singular_gather(e, context, facet));
    return GRAZE_OK;
}

static graze_status gather_edge(graze_envelope *e, graze_context *context, size_t edge) {
    const cell_lists *lists = &e->cells.edge_facets;
    for (size_t i = lists->start[edge]; i < lists->start[edge + 1]; i++)
        for (size_t j = i + 1; j < lists->start[edge + 1]; j++)
            TRY(gather_meet(e, context, edge, lists->item[i], lists->item[j]));
    return GRAZE_OK;
}

static graze_status gather_vertex(graze_envelope *e, graze_context *context, size_t vertex) {
    const cell_complex *c = &e->cells;
    place_kind kind = c->vertex[vertex].kind;
    for (size_t j = c->vertex_facets.start[vertex]; j < c->vertex_facets.start[vertex + 1]; j++)
        TRY(gather_corner(e, context, c->vertex_facets.item[j], vertex));
    if (kind != PLACE_REFLEX && kind != PLACE_OTHER)
        return GRAZE_OK;
    TRY(saddle_gather(e, context, vertex));
    return saddle_judge(e, context, vertex);
}

static graze_status gather(graze_envelope *e, graze_context *context) {
    TRY(complex_make(&e->cells, context, e->scene->solid));
    TRY(make_fields(e, context));
    for (size_t k = 0; k < e->cells.facet_count; k++)
        TRY(gather_whole(e, context, k));
    for (size_t k = 0; k < e->cells.facet_count; k++)
        TRY(gather_facet(e, context, k));
    for (size_t k = 0; k < e->cells.edge_count; k++)
        TRY(gather_edge(e, context, k));
    for (size_t k = 0; k < e->cells.vertex_count; k++)
        TRY(gather_vertex(e, context, k));
    for (size_t k = 1; k < e->piece_count; k++)
        if (e->is_break[k])
            TRY(breaks_judge(e, context, k));
    return events_finish(&e->events, context);
}

graze_status envelope_make(graze_envelope *out, graze_context *context, const graze_scene *scene) {
    memset(out, 0, sizeof *out);
    out->scene = scene;
    out->found.reason = GRAZE_REASON_POSITIVE;
    events_init(&out->events, scene->motion);
    graze_status status = gather(out, context);
    if (status)
        envelope_clear(out);
    return status;
}

void envelope_clear(graze_envelope *e) {
    for (size_t k = 0; k < e->piece_count; k++)
        derivatives_clear(&e->field[k]);
    free(e->field);
    free(e->is_break);
    free(e->still);
    complex_clear(&e->cells);
    events_clear(&e->events);
    time_destroy(e->found.time);
}
