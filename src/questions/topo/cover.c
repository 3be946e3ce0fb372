/* Cover of directions by the sides of germs and by the solid at the time.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/topo/cover.h"

#include "base/context/scope.h"

/* Is u opposite to e: is u + s e along the cone's cell for some s > 0? For e = 0: is u along the
 * cell? The first plane that is not parallel to e gives s = -p / q. */
static int is_opposite(const local_cone *cone, const fmpz *u, const fmpz *e) {
    slong d = cone->dimension;
    int sign = -1, has_s = 0;
    LOCAL_VEC(fmpz, a, 3);
    fmpz *b = a + 1, *p = a + 2;
    LOCAL(fmpz, q);
    fmpz_set_ui(q, 1);
    for (size_t j = 0; j < cone->count; j++) {
        const fmpz *n = cone->normal + j * (size_t)d;
        _fmpz_vec_dot(a, n, u, d);
        _fmpz_vec_dot(b, n, e, d);
        if (!has_s && !fmpz_is_zero(b)) {
            fmpz_set(p, a);
            fmpz_set(q, b);
            sign *= -fmpz_sgn(p) * fmpz_sgn(q);
            has_s = 1;
        }
        fmpz_mul(a, a, q);
        fmpz_submul(a, b, p);
        sign *= fmpz_is_zero(a);
    }
    return sign < 0;
}

/* Add the cover by one side. */
static graze_status cover_by_side(germ_cover *out, germ *g, const germ_side *side,
                                  graze_context *context, const fmpz *u) {
    int in_interior = 0, in_cone = 0;
    TRY(cone_sweep(&in_interior, &in_cone, &g->cone, context, NULL, u, side->e));
    out->open |= in_interior;
    out->covered |= in_cone;
    out->exact |= in_cone && side->exact;
    if (side->has_later) {
        TRY(cone_sweep(&in_interior, &in_cone, &g->cone, context, side->e, u, side->later));
        out->open |= in_interior;
        out->covered |= in_cone;
    }
    out->edge_way |= side->edge_way && is_opposite(&g->cone, u, side->e);
    return GRAZE_OK;
}

/* Add the cover by the solid at the time itself. */
static graze_status cover_at_rest(germ_cover *out, germ *g, graze_context *context, const fmpz *u) {
    graze_state state = GRAZE_STATE_O;
    TRY(cone_state(&state, &g->cone, context, u));
    out->open |= state == GRAZE_STATE_I;
    out->exact |= state != GRAZE_STATE_O;
    out->covered |= out->exact;
    return GRAZE_OK;
}

graze_status germ_cover_body(germ_cover *out, germ *g, graze_context *context, const fmpz *u,
                             int keeping_edge) {
    static const fmpz none[3] = {0, 0, 0};
    TRY(cover_at_rest(out, g, context, u));
    for (int s = 0; s < g->side_count; s++)
        if (!keeping_edge || g->side[s].keeps_edge)
            TRY(cover_by_side(out, g, &g->side[s], context, u));
    out->edge_way |= g->covers_edge && is_opposite(&g->cone, u, none);
    out->covered |= out->exact | out->open | out->edge_way;
    return GRAZE_OK;
}

void germ_to_body(fmpz *out, const germ *g, const fmpz *direction) {
    int d = g->cone.dimension;
    for (int i = 0; i < d; i++)
        _fmpz_vec_dot(out + i, g->to_body + i * d, direction, d);
}

graze_status germ_cover_part(germ_cover *out, germ *g, graze_context *context,
                             const fmpz *direction, int part) {
    if (g->root)
        return out->covered ? GRAZE_OK
                            : signs_cover_at_root(&out->covered, g, context, direction, part);
    LOCAL_VEC(fmpz, u, g->cone.dimension);
    germ_to_body(u, g, direction);
    TRY(part == GERM_WHOLE ? germ_cover_body(out, g, context, u, 0)
                           : cover_at_rest(out, g, context, u));
    if (part >= 0)
        TRY(cover_by_side(out, g, &g->side[part], context, u));
    return GRAZE_OK;
}

graze_status germs_cover(germ_cover *out, germ_list *list, graze_context *context,
                         const fmpz *direction) {
    *out = (germ_cover){0, 0, 0, 0};
    for (size_t k = 0; k < list->count && !(out->open && out->exact); k++)
        TRY(germ_cover_part(out, &list->item[k], context, direction, GERM_WHOLE));
    for (size_t k = 0; k < list->turn_count && !out->covered; k++)
        TRY(signs_cover_in_turn(&out->covered, &list->turn[k], &list->item[list->turn[k].germ],
                                context, direction));
    return GRAZE_OK;
}
