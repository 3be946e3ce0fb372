/* Keys by which the rows of two tables are matched.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The key of a row is its id, the value of one that is a number, or its point in lowest terms after
 * rounding; of a contact point its time and its point.
 */
#ifndef GRAZE_COMPARE_KEY_H
#define GRAZE_COMPARE_KEY_H

#include "output/compare/table.h"

/** Columns that make a key, `id` alone or numbers; none where the order of rows alone matches. */
typedef struct row_key {
    int by_id;
    size_t count;
    column at[4];
} row_key;

/** Choose the key of points: `id` if both tables have it, else x, y (and z), else no columns.
 * @return GRAZE_EINPUT a column z for points of the plane */
graze_status key_of_points(row_key *out, const table *golden, const table *candidate);

/** Coordinates x, y (and z) of points that both tables have; none if one of them lacks any. */
void key_of_axes(row_key *out, const table *golden, const table *candidate);

/** The key of contact points: `id`, else time and bx, by (and bz), else time and x, y (and z). */
graze_status key_of_contacts(row_key *out, const table *golden, const table *candidate);

/** Check that the columns of a row's key are numbers, a time perhaps `root(...)`. GRAZE_EINPUT. */
graze_status key_check(const row_key *key, const table *t, const table_row *row);

/** Make the digest of a row's key. GRAZE_EINPUT, GRAZE_ELIMIT. */
graze_status key_make(table_row *row, const row_key *key, const table *t);

#endif
