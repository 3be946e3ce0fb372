/* Counts errors by the value of a column.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Groups past MOST_GROUPS are counted together, so that a column of different names costs no
 * memory.
 */
#include "output/compare/compare.h"

#include <stdlib.h>
#include <string.h>
#include "base/context/array.h"
#include "base/context/context.h"
#include "input/delimited/delimited.h"
#include "output/compare/counts.h"

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

/* Count the error of a value. 0 when out of memory. */
static int add_value(group *g, const value_error *value) {
    if (!g->values)
        g->values = calloc(1, sizeof *g->values);
    return g->values && errors_add(g->values, *value);
}

graze_status tally_add(tally *t, graze_context *context, field name, char status,
                       const value_error *value) {
    group *g = find(t, name);
    if (!g)
        g = append(t, name);
    if (!g || (value && !add_value(g, value)))
        return context_fail(context, GRAZE_ESYSTEM, "out of memory");
    g->rows++;
    g->wrong += status == 'w';
    g->undecided += status == 'u';
    g->missing += status == 'm';
    return GRAZE_OK;
}

/* The value of a name that begins with a digit, perhaps behind a minus; 0 if it is no number. */
static int name_value(double *out, const char *name) {
    char *end;
    const char *first = name + (*name == '-');
    *out = strtod(name, &end);
    return *first >= '0' && *first <= '9' && !*end;
}

/* No name, then numbers by value, then the others. */
static int by_name(const void *a, const void *b) {
    const char *x = ((const group *)a)->name, *y = ((const group *)b)->name;
    double m, n;
    int first = name_value(&m, x), second = name_value(&n, y);
    if (first != second && *x && *y)
        return second - first;
    if (first && second && m != n)
        return m < n ? -1 : 1;
    return strcmp(x, y);
}

void tally_sort(tally *t) {
    if (t->count)
        qsort(t->groups, t->count, sizeof *t->groups, by_name);
}

static void clear_values(group *g) {
    if (g->values)
        errors_clear(g->values);
    free(g->values);
}

void tally_clear(tally *t) {
    for (size_t k = 0; k < t->count; k++) {
        free(t->groups[k].name);
        clear_values(&t->groups[k]);
    }
    clear_values(&t->others);
    free(t->groups);
    memset(t, 0, sizeof *t);
}
