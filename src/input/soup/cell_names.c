/* Looking up the names of cells (soup.h).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/soup/soup.h"

#include <stdlib.h>
#include "base/context/array.h"

int cell_compare(const void *left, const void *right) {
    const graze_cell *a = left, *b = right;
    if (a->kind != b->kind)
        return a->kind < b->kind ? -1 : 1;
    if (a->a != b->a)
        return a->a < b->a ? -1 : 1;
    return a->b < b->b ? -1 : a->b > b->b;
}

const graze_cell *cell_names_of(size_t *count, const cell_names *table, const graze_cell *cell) {
    size_t low = array_first(cell, table->key, table->count, sizeof *cell, cell_compare);
    *count = 0;
    while (low + *count < table->count && cell_compare(&table->key[low + *count], cell) == 0)
        ++*count;
    if (*count)
        return &table->name[low];
    *count = 1;
    return cell;
}

void cell_names_clear(cell_names *table) {
    free(table->key);
    free(table->name);
    *table = (cell_names){.count = 0};
}
