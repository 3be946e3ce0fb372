/* Planes, sides and cells of a solid's simplices.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/solid/solid.h"

#include "base/context/scope.h"

solid_kind solid_kind_of(const graze_solid *solid) {
    int space = solid->input.dimension == 3;
    if (solid->curved)
        return space ? SOLID_CURVED_SPACE : SOLID_CURVED_PLANE;
    return space ? SOLID_POLYHEDRON : SOLID_POLYGON;
}

int solid_bounded(const graze_solid *solid) {
    return !solid->curved || solid->curved->box.dimension > 0;
}

void solid_box(fmpq *low, fmpq *high, const graze_solid *solid) {
    size_t d = (size_t)solid->input.dimension;
    for (size_t i = 0; i < d && solid->curved; i++) {
        fmpq_set(low + i, &solid->curved->box.low[i]);
        fmpq_set(high + i, &solid->curved->box.high[i]);
    }
    for (size_t k = 0; k < solid->cut.count * d; k++) {
        const fmpq *vertex = solid->input.coordinates + solid->cut.item[k / d].vertex[k % d] * d;
        for (size_t i = 0; i < d; i++) {
            if (k == 0 || fmpq_cmp(vertex + i, low + i) < 0)
                fmpq_set(low + i, vertex + i);
            if (k == 0 || fmpq_cmp(vertex + i, high + i) > 0)
                fmpq_set(high + i, vertex + i);
        }
    }
}

int solid_plane(fmpz *out, const graze_solid *solid, size_t simplex) {
    skin s = solid_skin(solid);
    return skin_plane(out, &s, simplex);
}

void solid_side(fmpz *out, const graze_solid *solid, size_t simplex, const fmpz *plane, int k) {
    skin s = solid_skin(solid);
    skin_side(out, &s, simplex, plane, k);
}

int solid_holds(unsigned *zero, const graze_solid *solid, size_t simplex, const fmpz *plane,
                const fmpz *x) {
    int d = solid->input.dimension, inside = 1;
    LOCAL_VEC(fmpz, side, d + 1);
    *zero = 0;
    for (int k = 0; k < d && inside; k++) {
        solid_side(side, solid, simplex, plane, k);
        int sign = form_sign(side, x, d);
        inside = sign >= 0;
        *zero |= sign == 0 ? 1u << k : 0;
    }
    return inside;
}

/* In E^2 side k vanishes at vertex k. In E^3 side k vanishes on edge k, and two sides vanish at the
 * vertex that their edges share. */
graze_cell solid_cell(const graze_solid *solid, size_t simplex, unsigned zero) {
    const struct simplex *s = &solid->cut.item[simplex];
    if (solid->input.dimension == 2) {
        if (zero)
            return (graze_cell){GRAZE_CELL_VERTEX, s->vertex[zero == 1 ? 0 : 1], 0};
        size_t u = s->vertex[0], v = s->vertex[1];
        return (graze_cell){GRAZE_CELL_EDGE, u < v ? u : v, u < v ? v : u};
    }
    for (int k = 0; k < 3; k++) {
        unsigned here = 1u << k, before = 1u << (k + 2) % 3;
        if (zero == (here | before))
            return (graze_cell){GRAZE_CELL_VERTEX, s->vertex[k], 0};
        if (zero == here && !(s->diagonal & here)) {
            size_t u = s->vertex[k], v = s->vertex[(k + 1) % 3];
            return (graze_cell){GRAZE_CELL_EDGE, u < v ? u : v, u < v ? v : u};
        }
    }
    return (graze_cell){GRAZE_CELL_FACE, s->facet, 0};
}
