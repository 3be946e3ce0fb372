/* Merges the times of events with the ends and breaks of the motion, and lists them by the cells
 * that the events name; velocities at a time between moments.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/context/scope.h"
#include "questions/envelope/patch_ends.h"

static int is_parameter(const graze_time *time, size_t piece, slong u) {
    return time->piece == piece && algebraic_is_rational(&time->u) &&
           fmpz_is_one(fmpq_denref(time->u.value)) && fmpz_equal_si(fmpq_numref(time->u.value), u);
}

static void append_event_time(moment_list *list, const event_list *events, size_t k) {
    list->of_event[k] = list->count;
    list->time[list->count++] = events->time[k];
}

/* Append the end u = 0 or 1 of a piece as a hard moment. If time `*next` of the events is this end,
 * that time is taken. */
static graze_status append_boundary(moment_list *list, graze_context *context,
                                    const event_list *events, size_t *next, size_t piece, slong u) {
    list->hard[list->hard_count++] = list->count;
    if (*next < events->time_count && is_parameter(events->time[*next], piece, u)) {
        append_event_time(list, events, (*next)++);
        return GRAZE_OK;
    }
    HELD(algebraic, at);
    fmpq_set_si(at.value, u, 1);
    graze_time *time;
    TRY(time_make(&time, context, events->motion, piece, &at));
    list->own[list->own_count++] = time;
    list->time[list->count++] = time;
    return GRAZE_OK;
}

graze_status moments_make(moment_list *out, graze_context *context, const graze_envelope *e) {
    const event_list *events = &e->events;
    size_t room = events->time_count + e->piece_count + 1, next = 0;
    memset(out, 0, sizeof *out);
    TRY(MAKE_ARRAY(context, out->time, room, "times"));
    TRY(MAKE_ARRAY(context, out->own, room, "times"));
    TRY(MAKE_ARRAY(context, out->hard, e->piece_count + 1, "times"));
    TRY(MAKE_ARRAY(context, out->of_event, room, "times"));
    for (size_t piece = 0; piece < e->piece_count; piece++) {
        if (piece == 0 || e->is_break[piece])
            TRY(append_boundary(out, context, events, &next, piece, 0));
        int is_last = piece + 1 == e->piece_count;
        while (next < events->time_count && events->time[next]->piece == piece &&
               !(is_last && is_parameter(events->time[next], piece, 1)))
            append_event_time(out, events, next++);
    }
    return append_boundary(out, context, events, &next, e->piece_count - 1, 1);
}

void moments_clear(moment_list *list) {
    for (size_t k = 0; k < list->own_count; k++)
        time_destroy(list->own[k]);
    free(list->own);
    free(list->time);
    free(list->hard);
    free(list->of_event);
}

graze_status moments_between(fmpq_t out, graze_context *context, const moment_list *list,
                             size_t from, size_t to) {
    const graze_time *first = list->time[from], *last = list->time[to];
    const motion_piece *piece = &first->motion->piece[first->piece];
    HELD(algebraic, low);
    HELD(algebraic, high);
    algebraic_set(&low, &first->u);
    fmpq_one(high.value);
    if (last->piece == first->piece)
        algebraic_set(&high, &last->u);
    TRY(algebraic_between(out, context, &low, &high));
    motion_time_at(out, piece, out);
    return GRAZE_OK;
}

/* Set the parameter u of a piece at time t. Returns 0 if t is not in the piece, or if it is an end
 * or a break of the motion. */
static int parameter_within(fmpq_t u, const graze_envelope *e, size_t piece, const fmpq_t t) {
    const motion_piece *p = &e->scene->motion->piece[piece];
    if (fmpq_cmp(t, p->lo) < 0 || fmpq_cmp(t, p->hi) >= 0 ||
        (fmpq_equal(t, p->lo) && (piece == 0 || e->is_break[piece])))
        return 0;
    motion_parameter_at(u, p, t);
    return 1;
}

/* Evaluate the polynomials of a field, as a map of a flow. */
static void evaluate_entries(fmpz *out, const fmpz_poly_struct *entry, int count, const fmpq_t u) {
    LOCAL_VEC(fmpq, value, count);
    for (int k = 0; k < count; k++)
        fmpz_poly_evaluate_fmpq(value + k, entry + k, u);
    _fmpq_vec_get_fmpz_vec_fmpz(out, out + count, value, count);
}

graze_status snapshot_make(snapshot *out, graze_context *context, const graze_envelope *e,
                           const fmpq_t t) {
    int d = e->cells.dimension, count = d * (d + 1), found = 0;
    *out = (snapshot){.e = e, .dimension = d, .velocity = _fmpz_vec_init(2 * (count + 1))};
    out->bend = out->velocity + count + 1;
    fmpq_init(out->t);
    fmpq_set(out->t, t);
    LOCAL(fmpq, u);
    for (size_t piece = 0; piece < e->piece_count && !found; piece++) {
        found = parameter_within(u, e, piece, t);
        if (found) {
            evaluate_entries(out->velocity, e->field[piece].entry[0], count, u);
            evaluate_entries(out->bend, e->field[piece].entry[1], count, u);
        }
    }
    return found ? GRAZE_OK
                 : context_fail(context, GRAZE_EINPUT,
                                "the time of a curve is an end or a break of the motion, or not in "
                                "it; expected one at which the motion is smooth");
}

void snapshot_clear(snapshot *s) {
    fmpq_clear(s->t);
    if (s->velocity)
        _fmpz_vec_clear(s->velocity, 2 * (s->dimension * (s->dimension + 1) + 1));
}

void snapshot_g(fmpq_t out, const snapshot *s, size_t facet, const fmpq *y) {
    flow_along(out, s->e->cells.facet[facet].normal, s->velocity, y, s->dimension);
    fmpq_neg(out, out);
}

int snapshot_g_sign(const snapshot *s, size_t facet, const fmpq *y) {
    LOCAL(fmpq, value);
    snapshot_g(value, s, facet, y);
    return fmpq_sgn(value);
}

int snapshot_theta_sign(const snapshot *s, size_t facet, const fmpq *y) {
    LOCAL(fmpq, value);
    flow_along(value, s->e->cells.facet[facet].normal, s->bend, y, s->dimension);
    return fmpq_sgn(value);
}

static int compare_keys(const cell_event *a, const cell_event *b) {
    int order = cell_compare(&a->first, &b->first);
    return order ? order : cell_compare(&a->second, &b->second);
}

static int compare_cell_events(const void *left, const void *right) {
    const cell_event *a = left, *b = right;
    int order = compare_keys(a, b);
    return order ? order : a->moment < b->moment ? -1 : a->moment > b->moment;
}

/* A `reach` is listed under its facet, its vertex and the pair of both, a `saddle` or `meet` under
 * its cell, any other event under its facet.
 */
static void list_event(cell_event_list *list, const found_event *event, size_t moment) {
    int by_cell = event->kind == GRAZE_EVENT_SADDLE || event->kind == GRAZE_EVENT_MEET;
    if (!by_cell)
        list->item[list->count++] = (cell_event){event->facet, NO_CELL, moment};
    if (by_cell || event->kind == GRAZE_EVENT_REACH)
        list->item[list->count++] = (cell_event){event->cell, NO_CELL, moment};
    if (event->kind == GRAZE_EVENT_REACH)
        list->item[list->count++] = (cell_event){event->facet, event->cell, moment};
}

graze_status cell_events_make(cell_event_list *out, graze_context *context, const graze_envelope *e,
                              const moment_list *moments) {
    const event_list *events = &e->events;
    *out = (cell_event_list){.item = malloc((3 * events->count + 1) * sizeof *out->item)};
    if (!out->item)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for the events of cells");
    for (size_t k = 0; k < events->count; k++)
        list_event(out, &events->item[k], moments->of_event[events->item[k].time]);
    qsort(out->item, out->count, sizeof *out->item, compare_cell_events);
    return GRAZE_OK;
}

void cell_events_clear(cell_event_list *list) {
    free(list->item);
}

graze_status cuts_add(numbers *cuts, graze_context *context, size_t moment) {
    return numbers_add(cuts, context, moment, "the changes of a cell");
}

graze_status cuts_start(numbers *cuts, graze_context *context, const moment_list *moments) {
    cuts->count = 0;
    for (size_t k = 0; k < moments->hard_count; k++)
        TRY(cuts_add(cuts, context, moments->hard[k]));
    return GRAZE_OK;
}

/* Add the moments of all events of one pair (first, second). */
static graze_status add_moments(numbers *cuts, graze_context *context, const cell_event_list *list,
                                const graze_cell *first, const graze_cell *second) {
    cell_event key = {*first, *second, 0};
    size_t k = array_first(&key, list->item, list->count, sizeof *list->item, compare_cell_events);
    for (; k < list->count && compare_keys(&list->item[k], &key) == 0; k++)
        TRY(cuts_add(cuts, context, list->item[k].moment));
    return GRAZE_OK;
}

graze_status cuts_add_of_facet(numbers *cuts, graze_context *context, const cell_event_list *list,
                               const cell_complex *c, size_t facet) {
    return add_moments(cuts, context, list, &c->facet[facet].name, &NO_CELL);
}

graze_status cuts_add_of_edge(numbers *cuts, graze_context *context, const cell_event_list *list,
                              const cell_complex *c, size_t edge) {
    const cell_edge *side = &c->edge[edge];
    TRY(add_moments(cuts, context, list, &side->name, &NO_CELL));
    for (size_t j = c->edge_facets.start[edge]; j < c->edge_facets.start[edge + 1]; j++) {
        const graze_cell *facet = &c->facet[c->edge_facets.item[j]].name;
        TRY(add_moments(cuts, context, list, facet, &c->vertex[side->u].name));
        TRY(add_moments(cuts, context, list, facet, &c->vertex[side->v].name));
    }
    return GRAZE_OK;
}

graze_status cuts_add_of_vertex(numbers *cuts, graze_context *context, const cell_event_list *list,
                                const cell_complex *c, size_t vertex) {
    return add_moments(cuts, context, list, &c->vertex[vertex].name, &NO_CELL);
}
