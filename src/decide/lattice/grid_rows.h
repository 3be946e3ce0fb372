/* Rows of grid points as text; most texts of coordinates are made once.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_LATTICE_GRID_ROWS_H
#define GRAZE_LATTICE_GRID_ROWS_H

#include <pthread.h>
#include "base/number/text.h"
#include "decide/lattice/lattice.h"

/** The texts of the first axis's coordinates, unless they are too many; shared by threads. */
typedef struct axis_texts {
    pthread_mutex_t lock;
    int made;
    text all;
    size_t *end; /* the end of each text; NULL: texts are made when needed */
} axis_texts;

void axis_texts_init(axis_texts *a);
void axis_texts_clear(axis_texts *a);

/**
 * Add rows of points first, first + step, ...: coordinates and membership between commas.
 * @param pmc a graze_pmc for each
 */
void rows_put(text *out, axis_texts *a, const lattice *l, const unsigned char *pmc, size_t first,
              size_t step, size_t count);

#endif
