/* Both polyhedra of a body of revolution: doubles choose, tool_pair_holds decides.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/convert/angle.h"

#include <math.h>
#include "base/context/scope.h"

static const double pi_near = 3.14159265358979323846;

enum { FINEST_SIDES = 1 << 18, ROUNDS = 8 };

/* Round a number to a multiple of 2^-bits: towards 0 if way is 0, away from 0 if it is 1. */
static void snap_double(fmpq_t out, double value, slong bits, int way) {
    double scaled = ldexp(value, (int)bits);
    fmpz_set_d(fmpq_numref(out), way ? (value < 0 ? floor(scaled) : ceil(scaled)) : trunc(scaled));
    fmpz_one(fmpq_denref(out));
    fmpq_div_2exp(out, out, (flint_bitcnt_t)bits);
}

/* A point of the unit disc near the direction of an angle. */
static void snap_direction(fmpq *out, double angle, slong bits) {
    double c = cos(angle), s = sin(angle);
    snap_double(out, fabs(c) < 1e-15 ? 0 : c, bits, 0);
    snap_double(out + 1, fabs(s) < 1e-15 ? 0 : s, bits, 0);
}

/* A dyadic number not below the largest 1 / |(a + b) / 2| of neighbours a, b: once the directions
 * are multiplied by it, the unit disc is on the inner side of the lines through neighbours. */
static void stretch_of(fmpq_t out, const fmpq *direction, size_t count, int closed, slong bits) {
    double most = 1;
    for (size_t k = 0; k + !closed < count; k++) {
        const fmpq *a = direction + 2 * k, *b = direction + 2 * ((k + 1) % count);
        double x = fmpq_get_d(a) + fmpq_get_d(b), y = fmpq_get_d(a + 1) + fmpq_get_d(b + 1);
        most = fmax(most, 2 / hypot(x, y));
    }
    LOCAL(fmpq, step);
    fmpq_one(step);
    fmpq_div_2exp(step, step, (flint_bitcnt_t)bits - 2);
    snap_double(out, most, bits, 1);
    fmpq_add(out, out, step); /* what snapping has taken from the ends of an arc */
}

static void add_profile_point(profile *p, const fmpq_t r, const fmpq_t z) {
    fmpq_set(p->point + 2 * p->count, r);
    fmpq_set(p->point + 2 * p->count + 1, z);
    p->count++;
}

/* flat + corner factor d_0, corner + corner factor d_1 */
static void add_arc_point(profile *p, const tool *s, const fmpq *direction, const fmpq_t factor) {
    LOCAL_VEC(fmpq, r, 3);
    fmpq *z = r + 1, *size = r + 2;
    fmpq_mul(size, s->corner, factor);
    fmpq_mul(r, size, direction);
    fmpq_add(r, r, s->flat);
    fmpq_mul(z, size, direction + 1);
    fmpq_add(z, z, s->corner);
    add_profile_point(p, r, z);
}

/* The top's radius on the line across the normal through the last point: r - (height - z) n_z /
 * n_r, on a grid, inwards or outwards. */
static void add_top(profile *p, const tool *s, const fmpq *normal, slong bits, int outer) {
    const fmpq *last = p->point + 2 * (p->count - 1);
    LOCAL_VEC(fmpq, r, 2);
    fmpq *rise = r + 1;
    LOCAL(fmpz, whole);
    fmpq_sub(rise, s->height, last + 1);
    fmpq_mul(rise, rise, normal + 1);
    fmpq_div(rise, rise, normal);
    fmpq_sub(r, last, rise);
    if (!fmpq_is_zero(normal + 1)) {
        fmpq_mul_2exp(r, r, (flint_bitcnt_t)bits);
        (outer ? fmpz_cdiv_q : fmpz_fdiv_q)(whole, fmpq_numref(r), fmpq_denref(r));
        fmpq_set_fmpz(r, whole);
        fmpq_div_2exp(r, r, (flint_bitcnt_t)bits);
    }
    add_profile_point(p, r, s->height);
}

static void make_profiles(tool_pair *out, const tool *s, size_t pieces, slong bits) {
    LOCAL_VEC(fmpq, direction, (slong)(2 * pieces + 2));
    LOCAL_VEC(fmpq, one, 2);
    fmpq *stretch = one + 1;
    fmpq_one(one);
    double from = -pi_near / 2, to = atan2(fmpq_get_d(s->high + 1), fmpq_get_d(s->high));
    for (size_t k = 0; k <= pieces; k++)
        snap_direction(direction + 2 * k, from + (to - from) * (double)k / (double)pieces, bits);
    stretch_of(stretch, direction, pieces + 1, 0, bits);
    if (fmpq_is_zero(s->corner)) {
        add_arc_point(&out->in, s, direction, one);
        add_arc_point(&out->out, s, direction, one);
    }
    for (size_t k = 0; k <= pieces && !fmpq_is_zero(s->corner); k++) {
        add_arc_point(&out->in, s, direction + 2 * k, one);
        add_arc_point(&out->out, s, direction + 2 * k, stretch);
    }
    if (!s->ball) {
        int exponent = 0; /* exponent of the radius: a small radius gets a finer grid for the top
                           */
        frexp(fmpq_get_d(s->flat) + fmpq_get_d(s->corner), &exponent);
        bits = exponent < 0 ? bits - exponent : bits;
        add_top(&out->in, s, s->low, bits, 0);
        add_top(&out->out, s, s->high, bits, 1);
    }
}

/* Make both polyhedra with `sides` sides a ring and `pieces` pieces of the arc; coordinates of
 * directions are multiples of 2^-bits. */
static void tool_pair_make(tool_pair *out, const tool *s, size_t sides, size_t pieces, slong bits) {
    slong room = (slong)(2 * (pieces + 3));
    *out = (tool_pair){{0, _fmpq_vec_init(room)}, {0, _fmpq_vec_init(room)}, sides, NULL, {{0}}};
    out->corner = _fmpq_vec_init((slong)(2 * sides));
    fmpq_init(out->stretch);
    for (size_t k = 0; k < sides; k++)
        snap_direction(out->corner + 2 * k, 2 * pi_near * (double)k / (double)sides, bits);
    stretch_of(out->stretch, out->corner, sides, 1, bits);
    make_profiles(out, s, pieces, bits);
}

void tool_pair_clear(tool_pair *p) {
    _fmpq_vec_clear(p->in.point, (slong)(2 * p->in.count));
    _fmpq_vec_clear(p->out.point, (slong)(2 * p->out.count));
    _fmpq_vec_clear(p->corner, (slong)(2 * p->sides));
    fmpq_clear(p->stretch);
}

/* Sides and pieces of the arc for half of the tolerance each: a chord over the angle d of a circle
 * of radius r is r d^2 / 8 from it. */
static void choose_counts(double counts[2], const tool *s, const fmpq_t tolerance) {
    double half = 0.45 * fmpq_get_d(tolerance), corner = fmpq_get_d(s->corner);
    double normal = atan2(fmpq_get_d(s->high + 1), fmpq_get_d(s->high));
    double radius = fmpq_get_d(s->flat) + corner;
    if (!s->ball)
        radius = fmax(radius, radius - fmpq_get_d(s->height) * tan(normal));
    counts[0] = 4 * ceil(fmax(2, pi_near * sqrt(radius / (2 * half)) / 4));
    counts[1] = ceil((normal + pi_near / 2) * sqrt(corner / (8 * half)));
}

graze_status tool_fit(tool_pair *out, fmpq_t square, graze_context *context, const tool *s,
                      const fmpq_t tolerance) {
    double counts[2];
    choose_counts(counts, s, tolerance);
    for (int round = 0; round < ROUNDS; round++) {
        double most = fmax(counts[0], counts[1] = fmax(counts[1], 1));
        if (counts[0] * (counts[1] + 2) > (double)context->limits[GRAZE_LIMIT_CELLS])
            return context_limit(context, GRAZE_LIMIT_CELLS, "the vertices of a tool");
        if (!(most < FINEST_SIDES))
            return context_fail(context, GRAZE_EUSE,
                                "tolerance: expected at least 1e-10 of the diameter");
        slong bits = 12 + 2 * (slong)ceil(log2(most));
        tool_pair_make(out, s, (size_t)counts[0], (size_t)counts[1], bits < 50 ? bits : 50);
        if (tool_pair_holds(square, out, s, tolerance))
            return GRAZE_OK;
        tool_pair_clear(out);
        for (int k = 0; k < 2; k++)
            counts[k] = ceil(counts[k] * 1.1);
        counts[0] = 4 * ceil(counts[0] / 4);
        TRY(context_poll(context));
    }
    return context_fail(context, GRAZE_EUSE,
                        "no polyhedron was found; expected corner, length and tolerance less far "
                        "apart in size");
}

void tool_report(text *out, const tool_pair *p, const fmpq_t square) {
    LOCAL_MPFR(distance, ANGLE_BITS);
    root_above(distance, square);
    text_format(out, "sides: %zu, rings: %zu\n", p->sides, p->in.count);
    put_fact(out, "error: the tool lies between both polyhedra, and each is off it by", distance,
             "");
}
