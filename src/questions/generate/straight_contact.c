/* Draws a point of a facet, an edge or a vertex, and a time.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/generate/strata.h"

#include "base/context/scope.h"
#include "base/number/vector.h"
#include "decide/trace/trace.h"

/* Barycentric weights of points are multiples of 1/256. */
enum { PARTS = 256 };

/* One draw: where and when a body point touches. */
typedef struct touchpoint {
    const instant *when;
    size_t simplex;
    unsigned zero; /* bits of the simplex's sides on which y lies */
    fmpz *y;       /* d + 1 homogeneous integers */
} touchpoint;

/* The corners of a simplex whose bits of `used` are set, times their common denominator, which is
 * behind the d * d numbers; 0 for the other corners. */
static void scaled_corners(fmpz *out, const graze_solid *solid, size_t simplex, unsigned used) {
    size_t d = (size_t)solid->input.dimension;
    fmpq borrowed[9];
    for (size_t k = 0; k < d * d; k++)
        borrowed[k] =
            used >> k / d & 1 ? solid_corner(solid, simplex, (int)(k / d))[k % d] : (fmpq){0, 1};
    _fmpq_vec_get_fmpz_vec_fmpz(out, out + d * d, borrowed, (slong)(d * d));
}

/* Set y to the sum of the corners times their weights, divided by the sum of the weights. */
static void combine(touchpoint *p, const struct graze_generator *g, const fmpz *weight) {
    int d = g->scene->solid->input.dimension;
    unsigned used = 0;
    LOCAL_VEC(fmpz, at, 10);
    for (int k = 0; k < d; k++)
        used |= (unsigned)!fmpz_is_zero(weight + k) << k;
    scaled_corners(at, g->scene->solid, p->simplex, used);
    _fmpz_vec_zero(p->y, d + 1);
    for (int k = 0; k < d; k++) {
        _fmpz_vec_scalar_addmul_fmpz(p->y, at + k * d, d, weight + k);
        fmpz_addmul(p->y + d, weight + k, at + d * d);
    }
}

/* Draw a body point in the relative interior of a simplex, of one of its input edges, or at a
 * corner, as `cell_dimension` says, which is at most d - 1. Returns 0 if the side drawn is no edge
 * of the input. */
static int draw_on_cell(touchpoint *p, const struct graze_generator *g, random_stream *r,
                        int cell_dimension) {
    const graze_solid *solid = g->scene->solid;
    int d = solid->input.dimension, first = (int)random_below(r, (size_t)d);
    size_t a = 1 + random_below(r, PARTS - 2), b = 1 + random_below(r, PARTS - 2);
    fmpz part[3] = {0, 0, 0}; /* small integers */
    if (cell_dimension == 0) {
        part[first] = PARTS;
        p->zero = d == 2 ? 1u << first : 1u << first | 1u << (first + 2) % 3;
    } else if (cell_dimension == 1) {
        part[first] = (slong)a;
        part[(first + 1) % d] = (slong)(PARTS - a);
        p->zero = d == 2 ? 0 : 1u << first;
        if (d == 3 && (solid->cut.item[p->simplex].diagonal & p->zero))
            return 0;
    } else {
        slong low = (slong)(a < b ? a : b), high = (slong)(a < b ? b : a);
        part[0] = low;
        part[1] = high - low + 1;
        part[2] = PARTS - high - 1;
        p->zero = 0;
        if (part[2] <= 0)
            return 0;
    }
    combine(p, g, part);
    return 1;
}

/* The derivatives of order k of the plane's pullback for the body points at the corners, times one
 * positive number. The derivative is affine over the simplex. */
static void corner_pullbacks(fmpz *out, const touchpoint *p, const struct graze_generator *g,
                             int k) {
    int d = p->when->dimension;
    LOCAL_VEC(fmpz, form, 2 * (d + 1));
    LOCAL_VEC(fmpz, at, 10);
    fmpz *plane = form + d + 1;
    (void)solid_plane(plane, g->scene->solid, p->simplex);
    instant_pullback(form, p->when, plane, k);
    scaled_corners(at, g->scene->solid, p->simplex, 7);
    for (int c = 0; c < d; c++) {
        _fmpz_vec_dot(out + c, form, at + c * d, d);
        fmpz_addmul(out + c, form + d, at + d * d);
    }
}

/* Draw a place between the ends of a segment, in 256ths. */
static slong draw_place(random_stream *r) {
    return 1 + (slong)random_below(r, PARTS - 1);
}

/* Draw a point strictly inside the simplex where the affine function with these corner values
 * vanishes: in E^3 between two zeros on its sides, at a random place. */
static int draw_on_line(touchpoint *p, const struct graze_generator *g, random_stream *r,
                        const fmpz *value) {
    int d = p->when->dimension, found = 0;
    LOCAL_VEC(fmpz, end, 8); /* the weights of the zeros, and behind them their sums */
    for (int k = 0; k < (d == 2 ? 1 : 3) && found < 2; k++) {
        int next = (k + 1) % d;
        if (fmpz_sgn(value + k) * fmpz_sgn(value + next) >= 0)
            continue;
        fmpz *at = end + 4 * found++;
        fmpz_abs(at + k, value + next);
        fmpz_abs(at + next, value + k);
        fmpz_add(at + 3, at + k, at + next);
    }
    int enough = found == d - 1;
    slong a = draw_place(r);
    if (enough && d == 3) {
        _fmpz_vec_scalar_mul_fmpz(end, end, 3, end + 7);
        _fmpz_vec_scalar_mul_si(end, end, 3, a);
        fmpz_mul_si(end + 3, end + 3, PARTS - a);
        _fmpz_vec_scalar_addmul_fmpz(end, end + 4, 3, end + 3);
    }
    if (enough)
        combine(p, g, end);
    p->zero = 0;
    return enough;
}

/* Find the point where two affine functions vanish; returns 0 unless it lies strictly inside the
 * triangle. Its weights are the cross product of the functions' corner values. */
static int draw_on_point(touchpoint *p, const struct graze_generator *g, const fmpz *f,
                         const fmpz *h) {
    LOCAL_VEC(fmpz, weight, 3);
    integers_cross(weight, f, h);
    int inside = 1;
    for (int k = 0; k < 3; k++)
        inside &= fmpz_sgn(weight) * fmpz_sgn(weight + k) > 0;
    if (inside)
        combine(p, g, weight);
    p->zero = 0;
    return inside;
}

/* The order of the contact with the simplex's plane. */
static int order_at(const struct graze_generator *g, const touchpoint *p, const fmpq *world) {
    LOCAL_VEC(fmpz, plane, p->when->dimension + 1);
    HELD(trajectory, c, p->when->dimension);
    LOCAL(fmpz_poly, f);
    (void)solid_plane(plane, g->scene->solid, p->simplex);
    trajectory_set(
        &c, motion_tracing(&g->scene->motion->piece[p->when->piece], g->scene->options.operation),
        world);
    trajectory_pullback(f, &c, plane);
    return order_of_root(f, p->when->u);
}

/* Draw a point of a simplex all of whose points are in contact at one time or, if `slides`, during
 * a whole piece; returns 0 if the special that is drawn is of the other kind. */
static int draw_special(touchpoint *p, const struct graze_generator *g, random_stream *r,
                        int slides) {
    if (g->special.count == 0)
        return 0;
    const special *s = &g->special.item[random_below(r, g->special.count)];
    /* The list has a slide at one time of its piece, u = 1/2, though it lasts all along the piece.
     */
    if (s->slides != slides)
        return 0;
    p->simplex = s->simplex;
    p->when = &s->when;
    return draw_on_cell(p, g, r, g->scene->motion->dimension - 1);
}

static int draw_tangent(touchpoint *p, const struct graze_generator *g, random_stream *r, int odd) {
    if (random_below(r, 2) == 0 && draw_special(p, g, r, 0))
        return 1;
    int drawn, at_point = odd && p->when->dimension == 3;
    if (velocity_has_one_sign(p->when, g->scene->solid, p->simplex)) {
        if (!at_point)
            (void)draw_place(r);
        return 0;
    }
    LOCAL_VEC(fmpz, velocity, 3);
    LOCAL_VEC(fmpz, bend, 3);
    corner_pullbacks(velocity, p, g, 1);
    if (at_point) {
        corner_pullbacks(bend, p, g, 2);
        drawn = draw_on_point(p, g, velocity, bend);
    } else {
        drawn = draw_on_line(p, g, r, velocity);
    }
    return drawn;
}

/* Draw a time and a body point for a stratum of contacts. */
static int draw_contact(touchpoint *p, const struct graze_generator *g, graze_stratum stratum,
                        random_stream *r) {
    int d = g->scene->motion->dimension;
    size_t choice;
    p->when = stratum_instant(g, stratum, r);
    if (!p->when)
        return 0;
    p->simplex = random_below(r, g->scene->solid->cut.count);
    switch (stratum) {
    case GRAZE_STRATUM_FACE:
    case GRAZE_STRATUM_FACE_ODD:
        return draw_tangent(p, g, r, stratum == GRAZE_STRATUM_FACE_ODD);
    case GRAZE_STRATUM_EDGE:
        return d == 3 && draw_on_cell(p, g, r, 1);
    case GRAZE_STRATUM_VERTEX:
        return draw_on_cell(p, g, r, 0);
    case GRAZE_STRATUM_CROSSING:
        return draw_on_cell(p, g, r, d - 1);
    case GRAZE_STRATUM_START:
    case GRAZE_STRATUM_END:
    case GRAZE_STRATUM_BREAK: /* a cell of any dimension, a face most often */
        choice = random_below(r, 4);
        return draw_on_cell(p, g, r, choice < 2 ? d - 1 : choice == 2 && d == 3);
    case GRAZE_STRATUM_SLIDE:
        return draw_special(p, g, r, 1);
    default:
        return 0;
    }
}

int straight_contact(sample *out, fmpq *normal, const struct graze_generator *g,
                     graze_stratum stratum, random_stream *r) {
    LOCAL_VEC(fmpz, y, 4);
    LOCAL_VEC(fmpz, plane, 4);
    touchpoint p = {.y = y};
    /* Moved by a power of 2 along one axis, a contact that is not dyadic stays so. Contacts of
     * `face` may have an order that is not taken, which is found first. */
    int dyadic =
        g->representable && out->made.stratum != GRAZE_STRATUM_ROUNDED &&
        (!normal || (out->made.stratum == GRAZE_STRATUM_MISS && stratum != GRAZE_STRATUM_FACE));
    int made = draw_contact(&p, g, stratum, r);
    if (made && !sample_place(out, p.when, y, dyadic)) {
        made = 0;
        if (normal) /* the side to which it would be displaced */
            (void)random_below(r, 2);
    }
    if (made) {
        out->made.order = order_at(g, &p, out->point);
        size_t names;
        graze_cell cell = solid_cell(g->scene->solid, p.simplex, p.zero);
        out->made.cell = *cell_names_of(&names, &g->scene->solid->cut.names, &cell);
        fmpq_set(out->time, p.when->t);
        made = stratum_takes_order(stratum, out->made.order);
    }
    if (made && normal) {
        int facing = solid_plane(plane, g->scene->solid, p.simplex);
        _fmpz_vec_scalar_mul_si(plane, plane, p.when->dimension + 1, facing);
        instant_normal(normal, p.when, plane);
    }
    return made;
}
