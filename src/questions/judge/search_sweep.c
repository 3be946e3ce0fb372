/* The greatest distance of the sweep's boundary to the mesh: cubes of the band, the one first in
 * which it can be greatest. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/judge/search_sweep.h"

#include <math.h>
#include <string.h>
#include "decide/filter/normal.h"

/* Points that bracket the boundary are sought around cubes of at most this share of the width that
 * is wanted, and brought together to this share of it. */
static const double BRACKET_CUBE = 0.75, BRACKET_LENGTH = 0.0625;

/* Corners are sought this much beyond those of the cube. */
static const double BEYOND = 1.5;

/* No place of the boundary in the cube is further from the mesh. */
static double cube_bound(const suprema *s, const cube *c) {
    mesh_gap gap = mesh_gap_of(s->mesh, c->centre);
    double round = gap.high + cube_radius(c);
    return smaller(round, mesh_gap_of_cube(s->mesh, gap.simplex, c->centre, c->half));
}

/* It is in a cube of which `most` is a bound too. */
static graze_status add_cube(suprema *s, uint32_t index, double most) {
    double bound = smaller(cube_bound(s, &s->space.item[index]), most);
    return priority_add(&s->cubes, s->context, bound, index);
}

/* A place of the boundary is at most `off` from the point: how far it is from the mesh at least. */
static void take_low(suprema *s, const double *point, double off) {
    double low = mesh_gap_of(s->mesh, point).low - off;
    if (low > s->found[SUPREMUM_SWEEP].low) {
        s->found[SUPREMUM_SWEEP].low = low;
        memcpy(s->found[SUPREMUM_SWEEP].at, point, sizeof s->found[SUPREMUM_SWEEP].at);
    }
}

static double length_of_way(const double *a, const double *b) {
    double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
    return sqrt(x * x + y * y + z * z) * (1 + 0x1p-48);
}

/* Between a point in the sweep and one outside it is a place of the boundary. */
static graze_status take_bracket(suprema *s, const double *in, const double *out) {
    double a[3], b[3], middle[3];
    graze_status status = GRAZE_OK;
    memcpy(a, in, sizeof a);
    memcpy(b, out, sizeof b);
    while (!status && length_of_way(a, b) > BRACKET_LENGTH * s->within) {
        known_point known;
        for (int i = 0; i < 3; i++)
            middle[i] = 0.5 * (a[i] + b[i]);
        status = suprema_ask(&known, s, middle, ASK_NO_DISTANCE);
        if (!status)
            memcpy(known.pmc == GRAZE_OUT ? b : a, middle, sizeof a);
    }
    if (!status)
        take_low(s, b, length_of_way(a, b));
    return status;
}

/* Points of and around a cube: some in and some out are a bracket; where all are out, the place of
 * the sweep that is nearest to the centre is of its boundary; where all are in, the cube is perhaps
 * all inside.
 * @param[out] settled it is */
static graze_status sample_cube(int *settled, suprema *s, uint32_t index) {
    cube copy = s->space.item[index], *c = &copy;
    double in[3] = {0}, out[3] = {0}, point[3];
    int has_in = 0, has_out = 0;
    graze_status status = GRAZE_OK;
    for (int k = 0; k < 9 && !status && !(has_in && has_out); k++) {
        known_point known;
        for (int i = 0; i < 3; i++)
            point[i] = c->centre[i] + (k ? (k - 1) >> i & 1 ? BEYOND : -BEYOND : 0) * c->half;
        status = suprema_ask(&known, s, point, ASK_NO_DISTANCE);
        if (status)
            return status;
        memcpy(known.pmc == GRAZE_OUT ? out : in, point, sizeof point);
        *(known.pmc == GRAZE_OUT ? &has_out : &has_in) = 1;
    }
    if (has_in && has_out)
        return take_bracket(s, in, out);
    if (has_in)
        return suprema_settle(settled, s, index);
    if (has_out) {
        known_point known;
        status = suprema_ask(&known, s, c->centre, ASK_OUT);
        if (!status)
            take_low(s, c->centre, known.high);
    }
    return status;
}

/* The eight cubes of one that was cut. */
static graze_status add_below(suprema *s, uint32_t child, double most) {
    graze_status status = GRAZE_OK;
    for (uint32_t k = child; !status && k < child + 8; k++)
        if (s->space.item[k].kind & CUBE_BAND)
            status = add_cube(s, k, most);
    return status;
}

/* Take up the cube with the greatest bound. */
static graze_status look_at_cube(suprema *s) {
    waiting_part first = priority_take(&s->cubes);
    double radius = cube_radius(&s->space.item[first.number]);
    int done = 0;
    graze_status status = GRAZE_OK;
    if (radius <= BRACKET_CUBE * s->within)
        status = sample_cube(&done, s, first.number);
    if (status || done)
        return status;
    if (first.bound - s->found[SUPREMUM_SWEEP].low > s->within) {
        const cube c = s->space.item[first.number];
        int *stuck = &s->found[SUPREMUM_SWEEP].stuck;
        if (radius <= PROBED_SHARE * s->within)
            status = suprema_probe(stuck, s, first.number, c.centre);
        else
            status = band_cut(&done, &s->space, first.number);
        *stuck |= radius > PROBED_SHARE * s->within && !done;
        if (status)
            return status;
    }
    /* Where it was cut, others take its place. */
    return priority_add(&s->cubes, s->context, first.bound, first.number);
}

/* Those of the other searches may have cut the first cube, or settled it: others take its place. */
static graze_status finish_sweep(suprema *s) {
    graze_status status = GRAZE_OK;
    const cube *first = NULL;
    while (!status && s->cubes.count) {
        first = &s->space.item[s->cubes.item[0].number];
        if (first->kind == CUBE_BAND && !first->child)
            break;
        double bound = priority_take(&s->cubes).bound;
        if (first->child)
            status = add_below(s, first->child, bound);
    }
    supremum_finish(&s->found[SUPREMUM_SWEEP], s, &s->cubes, s->cubes.count ? first->centre : NULL);
    return status;
}

graze_status search_sweep_begin(suprema *s) {
    graze_status status = add_cube(s, 0, INFINITY);
    return status ? status : finish_sweep(s);
}

graze_status search_sweep_step(suprema *s) {
    graze_status status = finish_sweep(s);
    if (!status && s->cubes.count && !s->found[SUPREMUM_SWEEP].reached)
        status = look_at_cube(s);
    return status ? status : finish_sweep(s);
}
