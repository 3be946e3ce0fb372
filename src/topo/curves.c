/* Curves of a scene, by resultants and discriminants with respect to time.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A facet's line n pulled back to a piece is f(x, y, u) = a(u) x + b(u) y + c(u). A common factor
 * of a, b and c has no root in [0, 1], where the map is invertible, and is divided out.
 */
#include "topo/curves.h"

#include <flint/fmpq_vec.h>
#include <stdlib.h>
#include <string.h>
#include "context/array.h"
#include "solid/planes.h"

void curves_init(curve_list *list) {
    memset(list, 0, sizeof *list);
    fmpz_mpoly_ctx_init(list->ring, RING_VARIABLES, ORD_LEX);
}

void curves_clear(curve_list *list) {
    for (size_t k = 0; k < list->count; k++)
        fmpz_mpoly_clear(&list->item[k], list->ring);
    free(list->item);
    fmpz_mpoly_ctx_clear(list->ring);
}

graze_status curves_append(curve_list *list, graze_context *context, const fmpz_mpoly_t curve) {
    if (fmpz_mpoly_is_fmpz(curve, list->ring))
        return GRAZE_OK;
    graze_status status = array_grow(context, &list->item, &list->capacity, list->count + 1,
                                     sizeof *list->item, "the curves of a sweep");
    if (status)
        return status;
    fmpz_mpoly_init(&list->item[list->count], list->ring);
    fmpz_mpoly_set(&list->item[list->count++], curve, list->ring);
    return GRAZE_OK;
}

/* linear[0] x + linear[1] y + linear[2], whose coefficients are polynomials in time. */
typedef struct pullback_form {
    fmpz_poly_struct linear[3];
} pullback_form;

static void pullback_init(pullback_form *f) {
    for (int i = 0; i < 3; i++)
        fmpz_poly_init(&f->linear[i]);
}

static void pullback_clear(pullback_form *f) {
    for (int i = 0; i < 3; i++)
        fmpz_poly_clear(&f->linear[i]);
}

/* The form over the images of all points under a map of the plane. */
static void pullback_of_form(pullback_form *f, const point_map *map, const fmpz *form) {
    for (int i = 0; i < 3; i++) {
        fmpz_poly_zero(&f->linear[i]);
        for (int row = 0; row < 2; row++)
            fmpz_poly_scalar_addmul_fmpz(&f->linear[i], &map->entry[row * 3 + i], form + row);
    }
    fmpz_poly_scalar_addmul_fmpz(&f->linear[2], map->weight, form + 2);
}

/* Divide by the common factor; returns the degree in time that remains. */
static slong pullback_reduce(pullback_form *f) {
    slong degree = 0;
    fmpz_poly_t common;
    fmpz_poly_init(common);
    for (int i = 0; i < 3; i++)
        fmpz_poly_gcd(common, common, &f->linear[i]);
    for (int i = 0; i < 3; i++) {
        fmpz_poly_div(&f->linear[i], &f->linear[i], common);
        degree = FLINT_MAX(degree, fmpz_poly_degree(&f->linear[i]));
    }
    fmpz_poly_clear(common);
    return degree;
}

static void polynomial_of_pullback(fmpz_mpoly_t out, const pullback_form *f,
                                   const fmpz_mpoly_ctx_t ring) {
    fmpz_mpoly_t part, variable;
    fmpz_mpoly_init(part, ring);
    fmpz_mpoly_init(variable, ring);
    fmpz_mpoly_set_fmpz_poly(out, &f->linear[2], RING_T, ring);
    for (int i = 0; i < 2; i++) {
        fmpz_mpoly_set_fmpz_poly(part, &f->linear[i], RING_T, ring);
        fmpz_mpoly_gen(variable, i, ring);
        fmpz_mpoly_mul(part, part, variable, ring);
        fmpz_mpoly_add(out, out, part, ring);
    }
    fmpz_mpoly_clear(part, ring);
    fmpz_mpoly_clear(variable, ring);
}

/* What the walk over pieces, lines and vertices shares. */
typedef struct curve_maker {
    curve_list *list;
    int refused;
    graze_context *context;
    const graze_scene *scene;
} curve_maker;

/* The line at u = 0 or 1. */
static graze_status add_line_at(curve_maker *m, const pullback_form *f, slong u) {
    pullback_form at;
    fmpz_mpoly_t curve;
    fmpz_t value, when;
    fmpz_init(value);
    fmpz_init_set_si(when, u);
    pullback_init(&at);
    fmpz_mpoly_init(curve, m->list->ring);
    for (int i = 0; i < 3; i++) {
        fmpz_poly_evaluate_fmpz(value, &f->linear[i], when);
        fmpz_poly_set_fmpz(&at.linear[i], value);
    }
    polynomial_of_pullback(curve, &at, m->list->ring);
    graze_status status = curves_append(m->list, m->context, curve);
    fmpz_mpoly_clear(curve, m->list->ring);
    pullback_clear(&at);
    fmpz_clear(value);
    fmpz_clear(when);
    return status;
}

/* Where the pullback, of degree at least 2 in time, has a double root, or vanishes. */
static graze_status add_discriminant(curve_maker *m, const pullback_form *f) {
    fmpz_mpoly_t whole, curve;
    fmpz_mpoly_init(whole, m->list->ring);
    fmpz_mpoly_init(curve, m->list->ring);
    polynomial_of_pullback(whole, f, m->list->ring);
    graze_status status = GRAZE_OK;
    if (!fmpz_mpoly_discriminant(curve, whole, RING_T, m->list->ring) ||
        fmpz_mpoly_is_zero(curve, m->list->ring))
        status = context_fail(m->context, GRAZE_EINTERNAL,
                              "the discriminant of an irreducible pullback vanishes");
    else
        status = curves_append(m->list, m->context, curve);
    fmpz_mpoly_clear(whole, m->list->ring);
    fmpz_mpoly_clear(curve, m->list->ring);
    return status;
}

static graze_status add_curves_of_line(curve_maker *m, const motion_piece *piece,
                                       const fmpz *form) {
    const graze_operation operation = m->scene->options.operation;
    pullback_form f;
    pullback_init(&f);
    pullback_of_form(&f, motion_tracing(piece, operation), form);
    slong degree = pullback_reduce(&f);
    graze_status status = add_line_at(m, &f, 0);
    if (!status && degree > 0)
        status = add_line_at(m, &f, 1);
    m->refused |= degree > CURVE_DEGREE;
    if (!status && degree > 1 && !m->refused)
        status = add_discriminant(m, &f);
    pullback_clear(&f);
    return status;
}

/* The resultant of x W - X and y W - Y, each without its factor in time alone. */
static graze_status add_path(curve_maker *m, const motion_piece *piece, const fmpq *vertex) {
    const fmpz_mpoly_ctx_struct *ring = m->list->ring;
    const point_map *map = motion_placing(piece, m->scene->options.operation);
    fmpz_mpoly_t side[2], curve;
    fmpz scale[3] = {0, 0, 0};
    slong degree[2];
    pullback_form f;
    pullback_init(&f);
    fmpz_mpoly_init(curve, ring);
    _fmpq_vec_get_fmpz_vec_fmpz(scale, scale + 2, vertex, 2);
    for (int row = 0; row < 2; row++) {
        fmpz_mpoly_init(side[row], ring);
        for (int i = 0; i < 3; i++)
            fmpz_poly_zero(&f.linear[i]);
        fmpz_poly_scalar_mul_fmpz(&f.linear[row], map->weight, scale + 2);
        for (int i = 0; i < 3; i++)
            fmpz_poly_scalar_submul_fmpz(&f.linear[2], &map->entry[row * 3 + i], scale + i);
        degree[row] = pullback_reduce(&f);
        polynomial_of_pullback(side[row], &f, ring);
        m->refused |= degree[row] > CURVE_DEGREE;
    }
    graze_status status = GRAZE_OK;
    if (!m->refused && degree[0] == 0 && degree[1] > 0)
        status = curves_append(m->list, m->context, side[0]);
    else if (!m->refused && degree[1] == 0 && degree[0] > 0)
        status = curves_append(m->list, m->context, side[1]);
    else if (!m->refused && degree[0] > 0) {
        if (!fmpz_mpoly_resultant(curve, side[0], side[1], RING_T, ring) ||
            fmpz_mpoly_is_zero(curve, ring))
            status = context_fail(m->context, GRAZE_EINTERNAL,
                                  "the resultant of the coordinates of a path vanishes");
        else
            status = curves_append(m->list, m->context, curve);
    }
    for (int row = 0; row < 2; row++)
        fmpz_mpoly_clear(side[row], ring);
    for (int i = 0; i < 3; i++)
        fmpz_clear(scale + i);
    fmpz_mpoly_clear(curve, ring);
    pullback_clear(&f);
    return status;
}

static graze_status add_piece(curve_maker *m, const motion_piece *piece, const plane_list *lines) {
    const graze_solid *solid = m->scene->solid;
    graze_status status = GRAZE_OK;
    for (size_t k = 0; k < lines->count && !status && !m->refused; k++) {
        status = add_curves_of_line(m, piece, lines->form + 3 * k);
        if (!status)
            status = context_poll(m->context);
    }
    /* Each vertex is where some facet begins. */
    for (size_t s = 0; s < solid->cut.count && !status && !m->refused; s++) {
        size_t vertex = solid->cut.item[s].vertex[0];
        status = add_path(m, piece, solid->input.coordinates + 2 * vertex);
        if (!status)
            status = context_poll(m->context);
    }
    return status;
}

graze_status curves_of_scene(curve_list *list, int *refused, graze_context *context,
                             const graze_scene *scene) {
    const graze_motion *motion = scene->motion;
    curve_maker m = {list, 0, context, scene};
    plane_list lines;
    if (planes_find(&lines, scene->solid, NULL, scene->solid->cut.count) != 0)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for the lines of a solid");
    size_t each = 3 * lines.count + scene->solid->cut.count;
    m.refused = motion->piece_count > CURVE_COUNT / each;
    graze_status status = GRAZE_OK;
    for (size_t k = 0; k < motion->piece_count && !status && !m.refused; k++)
        status = add_piece(&m, &motion->piece[k], &lines);
    planes_clear(&lines);
    *refused = m.refused;
    return status;
}
