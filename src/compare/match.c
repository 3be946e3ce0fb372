/* Matches rows by order, with the point or an id as check.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Where the next rows differ, the nearest pair of equal rows ahead is found, so that the fewest
 * rows are without a counterpart. If there is none, the golden table goes on alone until it comes
 * to a row of the candidate's window.
 */
#include "compare/match.h"

#include <flint/fmpq.h>
#include <stdlib.h>
#include <string.h>
#include "number/rational.h"
#include "number/text.h"

graze_status match_start(match *m, graze_context *context, table *golden, table *candidate) {
    m->context = context;
    m->golden.table = golden;
    m->candidate.table = candidate;
    m->dimension = golden->dimension;
    m->by_id = golden->where[COLUMN_ID] >= 0 && candidate->where[COLUMN_ID] >= 0;
    int point = candidate->dimension && candidate->dimension >= m->dimension;
    if (!m->by_id && !point)
        return context_fail_in(context, GRAZE_EINPUT, candidate->in.name, 0,
                               "no columns %s, and no id that the golden table has too; expected "
                               "one of them, to match rows by",
                               m->dimension == 2 ? "x, y" : "x, y, z");
    if (!m->by_id && candidate->dimension > m->dimension)
        return context_fail_in(context, GRAZE_EINPUT, candidate->in.name, 0,
                               "a column z; expected x and y, as the golden table has dimension 2");
    return GRAZE_OK;
}

void match_clear(match *m) {
    for (size_t k = 0; k < MATCH_AHEAD; k++) {
        table_row_clear(&m->golden.rows[k]);
        table_row_clear(&m->candidate.rows[k]);
    }
}

static table_row *row_at(window *w, size_t k) {
    return &w->rows[(w->first + k) % MATCH_AHEAD];
}

static void drop(window *w) {
    w->first = (w->first + 1) % MATCH_AHEAD;
    w->count--;
}

static graze_status coordinate_check(const table *t, const table_row *row, int axis) {
    field f = table_field(t, row, (column)(COLUMN_X + axis));
    if (rational_is_token(f.start, f.length))
        return GRAZE_OK;
    return context_fail_in(
        t->in.context, GRAZE_EINPUT, t->in.name, row->line,
        "%c: '%.*s' is not a number; expected one such as -12, 0.1, 1.5e-3, 22/7", 'x' + axis,
        f.length > 40 ? 40 : (int)f.length, f.start);
}

/* Read rows until the window has `count` of them or the table ends. */
static graze_status fill(match *m, window *w, size_t count) {
    graze_status status = GRAZE_OK;
    while (!status && w->count < count && !w->ended) {
        table_row *row = row_at(w, w->count);
        int more;
        status = table_next(w->table, row, &more);
        w->ended = !more;
        for (int k = 0; !status && more && !m->by_id && k < m->dimension; k++)
            status = coordinate_check(w->table, row, k);
        w->count += !status && more;
    }
    return status;
}

/* The point as text in lowest terms, coordinates parted by blanks. */
static graze_status put_match_point(text *out, graze_context *context, const table *t,
                                    const table_row *row, int dimension) {
    graze_status status = GRAZE_OK;
    fmpq_t value;
    fmpq_init(value);
    for (int k = 0; !status && k < dimension; k++) {
        field f = table_field(t, row, (column)(COLUMN_X + k));
        status = rational_parse(value, context, f.start, f.length);
        if (status) {
            context_item(context, status, NULL, 0, (const char[]){(char)('x' + k), '\0'});
            context_in(context, status, t->in.name, row->line);
        } else {
            text_rational(out, value);
        }
        text_put(out, " ");
    }
    fmpq_clear(value);
    return !status && out->failed ? context_fail(context, GRAZE_ESYSTEM, "out of memory") : status;
}

graze_status match_key(table_row *row, graze_context *context, const table *t, int by_id,
                       int dimension) {
    if (row->keyed)
        return GRAZE_OK;
    if (by_id) {
        field f = table_field(t, row, COLUMN_ID);
        row->key = digest_of(f.start, f.length);
        row->keyed = 1;
        return GRAZE_OK;
    }
    text point;
    text_init(&point);
    graze_status status = put_match_point(&point, context, t, row, dimension);
    if (!status)
        row->key = digest_of(point.data, point.length);
    row->keyed = !status;
    text_clear(&point);
    return status;
}

/* Fill both windows and make all keys. */
static graze_status look_ahead(match *m) {
    window *const both[] = {&m->golden, &m->candidate};
    graze_status status = GRAZE_OK;
    for (int k = 0; k < 2 && !status; k++) {
        status = fill(m, both[k], MATCH_AHEAD);
        for (size_t r = 0; r < both[k]->count && !status; r++)
            status =
                match_key(row_at(both[k], r), m->context, both[k]->table, m->by_id, m->dimension);
    }
    return status;
}

/* Same bytes are the same point; others are compared as numbers, after rounding. */
static graze_status same_row(int *same, match *m, table_row *g, table_row *c) {
    int first = m->by_id ? COLUMN_ID : COLUMN_X, count = m->by_id ? 1 : m->dimension;
    *same = 1;
    for (int k = first; k < first + count && *same; k++)
        *same = field_equal(table_field(m->golden.table, g, (column)k),
                            table_field(m->candidate.table, c, (column)k));
    if (*same || m->by_id)
        return GRAZE_OK;
    graze_status status = match_key(g, m->context, m->golden.table, 0, m->dimension);
    if (!status)
        status = match_key(c, m->context, m->candidate.table, 0, m->dimension);
    *same = !status && digest_equal(g->key, c->key);
    return status;
}

/* The nearest pair of equal rows: fewest rows skipped, missing ones rather than extra ones. */
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

/* No pair ahead: the golden rows of the window are missing. Past the golden table's end the
 * candidate's rows are extra. */
static void skip_window(match *m) {
    m->skip_golden = m->golden.count;
    m->skip_candidate = m->golden.ended ? m->candidate.count : 0;
}

static graze_status resynchronise(match *m) {
    graze_status status = look_ahead(m);
    if (!status && !nearest_rounding(m))
        skip_window(m);
    return status;
}

static void add_key(digest *sum, digest key) {
    sum->high += key.high;
    sum->low += key.low;
}

/* Hand out one row without a counterpart. */
static graze_status alone(match *m, window *w, const table_row **out) {
    table_row *row = row_at(w, 0);
    graze_status status = match_key(row, m->context, w->table, m->by_id, m->dimension);
    int golden = w == &m->golden;
    add_key(golden ? &m->missing : &m->extra, row->key);
    *(golden ? &m->missing_count : &m->extra_count) += 1;
    size_t *skip = golden ? &m->skip_golden : &m->skip_candidate;
    *skip -= *skip > 0;
    *out = row;
    drop(w);
    return status;
}

graze_status match_next(match *m, const table_row **golden, const table_row **candidate) {
    *golden = *candidate = NULL;
    int same = 0;
    graze_status status = GRAZE_OK;
    if (!m->skip_golden && !m->skip_candidate) {
        status = fill(m, &m->golden, 1);
        if (!status)
            status = fill(m, &m->candidate, 1);
        if (!status && m->golden.count && m->candidate.count)
            status = same_row(&same, m, row_at(&m->golden, 0), row_at(&m->candidate, 0));
        if (!status && !same && m->golden.count && m->candidate.count)
            status = resynchronise(m);
    }
    if (status)
        return status;
    if (same) {
        *golden = row_at(&m->golden, 0);
        *candidate = row_at(&m->candidate, 0);
        drop(&m->golden);
        drop(&m->candidate);
        m->pairs++;
        return GRAZE_OK;
    }
    if (m->skip_golden || (m->golden.count && !m->skip_candidate))
        return alone(m, &m->golden, golden);
    return m->candidate.count ? alone(m, &m->candidate, candidate) : GRAZE_OK;
}

graze_status match_finish(const match *m) {
    const table *golden = m->golden.table, *candidate = m->candidate.table;
    if (!m->pairs && m->missing_count && m->extra_count)
        return context_fail_in(m->context, GRAZE_EINPUT, candidate->in.name, 0,
                               "no row is one of %s; expected the same points in the same order; "
                               "where coordinates were rounded, a comparison that rounds them too "
                               "(binary64), or a column id in both tables",
                               golden->in.name);
    if (m->missing_count && m->missing_count == m->extra_count &&
        digest_equal(m->missing, m->extra))
        return context_fail_in(m->context, GRAZE_EINPUT, candidate->in.name, 0,
                               "has the rows of %s in another order; expected the same order",
                               golden->in.name);
    return GRAZE_OK;
}
