/* A table in which a simplex's number modulo the table's size is its place; a simplex replaces
 * another one there.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/solid/solid.h"

#include <flint/fmpz_vec.h>
#include <stdlib.h>

enum { KNOWN_SIMPLICES = 1024 };

void form_memory_clear(form_memory *m) {
    for (size_t k = 0; m->entry && k < KNOWN_SIMPLICES; k++)
        for (int i = 0; i < 16; i++)
            fmpz_clear(m->entry[k].form + i);
    free(m->entry);
    *m = (form_memory){0, NULL};
}

/* The simplex's place; NULL if allocation fails. */
static known_forms *remembered_at(form_memory *m, const graze_solid *solid, uint32_t simplex) {
    if (m->solid != solid->number)
        form_memory_clear(m);
    m->solid = solid->number;
    if (!m->entry)
        m->entry = calloc(KNOWN_SIMPLICES, sizeof *m->entry);
    if (!m->entry)
        return NULL;
    known_forms *place = &m->entry[simplex % KNOWN_SIMPLICES];
    if (place->simplex != simplex)
        place->made = 0;
    place->simplex = simplex;
    return place;
}

void known_plane(fmpz *out, form_memory *m, const graze_solid *solid, uint32_t simplex) {
    known_forms *place = m ? remembered_at(m, solid, simplex) : NULL;
    if (!place) {
        solid_plane(out, solid, simplex);
        return;
    }
    if (!(place->made & 1))
        solid_plane(place->form, solid, simplex);
    place->made |= 1;
    _fmpz_vec_set(out, place->form, solid->input.dimension + 1);
}

const fmpz *known_side(fmpz *room, form_memory *m, const graze_solid *solid, uint32_t simplex,
                       const fmpz *plane, int k) {
    known_forms *place = m ? remembered_at(m, solid, simplex) : NULL;
    fmpz *form = place ? place->form + 4 * (k + 1) : room;
    if (!place || !(place->made & 2u << k))
        solid_side(form, solid, simplex, plane, k);
    if (place)
        place->made |= 2u << k;
    return form;
}
