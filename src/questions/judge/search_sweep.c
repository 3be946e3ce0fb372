/* The greatest distance of the sweep's boundary to the mesh: cubes of the band, the one first in
 * which it can be greatest. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/judge/search_sweep.h"

#include <string.h>
#include "decide/filter/normal.h"

/* Points that bracket the boundary are sought around cubes of at most this share of the width that
 * is wanted, or of what is open, and brought together to this share of the width or the cube. */
static const double BRACKET_CUBE = 0.75, OPEN_CUBE = 0.0625, BRACKET_LENGTH = 0.0625;

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
    if (low > s->found[GRAZE_JUDGED_SWEEP].low) {
        s->found[GRAZE_JUDGED_SWEEP].low = low;
        memcpy(s->found[GRAZE_JUDGED_SWEEP].at, point, sizeof s->found[GRAZE_JUDGED_SWEEP].at);
    }
}

/* Between a point in the sweep and one outside it is a place of the boundary. */
static graze_status take_bracket(suprema *s, const cube_sample *ends, double length) {
    double a[3], b[3], middle[3];
    graze_status status = GRAZE_OK;
    memcpy(a, ends->in, sizeof a);
    memcpy(b, ends->out, sizeof b);
    while (!status && distance_above(a, b) > length) {
        known_point known;
        for (int i = 0; i < 3; i++)
            middle[i] = 0.5 * (a[i] + b[i]);
        if (memcmp(middle, a, sizeof a) == 0 || memcmp(middle, b, sizeof b) == 0)
            break; /* doubles hold none between */
        status = suprema_ask(&known, s, middle, ASK_NO_DISTANCE);
        if (!status)
            memcpy(known.pmc == GRAZE_OUT ? b : a, middle, sizeof a);
    }
    if (!status)
        take_low(s, b, distance_above(a, b));
    return status;
}

/* Where all is out, the place of the sweep that is nearest to the centre is of its boundary; if it
 * is far, the cube holds none. */
static graze_status take_nearest(int *done, suprema *s, uint32_t index) {
    const cube c = s->space.item[index];
    known_point known;
    graze_status status = suprema_ask(&known, s, c.centre, ASK_OUT);
    *done = !status && known.low > cube_radius(&c);
    if (*done)
        band_settle(&s->space, index, CUBE_OUT);
    if (!status)
        take_low(s, c.centre, known.high);
    return status;
}

/* What points of a small cube and around it tell.
 * @param[out] done   the cube is settled
 * @param[out] hidden all of them are in */
static graze_status ask_around_cube(int *done, int *hidden, suprema *s, uint32_t index) {
    cube_sample around;
    double radius = cube_radius(&s->space.item[index]);
    graze_status status = suprema_sample(&around, s, index);
    *hidden = !around.has_out;
    if (status)
        return status;
    if (around.has_in && around.has_out)
        return take_bracket(s, &around, BRACKET_LENGTH * larger(s->within, radius));
    return around.has_in ? suprema_settle(done, s, index) : take_nearest(done, s, index);
}

/* The eight cubes of one that was cut. */
static graze_status add_below(suprema *s, uint32_t child, double most) {
    graze_status status = GRAZE_OK;
    for (uint32_t k = child; !status && k < child + 8; k++)
        if (s->space.item[k].kind & CUBE_BAND)
            status = add_cube(s, k, most);
    return status;
}

/* Take up the cube with the greatest bound; where it was cut, others take its place. */
static graze_status look_at_cube(suprema *s) {
    waiting_part first = priority_take(&s->cubes);
    const cube c = s->space.item[first.number];
    supremum *found = &s->found[GRAZE_JUDGED_SWEEP];
    int done = 0, hidden = 0;
    graze_status status = GRAZE_OK;
    if (cube_radius(&c) <= BRACKET_CUBE * s->within ||
        cube_radius(&c) <= OPEN_CUBE * (first.bound - found->low))
        status = ask_around_cube(&done, &hidden, s, first.number);
    if (status || done)
        return status;
    if (first.bound - found->low > s->within) {
        if (hidden && cube_radius(&c) <= PROBED_SHARE * s->within) {
            status = suprema_probe(&found->stuck, s, first.number, c.centre);
        } else {
            status = band_cut(&done, &s->space, first.number);
            found->stuck = !done;
        }
    }
    return status ? status : priority_add(&s->cubes, s->context, first.bound, first.number);
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
    supremum_finish(&s->found[GRAZE_JUDGED_SWEEP], s, &s->cubes,
                    s->cubes.count ? first->centre : NULL);
    return status;
}

graze_status search_sweep_begin(suprema *s) {
    graze_status status = add_cube(s, 0, INFINITY);
    return status ? status : finish_sweep(s);
}

graze_status search_sweep_step(suprema *s) {
    graze_status status = finish_sweep(s);
    if (!status && s->cubes.count && !s->found[GRAZE_JUDGED_SWEEP].reached)
        status = look_at_cube(s);
    return status ? status : finish_sweep(s);
}
