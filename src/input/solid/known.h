/* Forms of the simplices that were asked for last, each made once.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Degenerate points ask for the same few planes and sides again and again where a solid is small;
 * of a large one hardly any are asked for twice, and no more than some hundred are kept.
 */
#ifndef GRAZE_SOLID_KNOWN_H
#define GRAZE_SOLID_KNOWN_H

#include "input/solid/solid.h"

/** A simplex with its plane and its sides, those of the mask `made`: bit 0 the plane, 1 + k side k.
 */
typedef struct known_forms {
    uint32_t simplex;
    unsigned made;
    fmpz form[16]; /* the plane's at 0, side k's at 4 (k + 1) */
} known_forms;

/** Memory of one thread; zeroed: empty. */
typedef struct form_memory {
    unsigned long solid; /* the number of the solid that it is of */
    known_forms *entry;
} form_memory;

void form_memory_clear(form_memory *m);

/**
 * As solid_plane, without the side it faces.
 * @param m memory, or NULL for none
 */
void known_plane(fmpz *out, form_memory *m, const graze_solid *solid, uint32_t simplex);

/**
 * As solid_side.
 * @param m    memory, or NULL for none
 * @param room 4 initialised integers
 * @return the form, in `room` or in the memory until its next use
 */
const fmpz *known_side(fmpz *room, form_memory *m, const graze_solid *solid, uint32_t simplex,
                       const fmpz *plane, int k);

#endif
