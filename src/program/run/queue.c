/* Hands rows out to threads or ranks.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "program/run/run.h"

#include "program/io/io.h"
#include "program/points/points.h"

void queue_add(queue *q, block *b) {
    if (q->first)
        q->last->after = b;
    else
        q->first = b;
    q->last = b;
    q->left += b->count;
}

size_t queue_take(queue *q, block **of, int workers, size_t most) {
    block *b = *of = q->first;
    size_t first = b->next, in_block = b->count - first;
    size_t share = q->left / (4 * (size_t)workers);
    share = share < 1 ? 1 : share < most ? share : most;
    share = share < in_block ? share : in_block;
    b->runs[first] = (row_run){.taken = share, .fault = {EXIT_SIGNAL, NULL}};
    b->next += share;
    b->busy++;
    q->left -= share;
    if (share == in_block)
        q->first = b->after;
    return first;
}
