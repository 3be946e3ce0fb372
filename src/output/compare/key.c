/* Chooses the columns of keys, checks their numbers and makes digests of them.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/compare/compare.h"

#include <flint/fmpq.h>
#include <string.h>
#include "base/context/scope.h"
#include "base/number/rational.h"
#include "base/number/text.h"
#include "input/delimited/delimited.h"
#include "output/compare/counts.h"
#include "output/compare/rows.h"

/* Longer ids are texts, whatever they look like. */
enum { LONGEST_NUMBER = 40 };

void key_of_axes(row_key *out, const table *golden, const table *candidate) {
    size_t count = candidate->dimension >= golden->dimension ? (size_t)golden->dimension : 0;
    *out = (row_key){0, count, {COLUMN_X, COLUMN_Y, COLUMN_Z}};
}

/* Coordinates as far as both tables have them. */
static graze_status key_of_points(row_key *out, const table *golden, const table *candidate) {
    key_of_axes(out, golden, candidate);
    if (candidate->dimension > golden->dimension)
        return context_fail_in(golden->in.context, GRAZE_EINPUT, candidate->in.name, 0,
                               "a column z; expected x and y, as the golden table has dimension 2");
    return GRAZE_OK;
}

/* Has a table the columns of time and of a point with this first coordinate? */
static int has_contact(const table *t, column first, size_t dimension) {
    int has = t->where[COLUMN_TIME] >= 0;
    for (size_t k = 0; k < dimension; k++)
        has = has && t->where[first + k] >= 0;
    return has;
}

static graze_status key_of_contacts(row_key *out, const table *golden, const table *candidate) {
    size_t dimension = golden->where[COLUMN_BZ] >= 0 || golden->where[COLUMN_Z] >= 0 ? 3 : 2;
    const char *told = golden->notes[NOTE_DIMENSION];
    if (told && strcmp(told, "2") == 0)
        dimension = 2;
    static const column firsts[] = {COLUMN_BX, COLUMN_X};
    for (int k = 0; k < 2; k++) {
        if (!has_contact(golden, firsts[k], dimension) ||
            !has_contact(candidate, firsts[k], dimension))
            continue;
        *out = (row_key){0, dimension + 1, {COLUMN_TIME}};
        for (size_t axis = 0; axis < dimension; axis++)
            out->at[axis + 1] = (column)(firsts[k] + axis);
        return GRAZE_OK;
    }
    return context_fail_in(golden->in.context, GRAZE_EINPUT, candidate->in.name, 0,
                           "no columns %s that %s has too, and no id; expected one of them, to "
                           "match contact points by",
                           dimension == 2 ? "time, bx, by or time, x, y"
                                          : "time, bx, by, bz or time, x, y, z",
                           golden->in.name);
}

graze_status key_choose(row_key *out, const table *golden, const table *candidate, int contacts) {
    *out = (row_key){1, 1, {COLUMN_ID}};
    if (golden->where[COLUMN_ID] >= 0 && candidate->where[COLUMN_ID] >= 0)
        return GRAZE_OK;
    return (contacts ? key_of_contacts : key_of_points)(out, golden, candidate);
}

graze_status key_check(const row_key *key, const table *t, const table_row *row) {
    for (size_t k = 0; k < key->count && !key->by_id; k++) {
        field f = table_field(t, row, key->at[k]);
        int time = key->at[k] == COLUMN_TIME;
        if (time ? !moment_is_token(f) : !rational_is_token(f.start, f.length))
            return context_fail_in(t->in.context, GRAZE_EINPUT, t->in.name, row->line,
                                   "%s: '%.*s' is not a %s; expected one such as %s",
                                   column_name(key->at[k]), FIELD_SHOWN(f),
                                   time ? "time" : "number",
                                   time ? MOMENT_FORMS : "-12, 0.1, 1.5e-3, 22/7");
    }
    return GRAZE_OK;
}

/* A number in lowest terms after rounding; a root as it is written. */
static graze_status put_key_number(text *out, fmpq_t value, const table *t, const table_row *row,
                                   column which) {
    field f = table_field(t, row, which);
    if (which == COLUMN_TIME && moment_is_root(f)) {
        text_bytes(out, f.start, f.length);
        return GRAZE_OK;
    }
    TRY(table_rational(value, t, row, which));
    text_rational(out, value);
    return GRAZE_OK;
}

/* Is an id a number as tables have it that were read as doubles: 7, 7.0 or 7.000e+00? Not 7e0,
 * which may be the digits of a hash. */
static int is_id_number(field f) {
    int exponent = memchr(f.start, 'e', f.length) || memchr(f.start, 'E', f.length);
    return f.length <= LONGEST_NUMBER && rational_is_token(f.start, f.length) &&
           !memchr(f.start, '/', f.length) && (!exponent || memchr(f.start, '.', f.length));
}

/* An id as it is written, the value of a number. */
static void put_id(text *out, const table *t, const table_row *row) {
    field f = table_field(t, row, COLUMN_ID);
    LOCAL(fmpq, value);
    if (is_id_number(f) && table_number(value, t->in.context, f) == GRAZE_OK)
        text_rational(out, value);
    else
        text_bytes(out, f.start, f.length);
}

/* All numbers of the key, parted by blanks, or the id. */
static graze_status put_key(text *out, const row_key *key, const table *t, const table_row *row) {
    LOCAL(fmpq, value);
    if (key->by_id)
        put_id(out, t, row);
    for (size_t k = 0; k < key->count && !key->by_id; k++) {
        TRY(put_key_number(out, value, t, row, key->at[k]));
        text_put(out, " ");
    }
    return out->failed ? table_no_memory(t) : GRAZE_OK;
}

graze_status key_make(table_row *row, const row_key *key, const table *t) {
    if (row->keyed)
        return GRAZE_OK;
    HELD(text, bytes);
    TRY(put_key(&bytes, key, t, row));
    row->key = digest_of(bytes.data, bytes.length);
    row->keyed = 1;
    return GRAZE_OK;
}
