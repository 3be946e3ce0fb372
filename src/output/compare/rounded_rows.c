/* Finds golden rows that rounding makes equal though their answers differ.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * One pass over the table keeps the digests of those rows whose key falls to it; a table too large
 * for one pass is read several times, each for its share of the keys.
 */
#include "output/compare/compare.h"

#include <stdlib.h>
#include <string.h>
#include "base/context/context.h"
#include "base/context/scope.h"
#include "base/number/text.h"
#include "input/delimited/delimited.h"
#include "output/compare/rows.h"

enum { MOST_ENTRIES = 1 << 21 };

/* A free place has line 0. */
typedef struct entry {
    digest key;
    uint64_t answers, exact, line; /* exact: the key before rounding, of contact points */
} entry;

typedef struct share {
    entry *entries; /* an open hash table, at most half full */
    size_t count, capacity;
    unsigned long pass, passes; /* keys with high % passes = pass are kept */
} share;

static entry *rounding_place(const share *s, digest key) {
    size_t at = key.low & (s->capacity - 1);
    while (s->entries[at].line && !digest_equal(s->entries[at].key, key))
        at = (at + 1) & (s->capacity - 1);
    return &s->entries[at];
}

static int grow_roundings(share *s) {
    share larger = *s;
    larger.capacity = s->capacity ? 2 * s->capacity : 1024;
    larger.entries = calloc(larger.capacity, sizeof *larger.entries);
    if (!larger.entries)
        return 0;
    for (size_t k = 0; k < s->capacity; k++)
        if (s->entries[k].line)
            *rounding_place(&larger, s->entries[k].key) = s->entries[k];
    free(s->entries);
    *s = larger;
    return 1;
}

/* The digest of a row's answers, each ended by a byte that no field holds. */
static graze_status answers_of(uint64_t *out, const table *t, const table_row *row,
                               const column *columns, size_t count) {
    HELD(text, answers);
    for (size_t k = 0; k < count; k++) {
        field f = table_field(t, row, columns[k]);
        text_bytes(&answers, f.start, f.length);
        text_put(&answers, "\n");
    }
    if (answers.failed)
        return table_no_memory(t);
    *out = digest_of(answers.data, answers.length).high;
    return GRAZE_OK;
}

/* Contact points that were moved to one place at one time may have other answers (`cell`, `shift`),
 * rounded or not: the key before rounding tells. Of points it is 0. */
static graze_status exact_of(uint64_t *out, const table *t, table_row *row, const row_key *key) {
    graze_context *context = t->in.context;
    graze_rounding asked = context->rounding;
    *out = 0;
    if (key->at[0] != COLUMN_TIME)
        return GRAZE_OK;
    context->rounding = GRAZE_ROUND_NONE;
    graze_status status = key_make(row, key, t);
    context->rounding = asked;
    *out = row->key.high | 1;
    row->keyed = 0;
    return status;
}

static graze_status keep(share *s, const table *t, const table_row *row, uint64_t exact,
                         const column *columns, size_t count) {
    uint64_t answers = 0;
    TRY(answers_of(&answers, t, row, columns, count));
    if (row->key.high % s->passes != s->pass)
        return GRAZE_OK;
    if (2 * (s->count + 1) > s->capacity && !grow_roundings(s))
        return table_no_memory(t);
    entry *e = rounding_place(s, row->key);
    if (e->line && e->answers != answers && (!exact || e->exact != exact))
        return context_fail_in(t->in.context, GRAZE_EINPUT, t->in.name, row->line,
                               "rounding makes this row equal to that of line %lu, whose "
                               "answer is another; expected points that stay apart",
                               (unsigned long)e->line);
    s->count += !e->line;
    *e = (entry){row->key, answers, exact, row->line};
    return GRAZE_OK;
}

/* One pass; it stops early, without fault, when its share of the keys is too large. */
static graze_status pass(share *s, graze_context *context, const char *path, const row_key *key,
                         const column *columns, size_t count) {
    ZEROED(table, t);
    ZEROED(table_row, row);
    TRY(table_open(&t, context, path));
    while (s->count < MOST_ENTRIES) {
        uint64_t exact = 0;
        int more;
        TRY(table_next(&t, &row, &more));
        if (!more)
            break;
        TRY(exact_of(&exact, &t, &row, key));
        TRY(key_make(&row, key, &t));
        TRY(keep(s, &t, &row, exact, columns, count));
    }
    return GRAZE_OK;
}

graze_status match_rounding(graze_context *context, const table *golden, const char *path,
                            const row_key *key, const column *columns, size_t count) {
    if (!stream_repeatable(&golden->in))
        return context_fail_in(context, GRAZE_EINPUT, golden->in.name, 0,
                               "is read more than once, to check its points after rounding; "
                               "expected a regular file");
    share s = {NULL, 0, 0, 0, 1};
    graze_status status = GRAZE_OK;
    while (!status && s.pass < s.passes) {
        s.count = 0;
        if (s.capacity)
            memset(s.entries, 0, s.capacity * sizeof *s.entries);
        status = pass(&s, context, path, key, columns, count);
        if (s.count < MOST_ENTRIES) {
            s.pass++;
        } else {
            s.passes *= 2;
            s.pass = 0;
        }
    }
    free(s.entries);
    return status;
}
