/* Counts errors by the value of a column.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Groups past MOST_GROUPS are counted together, so that a column of different names costs no
 * memory.
 */
#include "compare/tally.h"

#include <stdlib.h>
#include <string.h>
#include "context/array.h"
#include "context/context.h"

static group *find(tally *t, field name) {
    for (size_t k = 0; k < t->count; k++)
        if (field_is(name, t->groups[k].name))
            return &t->groups[k];
    return NULL;
}

static group *append(tally *t, field name) {
    if (t->count == MOST_GROUPS)
        return &t->others;
    if (!array_reserve(&t->groups, &t->capacity, t->count + 1, sizeof *t->groups))
        return NULL;
    group *g = &t->groups[t->count];
    memset(g, 0, sizeof *g);
    g->name = strndup(name.start, name.length);
    t->count += g->name != NULL;
    return g->name ? g : NULL;
}

graze_status tally_add(tally *t, graze_context *context, field name, char status) {
    group *g = find(t, name);
    if (!g)
        g = append(t, name);
    if (!g)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory");
    g->rows++;
    g->wrong += status == 'w';
    g->apart += status == 'p';
    g->missing += status == 'm';
    return GRAZE_OK;
}

static int by_name(const void *a, const void *b) {
    const char *x = ((const group *)a)->name, *y = ((const group *)b)->name;
    char *x_end, *y_end;
    long m = strtol(x, &x_end, 10), n = strtol(y, &y_end, 10);
    if (*x && *y && !*x_end && !*y_end && m != n)
        return m < n ? -1 : 1;
    return strcmp(x, y);
}

void tally_sort(tally *t) {
    if (t->count)
        qsort(t->groups, t->count, sizeof *t->groups, by_name);
}

void tally_clear(tally *t) {
    for (size_t k = 0; k < t->count; k++)
        free(t->groups[k].name);
    free(t->groups);
    memset(t, 0, sizeof *t);
}
