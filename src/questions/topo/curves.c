/* Curves of a scene, by resultants and discriminants with respect to time.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A facet's line n pulled back to a piece is f(x, y, u) = a(u) x + b(u) y + c(u). A common factor
 * of a, b and c is divided out; in E^2 it has no root in [0, 1], where the map is invertible.
 */
#include "base/context/scope.h"
#include "base/number/isolate.h"
#include "questions/topo/eliminate.h"

/* Has a polynomial a root in [0, 1], the range of a piece's parameter? */
static graze_status meets_piece(int *out, graze_context *context, const fmpz_poly_t p) {
    *out = fmpz_poly_is_zero(p);
    if (fmpz_poly_degree(p) < 1)
        return GRAZE_OK;
    HELD(algebraic_list, roots);
    TRY(algebraic_roots(&roots, context, p, &unit_interval));
    *out = roots.count > 0;
    return GRAZE_OK;
}

/* State of the loops over pieces, facets and vertices. */
typedef struct curve_maker {
    curve_list *list;
    const char *refused;
    graze_context *context;
    const graze_scene *scene;
    const plane_view *view;
} curve_maker;

static const char in_plane[] = "facets or edges come to lie in a plane through the point";

static void refuse_degree(curve_maker *m, slong degree) {
    int in_e2 = m->view->dimension == 2;
    ulong most = in_e2 ? m->context->limits[GRAZE_LIMIT_CURVE] : SLICE_CURVE_DEGREE;
    if (degree > 0 && (ulong)degree > most)
        m->refused = in_e2
                         ? "a curve of the scene has a higher degree than the limit `curve` allows"
                         : "a curve in a plane has a higher degree than is looked at";
}

/* Add the line at the end u = 0 or u = 1 of a piece. */
static graze_status add_line_at(curve_maker *m, const pullback_form *f, fmpz u) {
    IN_RING(fmpz_mpoly, curve, m->list->ring);
    pullback_at(curve, f, &u, m->list->ring);
    return curves_append(m->list, m->context, curve);
}

/* Add the curve where the pullback, of degree >= 2 in time, has a double root or vanishes. */
static graze_status add_discriminant(curve_maker *m, const pullback_form *f) {
    IN_RING(fmpz_mpoly, curve, m->list->ring);
    TRY(grid_discriminant(curve, m->context, f, m->list->ring));
    if (fmpz_mpoly_is_zero(curve, m->list->ring))
        return context_fail(m->context, GRAZE_EINTERNAL,
                            "the discriminant of an irreducible pullback vanishes");
    return curves_append(m->list, m->context, curve);
}

/* Make the pullback of a form, divided by the common factor of its coefficients. In E^2 the factor
 * has no root on the piece. */
static graze_status make_pullback(pullback_form *f, curve_maker *m, const motion_piece *piece,
                                  const fmpz *form) {
    int meets = 0;
    LOCAL(fmpz_poly, common);
    pullback_of_form(f, motion_tracing(piece, m->scene->options.operation), form, m->view);
    pullback_reduce(f, common);
    TRY(meets_piece(&meets, m->context, common));
    if (meets)
        m->refused = in_plane;
    else
        refuse_degree(m, f->degree);
    return GRAZE_OK;
}

static graze_status add_curves_of_plane(curve_maker *m, const motion_piece *piece,
                                        const fmpz *form) {
    HELD(pullback_form, f);
    TRY(make_pullback(&f, m, piece, form));
    if (m->refused)
        return GRAZE_OK;
    TRY(add_line_at(m, &f, 0));
    if (f.degree > 0)
        TRY(add_line_at(m, &f, 1));
    return f.degree < 2 ? GRAZE_OK : add_discriminant(m, &f);
}

/* Add the curve where two irreducible functions of x, y and time vanish at the same time. */
static graze_status add_common_zeros(curve_maker *m, const pullback_form *f,
                                     const pullback_form *g) {
    const fmpz_mpoly_ctx_struct *ring = m->list->ring;
    if (m->refused || (f->degree == 0 && g->degree == 0))
        return GRAZE_OK;
    if (f->degree == 0 || g->degree == 0)
        return add_line_at(m, f->degree == 0 ? f : g, 0);
    IN_RING(fmpz_mpoly, curve, ring);
    TRY(grid_resultant(curve, m->context, f, g, ring));
    if (!fmpz_mpoly_is_zero(curve, ring))
        return curves_append(m->list, m->context, curve);
    m->refused = in_plane; /* both are the same function, which is possible only in E^3 */
    return GRAZE_OK;
}

/* Add the path of a vertex of E^2: the common zeros of x W - X and y W - Y, each divided by its
 * factor in time alone. */
static graze_status add_path(curve_maker *m, const motion_piece *piece, const fmpq *vertex) {
    const point_map *map = motion_placing(piece, m->scene->options.operation);
    LOCAL_VEC(fmpz, scale, 3);
    LOCAL(fmpz_poly, common);
    HELD(pullback_form, x);
    HELD(pullback_form, y);
    _fmpq_vec_get_fmpz_vec_fmpz(scale, scale + 2, vertex, 2);
    for (int row = 0; row < 2; row++) {
        pullback_form *f = row ? &y : &x;
        fmpz_poly_scalar_mul_fmpz(&f->linear[row], map->weight, scale + 2);
        for (int i = 0; i < 3; i++)
            fmpz_poly_scalar_submul_fmpz(&f->linear[2], &map->entry[row * 3 + i], scale + i);
        pullback_reduce(f, common);
        refuse_degree(m, f->degree);
    }
    return add_common_zeros(m, &x, &y);
}

/* Add the path of side k of a triangle of E^3: the common zeros of the triangle's plane and of the
 * side's form. */
static graze_status add_edge_path(curve_maker *m, const motion_piece *piece, size_t triangle,
                                  int k) {
    LOCAL_VEC(fmpz, form, 8); /* two of 4 */
    HELD(pullback_form, plane);
    HELD(pullback_form, side);
    (void)solid_plane(form, m->scene->solid, triangle);
    solid_side(form + 4, m->scene->solid, triangle, form, k);
    TRY(make_pullback(&plane, m, piece, form));
    if (!m->refused)
        TRY(make_pullback(&side, m, piece, form + 4));
    return add_common_zeros(m, &plane, &side);
}

static graze_status add_paths_of(curve_maker *m, const motion_piece *piece, size_t s) {
    const graze_solid *solid = m->scene->solid;
    size_t first = solid->cut.item[s].vertex[0];
    /* Each vertex is the first vertex of some facet. */
    if (m->view->dimension == 2)
        return add_path(m, piece, solid->input.coordinates + 2 * first);
    for (int k = 0; k < 3 && !m->refused; k++)
        TRY(add_edge_path(m, piece, s, k));
    return GRAZE_OK;
}

static graze_status add_piece(curve_maker *m, const motion_piece *piece, const plane_list *planes) {
    size_t form_size = (size_t)planes->dimension + 1;
    for (size_t k = 0; k < planes->count && !m->refused; k++) {
        TRY(add_curves_of_plane(m, piece, planes->form + form_size * k));
        TRY(context_poll(m->context));
    }
    for (size_t s = 0; s < m->scene->solid->cut.count && !m->refused; s++) {
        TRY(add_paths_of(m, piece, s));
        TRY(context_poll(m->context));
    }
    return GRAZE_OK;
}

graze_status curves_of_scene(curve_list *list, const char **refused, graze_context *context,
                             const graze_scene *scene, const plane_list *planes,
                             const plane_view *view) {
    const graze_motion *motion = scene->motion;
    curve_maker m = {list, NULL, context, scene, view};
    size_t each = 3 * (planes->count + scene->solid->cut.count);
    size_t most = view->dimension == 2 ? CURVE_COUNT : SLICE_CURVE_COUNT;
    *refused = NULL;
    if (motion->piece_count > most / each)
        m.refused = view->dimension == 2
                        ? "the scene has more than the 100000 curves that are looked at"
                        : "the scene has more curves in a plane than are looked at";
    for (size_t k = 0; k < motion->piece_count && !m.refused; k++)
        TRY(add_piece(&m, &motion->piece[k], planes));
    *refused = m.refused;
    return GRAZE_OK;
}
