/* The greatest distance of the sweep's boundary to the mesh, by branch and bound over cubes of the
 * band. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/judge/cube.h"

#include "base/context/scope.h"
#include "questions/judge/open_search.h"

/* Two points that bracket the boundary are sought around cubes with a radius of at most
 * BRACKET_CUBE of the width wanted, or OPEN_CUBE of the width open. They are bisected to
 * BRACKET_LENGTH of the width wanted or of the radius. */
static const double BRACKET_CUBE = 0.75, OPEN_CUBE = 0.0625, BRACKET_LENGTH = 0.0625;

/* Queue a cube with an upper bound of the distances to the mesh from the boundary's places in it,
 * or with the bound `most` of a cube that contains it. */
static graze_status add_cube(suprema *s, uint32_t index, double most) {
    const cube *c = &s->space.item[index];
    mesh_gap gap = mesh_gap_of(s->mesh, c->centre);
    double around = gap.high + cube_radius(c);
    double bound = smaller(around, mesh_gap_of_cube(s->mesh, gap.simplex, c->centre, c->half));
    return priority_add(&s->cubes, s->context, smaller(bound, most), index);
}

/* Raise `low` by a point that is at most `off` away from a place of the boundary. */
static void take_low(suprema *s, const double *point, double off) {
    double low = mesh_gap_of(s->mesh, point).low - off;
    if (low > s->found[GRAZE_JUDGED_SWEEP].low) {
        s->found[GRAZE_JUDGED_SWEEP].low = low;
        memcpy(s->found[GRAZE_JUDGED_SWEEP].at, point, sizeof s->found[GRAZE_JUDGED_SWEEP].at);
    }
}

/* Raise `low` by a place of the boundary between a point in the sweep and one outside. */
static graze_status take_bracket(suprema *s, const cube_sample *ends, double length) {
    double a[3], b[3], middle[3];
    memcpy(a, ends->in, sizeof a);
    memcpy(b, ends->out, sizeof b);
    while (distance_above(a, b) > length) {
        known_point known;
        for (int i = 0; i < 3; i++)
            middle[i] = 0.5 * (a[i] + b[i]);
        if (memcmp(middle, a, sizeof a) == 0 || memcmp(middle, b, sizeof b) == 0)
            break; /* doubles hold none between */
        TRY(suprema_ask(&known, s, middle, ASK_NO_DISTANCE));
        memcpy(known.pmc == GRAZE_OUT ? b : a, middle, sizeof a);
    }
    take_low(s, b, distance_above(a, b));
    return GRAZE_OK;
}

/* For a cube with no sample in the sweep: the sweep's place nearest to the centre is on the
 * boundary and raises `low`; if it is outside the ball around the cube, the cube is out. */
static graze_status take_nearest(int *done, suprema *s, uint32_t index) {
    const cube c = s->space.item[index];
    known_point known;
    TRY(suprema_ask(&known, s, c.centre, ASK_OUT));
    *done = known.low > cube_radius(&c);
    if (*done)
        band_settle(&s->space, index, CUBE_OUT);
    take_low(s, c.centre, known.high);
    return GRAZE_OK;
}

/* Ask the samples of a small cube, and use what they show.
 * @param[out] done   the cube is settled
 * @param[out] hidden 1: all samples are in the sweep */
static graze_status ask_around_cube(int *done, int *hidden, suprema *s, uint32_t index) {
    cube_sample around;
    double radius = cube_radius(&s->space.item[index]);
    TRY(suprema_sample(&around, s, index));
    *hidden = !around.has_out;
    if (around.has_in && around.has_out)
        return take_bracket(s, &around, BRACKET_LENGTH * larger(s->within, radius));
    return around.has_in ? suprema_settle(done, s, index) : take_nearest(done, s, index);
}

/* Process the cube with the greatest bound: sample it if it is small; else, or in vain, cut it or
 * probe it. */
static graze_status look_at_cube(suprema *s) {
    waiting_part first = priority_take(&s->cubes);
    const cube c = s->space.item[first.number];
    supremum *found = &s->found[GRAZE_JUDGED_SWEEP];
    int done = 0, hidden = 0;
    if (cube_radius(&c) <= BRACKET_CUBE * s->within ||
        cube_radius(&c) <= OPEN_CUBE * (first.bound - found->low))
        TRY(ask_around_cube(&done, &hidden, s, first.number));
    if (done)
        return GRAZE_OK;
    if (first.bound - found->low > s->within) {
        if (hidden && cube_radius(&c) <= PROBED_SHARE * s->within) {
            TRY(suprema_probe(&found->stuck, s, first.number, c.centre));
        } else {
            TRY(band_cut(&done, &s->space, first.number));
            found->stuck = !done;
        }
    }
    return priority_add(&s->cubes, s->context, first.bound, first.number);
}

/* Bring the queue up to date: other searches may have cut or settled its first cube. Then set the
 * result. */
static graze_status finish_sweep(suprema *s) {
    const cube *first = NULL;
    while (s->cubes.count) {
        first = &s->space.item[s->cubes.item[0].number];
        if (first->kind == CUBE_BAND && !first->child)
            break;
        double bound = priority_take(&s->cubes).bound;
        for (uint32_t k = first->child; first->child && k < first->child + 8; k++)
            if (s->space.item[k].kind & CUBE_BAND)
                TRY(add_cube(s, k, bound));
    }
    supremum_finish(&s->found[GRAZE_JUDGED_SWEEP], s, &s->cubes,
                    s->cubes.count ? first->centre : NULL);
    return GRAZE_OK;
}

graze_status search_sweep_begin(suprema *s) {
    TRY(add_cube(s, 0, INFINITY));
    return finish_sweep(s);
}

graze_status search_sweep_step(suprema *s) {
    TRY(finish_sweep(s));
    if (s->cubes.count && !s->found[GRAZE_JUDGED_SWEEP].reached)
        TRY(look_at_cube(s));
    return finish_sweep(s);
}
