/* Decides whether a slice goes on from a vertex, by the simplices of the facet that hold the
 * vertex. SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A slice goes on from a vertex into a triangle that holds the vertex if g has both signs at the
 * triangle's corners or vanishes at all of them, or along a side that the triangle shares with
 * another one of the facet. Where coplanar facets meet, the slice may go on along the flat edge
 * between them.
 */
#include "base/context/scope.h"
#include "questions/envelope/patch_ends.h"

/* A facet at point k of a piece's axis or, if `before`, between points k - 1 and k: where signs of
 * g are asked for. */
typedef struct moment {
    const graze_envelope *e;
    graze_context *context;
    size_t facet, piece;
    const axis *x;
    size_t k;
    int before;
} moment;

static graze_status sign_at(int *out, const moment *m, size_t vertex) {
    LOCAL(fmpz_poly, g);
    derivatives_velocity(g, &m->e->field[m->piece], m->facet, vertex);
    if (m->before)
        *out = axis_sign_before(m->x, g, m->k);
    else
        TRY(algebraic_sign_at(out, m->context, g, m->x->point[m->k]));
    return GRAZE_OK;
}

/* Does the slice go on from the vertex into a triangle that holds it, or along a side of the
 * triangle? If g is 0 at just two corners, the vertex lies in the side between these. */
static graze_status enters_simplex(int *out, const moment *m, size_t simplex) {
    const cell_complex *c = &m->e->cells;
    const size_t *corner = c->corner + simplex * 3;
    int positive = 0, negative = 0;
    size_t zero[3], zeros = 0;
    for (size_t k = 0; k < 3; k++) {
        int sign = 0;
        TRY(sign_at(&sign, m, corner[k]));
        positive |= sign > 0;
        negative |= sign < 0;
        if (sign == 0)
            zero[zeros++] = corner[k];
    }
    *out = (positive && negative) || zeros == 3 ||
           (zeros == 2 && parts_side_is_inner(c, m->facet, zero[0], zero[1]));
    return GRAZE_OK;
}

/* Does g vanish along an edge at the vertex, in the facet, whose local cone is a half-space? In E^2
 * every cell_edge of the facet is one. */
static graze_status goes_along_flat_edge(int *out, const moment *m, size_t vertex) {
    const cell_complex *c = &m->e->cells;
    cell_span edges = cells_of(&c->vertex_edges, vertex);
    for (size_t j = 0; j < edges.count && !*out; j++) {
        const cell_edge *edge = &c->edge[edges.item[j]];
        cell_span facets = cells_of(&c->edge_facets, edges.item[j]);
        int sign = 1;
        for (size_t i = 0; i < facets.count; i++)
            if (edge->kind == PLACE_FACET && facets.item[i] == m->facet)
                TRY(sign_at(&sign, m, edge->u == vertex ? edge->v : edge->u));
        *out = sign == 0;
    }
    return GRAZE_OK;
}

static graze_status enters(int *out, const moment *m, size_t vertex) {
    const cell_complex *c = &m->e->cells;
    const cell_facet *f = &c->facet[m->facet];
    unsigned zero = 0;
    *out = 0;
    TRY(goes_along_flat_edge(out, m, vertex));
    LOCAL_VEC(fmpz, plane, 4);
    for (size_t j = 0; j < f->count && c->dimension == 3 && !*out; j++) {
        size_t simplex = c->order[f->first + j];
        solid_plane(plane, c->solid, simplex);
        if (solid_holds(&zero, c->solid, simplex, plane, c->vertex[vertex].x))
            TRY(enters_simplex(out, m, simplex));
    }
    return GRAZE_OK;
}

graze_status enters_at(int *out, const graze_envelope *e, graze_context *context, size_t facet,
                       size_t vertex, size_t piece, const axis *x, size_t k) {
    return enters(out, &(moment){e, context, facet, piece, x, k, 0}, vertex);
}

int enters_before(const graze_envelope *e, size_t facet, size_t vertex, size_t piece, const axis *x,
                  size_t k) {
    int out;
    return enters(&out, &(moment){e, NULL, facet, piece, x, k, 1}, vertex) == GRAZE_OK && out;
}
