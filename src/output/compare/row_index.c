/* Rows found by their keys: an index of all rows of a table, and golden rows that rounding makes
 * equal though their answers differ.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * For the latter a pass over the table keeps the digests of the rows in one share of the keys. A
 * table too large for one pass is read several times, once for each share.
 */
#include "output/compare/counts.h"

#include "base/context/array.h"
#include "base/context/scope.h"

/* The number of the entry of a key, among entries of `size` bytes that begin with their keys;
 * SLOTS_NONE if there is none. */
static size_t find_key(const slots *s, const void *entries, size_t size, digest key) {
    size_t at = 0, n;
    while ((n = slots_next(s, key.low, &at)) != SLOTS_NONE)
        if (digest_equal(*(const digest *)(const void *)((const char *)entries + n * size), key))
            break;
    return n;
}

/* Keep a row behind those of its key. */
static graze_status keep_indexed(row_index *x, const table_row *row) {
    graze_context *context = x->table->in.context;
    size_t k = find_key(&x->slots, x->keys, sizeof *x->keys, row->key);
    TRY(ARRAY_GROW(context, x->rows, x->capacity, x->count + 1, "rows"));
    if (k != SLOTS_NONE) {
        x->rows[x->keys[k].last].next = x->count;
        x->keys[k].last = x->count;
    } else {
        k = x->slots.count;
        TRY(ARRAY_GROW(context, x->keys, x->key_capacity, k + 1, "rows"));
        x->keys[k] = (key_rows){row->key, x->count, x->count};
        if (!slots_add(&x->slots, row->key.low))
            return comparison_no_memory(context);
    }
    char *text = table_row_text(row);
    if (!text)
        return comparison_no_memory(context);
    x->rows[x->count++] = (kept_row){row->line, text, SLOTS_NONE};
    return GRAZE_OK;
}

graze_status row_index_read(row_index *out, table *t, const row_key *key) {
    int more;
    out->table = t;
    for (;;) {
        TRY(out->count % 1024 ? GRAZE_OK : context_poll(t->in.context));
        TRY(table_next(t, &out->at, &more));
        if (!more)
            return GRAZE_OK;
        TRY(key_check(key, t, &out->at));
        TRY(key_make(&out->at, key, t));
        TRY(keep_indexed(out, &out->at));
    }
}

/* Move a kept row into `at`, and hand it out. */
static graze_status give(row_index *x, const table_row **out, kept_row *kept) {
    table_row *row = &x->at;
    size_t length = strlen(kept->text);
    free(row->bytes);
    row->bytes = kept->text;
    row->capacity = length + 1;
    kept->text = NULL;
    row->line = kept->line;
    *out = row;
    return fields_read(&row->cut, x->table->in.context, x->table->in.name, row->line,
                       (field){row->bytes, length}, ',');
}

graze_status row_index_take(row_index *x, const table_row **out, digest key) {
    size_t k = find_key(&x->slots, x->keys, sizeof *x->keys, key);
    size_t first = k == SLOTS_NONE ? SLOTS_NONE : x->keys[k].first;
    *out = NULL;
    if (first == SLOTS_NONE)
        return GRAZE_OK;
    x->keys[k].first = x->rows[first].next;
    return give(x, out, &x->rows[first]);
}

graze_status row_index_rest(row_index *x, const table_row **out) {
    *out = NULL;
    while (x->next < x->count && !x->rows[x->next].text)
        x->next++;
    return x->next < x->count ? give(x, out, &x->rows[x->next]) : GRAZE_OK;
}

void row_index_clear(row_index *x) {
    for (size_t k = 0; k < x->count; k++)
        free(x->rows[k].text);
    free(x->rows);
    free(x->keys);
    slots_clear(&x->slots);
    table_row_clear(&x->at);
}

enum { MOST_ENTRIES = 1 << 21 };

typedef struct entry {
    digest key;
    uint64_t answers, exact, line; /* exact: digest of a contact point's key before rounding */
} entry;

typedef struct share {
    slots slots; /* of the entries' keys */
    entry *entries;
    size_t capacity;
    unsigned long pass, passes; /* keys with high % passes = pass are kept */
} share;

/* The entry of a key; a new entry has line 0. NULL when out of memory. */
static entry *rounding_place(share *s, digest key) {
    size_t n = find_key(&s->slots, s->entries, sizeof *s->entries, key);
    if (n != SLOTS_NONE)
        return &s->entries[n];
    n = s->slots.count;
    if (!array_reserve(&s->entries, &s->capacity, n + 1, sizeof *s->entries) ||
        !slots_add(&s->slots, key.low))
        return NULL;
    s->entries[n] = (entry){.line = 0};
    return &s->entries[n];
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
        return comparison_no_memory(t->in.context);
    *out = digest_of(answers.data, answers.length).high;
    return GRAZE_OK;
}

/* The digest of a contact point's key before rounding; 0 for other points. Contact points that were
 * moved to one place at one time may differ in answers (`cell`, `shift`) without any rounding. */
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
    entry *e = rounding_place(s, row->key);
    if (!e)
        return comparison_no_memory(t->in.context);
    if (e->line && e->answers != answers && (!exact || e->exact != exact))
        return table_fail(t, row->line,
                          "rounding makes this row equal to that of line %lu, whose answer is "
                          "another; expected points that stay apart",
                          (unsigned long)e->line);
    *e = (entry){row->key, answers, exact, row->line};
    return GRAZE_OK;
}

/* Make one pass. It stops early, with GRAZE_OK, if its share of the keys is too large. */
static graze_status pass(share *s, graze_context *context, const char *path, const row_key *key,
                         const column *columns, size_t count) {
    ZEROED(table, t);
    ZEROED(table_row, row);
    TRY(table_open(&t, context, path));
    while (s->slots.count < MOST_ENTRIES) {
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
        return table_fail(
            golden, 0,
            "is read more than once, to check its points after rounding; expected a regular file");
    share s = {.passes = 1};
    graze_status status = GRAZE_OK;
    while (!status && s.pass < s.passes) {
        status = pass(&s, context, path, key, columns, count);
        int whole = s.slots.count < MOST_ENTRIES;
        s.pass = whole ? s.pass + 1 : 0;
        s.passes *= whole ? 1 : 2;
        slots_clear(&s.slots);
    }
    free(s.entries);
    return status;
}
