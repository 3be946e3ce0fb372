/* Blocks with rows that are not yet taken, in order.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_RUN_QUEUE_H
#define GRAZE_RUN_QUEUE_H

#include "program/run/block.h"

/** Zeroed: empty. Blocks are borrowed and linked by `after`. */
typedef struct queue {
    block *first, *last;
    size_t left; /* rows not yet taken */
} queue;

/** Add a block whose rows are taken after those of the blocks before it. */
void queue_add(queue *q, block *b);

/**
 * Take the next rows, of one block: up to `most`, and fewer towards the end, so that all
 * `workers` finish at about the same time. The queue is not empty.
 * @param[out] of the block; its run at the row returned has `taken` set and the fault EXIT_SIGNAL
 * @return the first of the rows
 */
size_t queue_take(queue *q, block **of, int workers, size_t most);

#endif
