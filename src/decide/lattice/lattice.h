/* The points of a grid: along each axis equal steps from one rational to another.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_LATTICE_LATTICE_H
#define GRAZE_LATTICE_LATTICE_H

#include <flint/fmpq.h>
#include <stddef.h>

/** Coordinate i of axis k is (start + i step) / unit. Immutable once made. */
typedef struct lattice {
    int dimension;
    size_t size[3], count; /* 1 past the dimension */
    fmpz start[3], step[3], unit[3];
} lattice;

/** @param size at least 2, with a product that a size_t holds
 * @param low, high of each axis, low < high */
void lattice_make(lattice *out, int dimension, const size_t *size, const fmpq *low,
                  const fmpq *high);
void lattice_clear(lattice *l);

/** Coordinate i of axis k. */
void lattice_coordinate(fmpq_t out, const lattice *l, int k, size_t i);

/** Set the place of point `index` along each axis; the first axis runs fastest. */
void lattice_place(size_t place[3], const lattice *l, size_t index);

#endif
