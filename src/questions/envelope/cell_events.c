/* Lists the moments of events by the cells that the events name.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include "base/context/array.h"
#include "base/context/scope.h"
#include "input/soup/soup.h"
#include "questions/envelope/sign_events.h"

static const graze_cell NO_SECOND = {0, 0, 0};

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
        list->item[list->count++] = (cell_event){event->facet, NO_SECOND, moment};
    if (by_cell || event->kind == GRAZE_EVENT_REACH)
        list->item[list->count++] = (cell_event){event->cell, NO_SECOND, moment};
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
    return add_moments(cuts, context, list, &c->facet[facet].name, &NO_SECOND);
}

graze_status cuts_add_of_edge(numbers *cuts, graze_context *context, const cell_event_list *list,
                              const cell_complex *c, size_t edge) {
    const cell_edge *side = &c->edge[edge];
    TRY(add_moments(cuts, context, list, &side->name, &NO_SECOND));
    for (size_t j = c->edge_facets.start[edge]; j < c->edge_facets.start[edge + 1]; j++) {
        const graze_cell *facet = &c->facet[c->edge_facets.item[j]].name;
        TRY(add_moments(cuts, context, list, facet, &c->vertex[side->u].name));
        TRY(add_moments(cuts, context, list, facet, &c->vertex[side->v].name));
    }
    return GRAZE_OK;
}

graze_status cuts_add_of_vertex(numbers *cuts, graze_context *context, const cell_event_list *list,
                                const cell_complex *c, size_t vertex) {
    return add_moments(cuts, context, list, &c->vertex[vertex].name, &NO_SECOND);
}
