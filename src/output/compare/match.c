/* Matches rows in order, by an index of their keys, or by order alone.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Where the next rows of two streams differ, the nearest pair of rows ahead with equal keys is
 * sought, so that the fewest rows lack a counterpart. If the windows have no such pair, golden rows
 * count as missing until one matches a row of the candidate's window.
 */
#include "output/compare/counts.h"

#include "base/context/scope.h"

void match_start(match *m, graze_context *context, table *golden, table *candidate,
                 const row_key *key, match_way way, int sites) {
    m->context = context;
    m->golden.table = golden;
    m->candidate.table = candidate;
    m->key = *key;
    m->way = way;
    m->sites = sites;
    drift_init(&m->drift, golden, candidate);
}

void match_clear(match *m) {
    for (size_t k = 0; k < MATCH_AHEAD; k++) {
        table_row_clear(&m->golden.rows[k]);
        table_row_clear(&m->candidate.rows[k]);
    }
    row_index_clear(&m->index);
    drift_clear(&m->drift);
}

static table_row *row_at(row_window *w, size_t k) {
    return &w->rows[(w->first + k) % MATCH_AHEAD];
}

static void drop(row_window *w) {
    w->first = (w->first + 1) % MATCH_AHEAD;
    w->count--;
}

/* Read rows until the window has `count` of them or the table ends. */
static graze_status fill(match *m, row_window *w, size_t count) {
    while (w->count < count && !w->ended) {
        table_row *row = row_at(w, w->count);
        int more;
        TRY(table_next(w->table, row, &more));
        w->ended = !more;
        if (more)
            TRY(key_check(&m->key, w->table, row));
        w->count += (size_t)more;
    }
    return GRAZE_OK;
}

/* Fill both windows and make all keys. */
static graze_status look_ahead(match *m) {
    row_window *const both[] = {&m->golden, &m->candidate};
    for (int k = 0; k < 2; k++) {
        TRY(fill(m, both[k], MATCH_AHEAD));
        for (size_t r = 0; r < both[k]->count; r++)
            TRY(key_make(row_at(both[k], r), &m->key, both[k]->table));
    }
    return GRAZE_OK;
}

/* Do two rows have the same key? Fields of equal bytes do; other fields are compared by value,
 * after rounding. */
static graze_status same_row(int *same, match *m, table_row *g, table_row *c) {
    *same = 1;
    for (size_t k = 0; k < m->key.count && *same; k++)
        *same = field_equal(table_field(m->golden.table, g, m->key.at[k]),
                            table_field(m->candidate.table, c, m->key.at[k]));
    if (*same)
        return GRAZE_OK;
    TRY(key_make(g, &m->key, m->golden.table));
    TRY(key_make(c, &m->key, m->candidate.table));
    *same = digest_equal(g->key, c->key);
    return GRAZE_OK;
}

/* Find the pair of equal rows before which the fewest rows are skipped, of several such pairs the
 * one that skips most golden rows; 0 if there is no pair. */
static int nearest_rounding(match *m) {
    size_t golden = m->golden.count, candidate = m->candidate.count;
    for (size_t sum = 1; sum + 1 < golden + candidate; sum++)
        for (size_t extra = sum < golden ? 0 : sum - golden + 1; extra <= sum && extra < candidate;
             extra++)
            if (digest_equal(row_at(&m->golden, sum - extra)->key,
                             row_at(&m->candidate, extra)->key)) {
                m->skip_golden = sum - extra;
                m->skip_candidate = extra;
                return 1;
            }
    return 0;
}

/* Set how many rows to skip to the next pair. Without a pair ahead all golden rows of the window
 * are missing and, past the golden table's end, all rows of the candidate's window extra. */
static graze_status resynchronise(match *m) {
    TRY(look_ahead(m));
    if (!nearest_rounding(m)) {
        m->skip_golden = m->golden.count;
        m->skip_candidate = m->golden.ended ? m->candidate.count : 0;
    }
    return GRAZE_OK;
}

/* Hand out one row without a counterpart. */
static graze_status alone(match *m, row_window *w, const table_row **out) {
    table_row *row = row_at(w, 0);
    graze_status status = key_make(row, &m->key, w->table);
    int golden = w == &m->golden;
    digest *sum = golden ? &m->missing : &m->extra;
    sum->high += row->key.high;
    sum->low += row->key.low;
    *(golden ? &m->missing_count : &m->extra_count) += 1;
    size_t *skip = golden ? &m->skip_golden : &m->skip_candidate;
    *skip -= *skip > 0;
    *out = row;
    drop(w);
    return status;
}

/* Count a pair of rows, and the difference of their points if id or order has matched the rows. */
static graze_status pair(match *m, const table_row *golden, const table_row *candidate) {
    m->pairs++;
    int unseen = m->way == MATCH_ORDER || (m->key.by_id && !m->sites);
    return unseen ? drift_add(&m->drift, golden, candidate) : GRAZE_OK;
}

/* Hand out the next golden row with a row of the candidate that has its key; after the last golden
 * row, the candidate's other rows. */
static graze_status next_indexed(match *m, const table_row **golden, const table_row **candidate) {
    TRY(fill(m, &m->golden, 1));
    if (!m->indexed)
        TRY(row_index_read(&m->index, m->candidate.table, &m->key));
    m->indexed = 1;
    if (!m->golden.count) {
        graze_status status = row_index_rest(&m->index, candidate);
        m->extra_count += *candidate != NULL;
        return status;
    }
    table_row *row = row_at(&m->golden, 0);
    TRY(key_make(row, &m->key, m->golden.table));
    TRY(row_index_take(&m->index, candidate, row->key));
    *golden = row;
    drop(&m->golden);
    m->missing_count += !*candidate;
    return *candidate ? pair(m, row, *candidate) : GRAZE_OK;
}

graze_status match_next(match *m, const table_row **golden, const table_row **candidate) {
    *golden = *candidate = NULL;
    if (m->way == MATCH_INDEXED)
        return next_indexed(m, golden, candidate);
    int same = 0;
    if (!m->skip_golden && !m->skip_candidate) {
        TRY(fill(m, &m->golden, 1));
        TRY(fill(m, &m->candidate, 1));
        int both = m->golden.count && m->candidate.count;
        same = both && m->way == MATCH_ORDER;
        if (both && !same)
            TRY(same_row(&same, m, row_at(&m->golden, 0), row_at(&m->candidate, 0)));
        if (both && !same)
            TRY(resynchronise(m));
    }
    if (same) {
        *golden = row_at(&m->golden, 0);
        *candidate = row_at(&m->candidate, 0);
        drop(&m->golden);
        drop(&m->candidate);
        return pair(m, *golden, *candidate);
    }
    if (m->skip_golden || (m->golden.count && !m->skip_candidate))
        return alone(m, &m->golden, golden);
    return m->candidate.count ? alone(m, &m->candidate, candidate) : GRAZE_OK;
}

static int another_order(const match *m) {
    return m->missing_count && m->missing_count == m->extra_count &&
           digest_equal(m->missing, m->extra);
}

match_way match_better(const match *m) {
    const table *golden = m->golden.table, *candidate = m->candidate.table;
    int repeatable = stream_repeatable(&golden->in) && stream_repeatable(&candidate->in);
    int left = m->way == MATCH_ORDER ? m->key.count && !drift_is_small(&m->drift)
                                     : m->missing_count && m->extra_count;
    if (!left || !repeatable || m->way == MATCH_INDEXED)
        return m->way;
    int by_order = m->way == MATCH_STREAMED && !m->key.by_id && golden->rows == candidate->rows;
    return by_order && !another_order(m) ? MATCH_ORDER : MATCH_INDEXED;
}

/* Fail because there are no columns to match by, and the numbers of rows differ. A golden table has
 * coordinates, so the candidate lacks coordinates, and one of the two tables lacks an id. */
static graze_status unmatched(const match *m) {
    const table *golden = m->golden.table, *candidate = m->candidate.table;
    const char *axes = golden->dimension == 2 ? "x, y" : "x, y, z";
    if (candidate->where[COLUMN_ID] >= 0)
        return table_fail(
            golden, 0,
            "%lu rows, and no column id by which they are matched with the %lu of %s, which has no "
            "columns %s; expected an id, such columns there, or as many rows",
            golden->rows, candidate->rows, candidate->in.name, axes);
    return table_fail(candidate, 0,
                      "%lu rows, and no columns %s or id by which they are matched with the %lu of "
                      "%s; expected as many, or such columns",
                      candidate->rows, axes, golden->rows, golden->in.name);
}

graze_status match_finish(const match *m) {
    const table *golden = m->golden.table, *candidate = m->candidate.table;
    if (!m->key.count && golden->rows != candidate->rows)
        return unmatched(m);
    if (!m->pairs && m->missing_count && m->extra_count)
        return table_fail(
            candidate, 0,
            "no row is one of %s; expected the same %s; where coordinates were rounded, a "
            "comparison that rounds them too (binary64), or a column id in both tables",
            golden->in.name,
            m->key.by_id                  ? "ids"
            : m->key.at[0] == COLUMN_TIME ? "times and points"
                                          : "points");
    if (m->key.by_id && !drift_is_small(&m->drift))
        return table_fail(
            candidate, 0,
            "has other points under the ids of %s; expected the id that stands beside each point",
            golden->in.name);
    if (m->way == MATCH_STREAMED && another_order(m))
        return table_fail(candidate, 0,
                          "has the rows of %s in another order; expected the same order, or files "
                          "instead of pipes",
                          golden->in.name);
    return GRAZE_OK;
}
