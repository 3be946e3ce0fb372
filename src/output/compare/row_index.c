/* Sorts the rows of a table by key. SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/compare/compare.h"

#include <stdlib.h>
#include <string.h>
#include "base/context/array.h"
#include "base/context/context.h"
#include "base/context/scope.h"
#include "input/delimited/delimited.h"
#include "output/compare/rows.h"

static int digest_order(digest a, digest b) {
    return a.high != b.high ? (a.high < b.high ? -1 : 1) : (a.low > b.low) - (a.low < b.low);
}

static int by_number(const void *a, const void *b) {
    unsigned long m = ((const kept_row *)a)->number, n = ((const kept_row *)b)->number;
    return (m > n) - (m < n);
}

static int by_key(const void *a, const void *b) {
    int order = digest_order(((const kept_row *)a)->key, ((const kept_row *)b)->key);
    return order ? order : by_number(a, b);
}

static graze_status keep_indexed(row_index *x, const table_row *row) {
    TRY(array_grow(x->table->in.context, &x->rows, &x->capacity, x->count + 1, sizeof *x->rows,
                   "rows"));
    char *text = table_row_text(row);
    if (!text)
        return context_fail(x->table->in.context, GRAZE_ESYSTEM, "out of memory for rows");
    x->rows[x->count++] = (kept_row){row->key, row->line, row->number, text, 0};
    return GRAZE_OK;
}

graze_status row_index_read(row_index *out, table *t, const row_key *key) {
    int more;
    out->table = t;
    for (;;) {
        TRY(out->count % 1024 ? GRAZE_OK : context_poll(t->in.context));
        TRY(table_next(t, &out->at, &more));
        if (!more)
            break;
        TRY(key_check(key, t, &out->at));
        TRY(key_make(&out->at, key, t));
        TRY(keep_indexed(out, &out->at));
    }
    if (out->count)
        qsort(out->rows, out->count, sizeof *out->rows, by_key);
    return GRAZE_OK;
}

/* Copy a kept row into `at`, and hand it out. */
static graze_status give(row_index *x, const table_row **out, const kept_row *kept) {
    table_row *row = &x->at;
    size_t length = strlen(kept->text);
    graze_context *context = x->table->in.context;
    TRY(array_grow(context, &row->bytes, &row->capacity, length + 1, 1, "a row"));
    memcpy(row->bytes, kept->text, length + 1);
    row->line = kept->line;
    row->number = kept->number;
    row->key = kept->key;
    row->keyed = 1;
    *out = row;
    return fields_read(&row->cut, context, x->table->in.name, row->line,
                       (field){row->bytes, length}, ',');
}

graze_status row_index_take(row_index *x, const table_row **out, digest key) {
    size_t low = 0, high = x->count;
    *out = NULL;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (digest_order(x->rows[middle].key, key) < 0)
            low = middle + 1;
        else
            high = middle;
    }
    if (low == x->count)
        return GRAZE_OK;
    kept_row *first = &x->rows[low];
    size_t at = low + first->taken;
    if (at >= x->count || !digest_equal(x->rows[at].key, key))
        return GRAZE_OK;
    first->taken++;
    return give(x, out, &x->rows[at]);
}

/* Keep only the rows that nobody took, in the order of the table. */
static void drop_taken(row_index *x) {
    size_t left = 0;
    for (size_t first = 0, end; first < x->count; first = end) {
        size_t taken = x->rows[first].taken;
        digest key = x->rows[first].key;
        for (end = first; end < x->count && digest_equal(x->rows[end].key, key); end++)
            if (end - first < taken)
                free(x->rows[end].text);
            else
                x->rows[left++] = x->rows[end];
    }
    x->count = left;
    if (left)
        qsort(x->rows, left, sizeof *x->rows, by_number);
}

graze_status row_index_rest(row_index *x, const table_row **out) {
    *out = NULL;
    if (!x->resting)
        drop_taken(x);
    x->resting = 1;
    return x->next < x->count ? give(x, out, &x->rows[x->next++]) : GRAZE_OK;
}

void row_index_clear(row_index *x) {
    for (size_t k = 0; k < x->count; k++)
        free(x->rows[k].text);
    free(x->rows);
    table_row_clear(&x->at);
}
