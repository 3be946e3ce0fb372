/* Tries points on a conic: a line meets it at most twice, so finitely many vertices and edges
 * cannot hold all of them.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/context/scope.h"
#include "questions/envelope/sign_events.h"

/* The point in the interior of the facet's first simplex with the barycentric weights 1, s, s^2. */
static void point_within(fmpq *out, const cell_complex *c, size_t facet, slong s) {
    int d = c->dimension;
    const size_t *corner = c->corner + c->order[c->facet[facet].first] * (size_t)d;
    slong weight = 1, sum = 0;
    LOCAL(fmpz, factor);
    LOCAL(fmpq, term);
    for (int i = 0; i < d; i++)
        fmpq_zero(out + i);
    for (int k = 0; k < d; k++, weight *= s) {
        sum += weight;
        fmpz_set_si(factor, weight);
        for (int i = 0; i < d; i++) {
            fmpq_mul_fmpz(term, c->at + corner[k] * (size_t)d + (size_t)i, factor);
            fmpq_add(out + i, out + i, term);
        }
    }
    fmpz_set_si(factor, sum);
    for (int i = 0; i < d; i++)
        fmpq_div_fmpz(out + i, out + i, factor);
}

graze_status within_facet(fmpq *out, graze_context *context, const cell_complex *cells,
                          size_t facet) {
    for (slong s = 1;; s++) {
        ZEROED(neighborhood, at);
        point_within(out, cells, facet, s);
        TRY(neighborhood_locate(&at, context, cells->solid, out));
        if (at.cell.kind == cells->facet[facet].name.kind)
            return GRAZE_OK;
    }
}
