/* Chooses numbers of sides in doubles and lets tool_pair_holds decide.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/convert/convert.h"

#include <math.h>
#include "base/context/scope.h"
#include "input/convert/angle.h"

static const double half_turn = 3.14159265358979;

enum { FINEST_SIDES = 1 << 18, ROUNDS = 8 };

/* Sides and pieces of the arc for half of the tolerance each: a chord over the angle d of a circle
 * of radius r is r d^2 / 8 from it. */
static void choose_counts(double counts[2], const tool *s, const fmpq_t tolerance) {
    double half = 0.45 * fmpq_get_d(tolerance), corner = fmpq_get_d(s->corner);
    double normal = atan2(fmpq_get_d(s->high + 1), fmpq_get_d(s->high));
    double radius = fmpq_get_d(s->flat) + corner;
    if (!s->ball)
        radius = fmax(radius, radius - fmpq_get_d(s->height) * tan(normal));
    counts[0] = 4 * ceil(fmax(2, half_turn * sqrt(radius / (2 * half)) / 4));
    counts[1] = ceil((normal + half_turn / 2) * sqrt(corner / (8 * half)));
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
