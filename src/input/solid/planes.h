/* The planes (E^2: lines) of simplices, each once.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_SOLID_PLANES_H
#define GRAZE_SOLID_PLANES_H

#include "input/solid/known.h"

/**
 * The planes of a list of simplices. Plane p is the form at form + p * (d + 1); the entries of the
 * list that lie in it are those numbered order[start[p]] to order[start[p + 1] - 1], ascending.
 */
typedef struct plane_list {
    size_t count; /* planes, each once, in the order of form_compare */
    size_t simplex_count;
    int dimension;
    fmpz *form;
    uint32_t *order, *start;
} plane_list;

/**
 * Find the planes of `count` simplices, each computed here.
 * @param simplex their numbers, repetitions allowed; NULL for all simplices of the solid, `count`
 * of them
 * @return 0, or -1 without memory; then there is nothing to clear
 */
int planes_find(plane_list *out, const graze_solid *solid, const uint32_t *simplex, size_t count);

/** planes_find with the forms that a memory has, or with none for NULL. */
int planes_find_known(plane_list *out, form_memory *forms, const graze_solid *solid,
                      const uint32_t *simplex, size_t count);
void planes_clear(plane_list *list);

#endif
