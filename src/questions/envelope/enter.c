/* The simplices of a facet about a vertex. SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A slice goes on from a vertex into a triangle that holds the vertex if g has both signs at its
 * corners or vanishes at all of them, or along a side of it that two triangles of the facet share.
 * Where coplanar facets meet, it may go on along the flat edge between them.
 */
#include "questions/envelope/envelope.h"

#include <flint/fmpz_vec.h>
#include "base/context/scope.h"
#include "base/number/sign.h"
#include "input/solid/solid.h"
#include "input/validate/validate.h"
#include "questions/contact/contact.h"
#include "questions/envelope/sign_events.h"

/* The sign of g of a facet at a vertex, at point k of an axis or before it. */
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

/* Does a triangle hold the vertex? */
static int holds(const cell_complex *c, size_t simplex, size_t vertex) {
    const fmpz *x = c->vertex[vertex].x;
    int inside = 1;
    for (size_t k = 0; k < 3; k++)
        if (c->corner[simplex * 3 + k] == vertex)
            return 1;
    LOCAL_VEC(fmpz, plane, 8);
    fmpz *side = plane + 4;
    solid_plane(plane, c->solid, simplex);
    for (int k = 0; k < 3 && inside; k++) {
        solid_side(side, c->solid, simplex, plane, k);
        inside = form_sign(side, x, 3) >= 0;
    }
    return inside;
}

/* Do two triangles of the facet have both corners? */
static int is_inside_facet(const cell_complex *c, const cell_facet *f, size_t a, size_t b) {
    int found = 0;
    for (size_t j = 0; j < f->count; j++) {
        const size_t *corner = c->corner + c->order[f->first + j] * 3;
        int has_a = corner[0] == a || corner[1] == a || corner[2] == a;
        int has_b = corner[0] == b || corner[1] == b || corner[2] == b;
        found += has_a && has_b;
    }
    return found == 2;
}

/* Does the slice go on into a triangle that holds the vertex, or along a side of it? g = 0 at just
 * two corners: the vertex is in the side between them. */
static graze_status enters_simplex(int *out, const moment *m, size_t simplex) {
    const cell_complex *c = &m->e->cells;
    const size_t *corner = c->corner + simplex * 3;
    int positive = 0, negative = 0;
    size_t zero[3], zeros = 0;
    graze_status status = GRAZE_OK;
    for (size_t k = 0; k < 3 && !status; k++) {
        int sign = 0;
        status = sign_at(&sign, m, corner[k]);
        positive |= sign > 0;
        negative |= sign < 0;
        if (sign == 0)
            zero[zeros++] = corner[k];
    }
    *out = !status && ((positive && negative) || zeros == 3 ||
                       (zeros == 2 && is_inside_facet(c, &c->facet[m->facet], zero[0], zero[1])));
    return status;
}

/* Does g vanish along a flat edge at the vertex, beside which the facet goes on? In E^2 such an
 * edge is the facet's own. */
static graze_status goes_along_flat_edge(int *out, const moment *m, size_t vertex) {
    const cell_complex *c = &m->e->cells;
    graze_status status = GRAZE_OK;
    for (size_t j = c->vertex_edges.start[vertex];
         j < c->vertex_edges.start[vertex + 1] && !status && !*out; j++) {
        const cell_edge *edge = &c->edge[c->vertex_edges.item[j]];
        const size_t *facet = c->edge_facets.item + c->edge_facets.start[c->vertex_edges.item[j]];
        size_t count = c->edge_facets.start[c->vertex_edges.item[j] + 1] -
                       c->edge_facets.start[c->vertex_edges.item[j]];
        int sign = 1;
        for (size_t i = 0; i < count && edge->kind == PLACE_FACET; i++)
            if (facet[i] == m->facet)
                status = sign_at(&sign, m, edge->u == vertex ? edge->v : edge->u);
        *out = !status && sign == 0;
    }
    return status;
}

static graze_status enters(int *out, const moment *m, size_t vertex) {
    const cell_complex *c = &m->e->cells;
    const cell_facet *f = &c->facet[m->facet];
    *out = 0;
    TRY(goes_along_flat_edge(out, m, vertex));
    for (size_t j = 0; j < f->count && c->dimension == 3 && !*out; j++)
        if (holds(c, c->order[f->first + j], vertex))
            TRY(enters_simplex(out, m, c->order[f->first + j]));
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
