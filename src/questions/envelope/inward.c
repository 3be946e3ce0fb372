/* Replaces the velocity by a rational direction that has its signs against the facets' planes.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The state of a direction depends only on its signs against the planes of the facets
 * (proofs/claims.md C1). A rational velocity near the true one is projected into the planes that
 * hold the true one; if it is near enough, its other signs are right.
 */
#include "base/context/scope.h"
#include "base/number/vector.h"
#include "questions/envelope/sign_events.h"
#include "questions/topo/topo.h"

/* The direction of the vertex's velocity at a rational parameter, projected into the planes of the
 * facets whose sign is 0. */
static void velocity_near(fmpq *w, const graze_envelope *e, size_t vertex, size_t piece,
                          const fmpq_t u, const signed char *sign) {
    const cell_complex *c = &e->cells;
    int d = c->dimension;
    const fmpz_poly_struct *p = derivatives_at(&e->field[piece], 1, vertex);
    cell_span facets = cells_of(&c->vertex_facets, vertex);
    LOCAL_VEC(fmpq, form, d * (d + 1));
    plane_stack to = {d, 0, form};
    for (int i = 0; i < d; i++)
        fmpz_poly_evaluate_fmpq(w + i, p + i, u);
    for (size_t j = 0; j < facets.count; j++)
        if (sign[j] == 0)
            plane_stack_add(&to, w, c->facet[facets.item[j]].form);
}

/* Has -n w the given sign for the normal n of each of the vertex's facets? */
static int has_speed_signs(const fmpq *w, const graze_envelope *e, size_t vertex,
                           const signed char *sign) {
    const cell_complex *c = &e->cells;
    cell_span facets = cells_of(&c->vertex_facets, vertex);
    int same = 1;
    LOCAL(fmpq, value);
    for (size_t j = 0; j < facets.count && same; j++) {
        vector_dot_integers(value, c->facet[facets.item[j]].normal, w, c->dimension);
        same = -fmpq_sgn(value) == sign[j];
    }
    return same;
}

static graze_status find_direction(fmpz *out, const graze_envelope *e, graze_context *context,
                                   size_t vertex, size_t piece, algebraic *u,
                                   const signed char *sign) {
    int d = e->cells.dimension;
    ulong gain = FIRST_GAIN;
    LOCAL_VEC(fmpq, w, d + 1); /* a direction: the last entry is 0 */
    LOCAL_VEC(fmpq, low, 2);
    fmpq *high = low + 1;
    for (;;) {
        algebraic_bounds(low, high, u);
        velocity_near(w, e, vertex, piece, low, sign);
        if (has_speed_signs(w, e, vertex, sign))
            break;
        TRY(algebraic_narrow(context, u, CHEAP_HALVINGS, &gain));
    }
    direction_of_rationals(out, w, d);
    return GRAZE_OK;
}

graze_status inward_decide(int *out, const graze_envelope *e, graze_context *context, size_t vertex,
                           size_t piece, algebraic *u, const signed char *sign) {
    int d = e->cells.dimension;
    const plane_list *planes;
    local_cone cone = {.count = 0};
    LOCAL_VEC(fmpz, direction, d);
    *out = 0;
    TRY(find_direction(direction, e, context, vertex, piece, u, sign));
    TRY(topo_planes(&planes, context, e->scene));
    graze_status status =
        cone_make(&cone, context, e->scene->solid, 0, planes, e->cells.vertex[vertex].x);
    for (int k = 0; k < 2 && !status && !*out; k++) {
        graze_state state = GRAZE_STATE_O;
        status = cone_state(&state, &cone, context, direction);
        *out = !status && state == GRAZE_STATE_I;
        _fmpz_vec_neg(direction, direction, d);
    }
    cone_clear(&cone);
    return status;
}
