/* A plane's form of a moved corner is a polynomial of the time; on a part it has one sign if all
 * its Bernstein coefficients have that sign. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/context/scope.h"
#include "decide/filter/search.h"

/* The plane's form of a moved corner on a whole piece, times the positive weight. */
static void form_of_corner(fmpq_poly_t form, const fmpq *plane, const point_map *map,
                           const fmpq *corner) {
    LOCAL(fmpq_poly, entry);
    LOCAL(fmpq, factor);
    fmpq_poly_set_fmpz_poly(form, map->weight);
    fmpq_poly_scalar_mul_fmpq(form, form, plane + 3);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 4; j++) {
            fmpq_poly_set_fmpz_poly(entry, map->entry + 4 * i + j);
            if (j < 3)
                fmpq_mul(factor, plane + i, corner + j);
            fmpq_poly_scalar_mul_fmpq(entry, entry, j < 3 ? factor : plane + i);
            fmpq_poly_add(form, form, entry);
        }
}

/* Has a form the sign `side`, or 0, on all of a part? Yes if all coefficients of (1 + x)^n
 * f(from + way / (1 + x)) have it, n the degree of f. Changes `form`. */
static int is_on_side(fmpq_poly_t form, const span *part, int side) {
    int on_side = 1;
    slong length = fmpq_poly_length(form);
    LOCAL(fmpq_poly, line);
    fmpq_poly_set_coeff_si(line, 0, part->start);
    if (part->degree)
        fmpq_poly_set_coeff_si(line, 1, WINDOW_WHOLE >> part->level);
    fmpq_poly_scalar_div_si(line, line, WINDOW_WHOLE);
    fmpq_poly_compose(form, form, line);
    fmpq_poly_reverse(form, form, length);
    fmpq_poly_zero(line);
    fmpq_poly_set_coeff_si(line, 0, 1);
    fmpq_poly_set_coeff_si(line, 1, 1);
    fmpq_poly_compose(form, form, line);
    for (slong k = 0; k < fmpq_poly_length(form) && on_side; k++)
        on_side = fmpz_sgn(fmpq_poly_numref(form) + k) * side >= 0;
    return on_side;
}

int walls_hold_out(const cell_walls *walls, const graze_motion *motion, const graze_solid *solid,
                   const span *part, uint32_t simplex, unsigned mask) {
    const point_map *map = motion_placing(motion->piece + part->piece, GRAZE_SWEEP);
    int out = 0;
    LOCAL(fmpq_poly, form);
    for (int k = 0; k < walls->count && !out; k++) {
        out = 1;
        for (int v = 0; v < 3 && out; v++) {
            if (!(mask >> v & 1))
                continue;
            const fmpq *corner =
                solid->input.coordinates + 3 * (size_t)solid->cut.item[simplex].vertex[v];
            form_of_corner(form, walls->plane + 4 * k, map, corner);
            out = is_on_side(form, part, walls->sides >> k & 1 ? -1 : 1);
        }
    }
    return out;
}
