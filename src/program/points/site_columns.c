/* Finds time, point and cell among the names of a file of contact points, and reads cells
 * (src/program/cli/formats.md, Contact points). SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "program/points/heads.h"

#include <stdlib.h>
#include <string.h>
#include "output/report/columns.h"

static const char *const body_names[] = {"time", "bx", "by", "bz"};
static const char *const world_names[] = {"time", "x", "y", "z"};
const char *site_number_name(const site_form *s, int index) {
    return (s->in_world ? world_names : body_names)[index];
}

int site_time_is_root(field token) {
    field value;
    return field_behind(&value, token, "root(");
}

/* Does the table of contact points have a column of this name? It has `shift` only if points are
 * moved. */
static int is_result(field name, int snap) {
    field names = {contact_columns, strlen(contact_columns)};
    return field_is_among(name, names) && (snap || !field_is(name, "shift"));
}

/* Find the column of a name. Returns 1, 0 if there is none, -1 if there are two. */
static int find_name(size_t *column, const fields *names, const char *name) {
    size_t found = 0;
    for (size_t k = 0; k < names->count; k++)
        if (field_is(field_content(names->item[k]), name)) {
            *column = k;
            found++;
        }
    return found == 1 ? 1 : found ? -1 : 0;
}

/* Find the columns of time and point; returns as find_name. */
static int find_numbers(size_t where[4], const site_form *s, const fields *names) {
    int found = 1;
    for (int k = 0; k <= s->dimension && found == 1; k++)
        found = find_name(&where[k], names, site_number_name(s, k));
    return found;
}

int names_fault(fault *f, const columns *c, unsigned long number, const char *what) {
    int plane = c->dimension == 2;
    return fault_set(f, EXIT_INPUT, "%s:%lu: %s; expected a line of names with %s%s", c->name,
                     number, what,
                     c->pairs.wanted ? "moving,motion,fixed"
                     : plane         ? "time,bx,by or time,x,y"
                                     : "time,bx,by,bz or time,x,y,z",
                     c->sites.snap ? ", and cell" : "");
}

int site_columns_fix(fault *f, columns *c, const fields *names, unsigned long number) {
    site_form *s = &c->sites;
    s->in_world = 0;
    int found = find_numbers(c->where, s, names);
    if (found == 0) {
        s->in_world = 1;
        found = find_numbers(c->where, s, names);
    }
    if (found == 1 && s->snap)
        found = find_name(&s->cell, names, "cell");
    if (found < 1)
        return names_fault(f, c, number, found ? "a name stands twice" : "a name is missing");
    s->carried = calloc(names->count + 1, 1);
    for (size_t k = 0; s->carried && k < names->count; k++)
        s->carried[k] = !is_result(field_content(names->item[k]), s->snap);
    return s->carried ? EXIT_DONE : fault_set(f, EXIT_IO, "out of memory");
}

int pair_columns_fix(fault *f, columns *c, const fields *names, unsigned long number) {
    static const char *const taken[PAIR_COLUMNS] = {"moving",          "motion",      "fixed",
                                                    "motion_of_fixed", "id",          "clearance",
                                                    "inside",          "motion_error"};
    static const char *const refused[] = {"ask", "closest"};
    size_t column;
    for (size_t k = 0; k < sizeof refused / sizeof *refused; k++)
        if (find_name(&column, names, refused[k]))
            return fault_set(f, EXIT_USAGE,
                             "%s:%lu: the column %s is an option that rows of a list do not have",
                             c->name, number, refused[k]);
    for (int k = 0; k < PAIR_COLUMNS; k++) {
        c->pairs.where[k] = SIZE_MAX;
        int found = find_name(&c->pairs.where[k], names, taken[k]);
        if (found < (k <= PAIR_FIXED))
            return names_fault(f, c, number, found ? "a name stands twice" : "a name is missing");
    }
    return EXIT_DONE;
}

/* The most cells of one kind that a solid can have (src/input/solid). */
#define CELLS_MOST 0xffffffffUL

int cell_read(graze_cell *out, field text) {
    field value;
    unsigned long a, b = 0;
    if (field_behind(&value, text, "face "))
        out->kind = GRAZE_CELL_FACE;
    else if (field_behind(&value, text, "edge "))
        out->kind = GRAZE_CELL_EDGE;
    else if (field_behind(&value, text, "vertex "))
        out->kind = GRAZE_CELL_VERTEX;
    else
        return 0;
    const char *minus = out->kind == GRAZE_CELL_EDGE && value.length
                            ? memchr(value.start, '-', value.length)
                            : NULL;
    field first = {value.start, minus ? (size_t)(minus - value.start) : value.length};
    if (!field_count(&a, first, CELLS_MOST) || (out->kind == GRAZE_CELL_EDGE && !minus))
        return 0;
    if (minus &&
        (!field_count(&b, (field){minus + 1, value.length - first.length - 1}, CELLS_MOST) ||
         a >= b))
        return 0;
    out->a = a;
    out->b = b;
    return 1;
}
