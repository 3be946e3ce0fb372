/* The greatest distances of the mesh to the sweep and to its complement, by branch and bound over
 * parts of the mesh. SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Both distances are 1-Lipschitz, so the distance of a part's reference point plus the part's
 * radius bounds the distances in the part.
 */
#include "questions/judge/cube.h"

#include <math.h>
#include "base/context/array.h"
#include "base/context/scope.h"
#include "questions/judge/open_search.h"

/* Shares of the width: the largest and the least half side of cubes that are preferred for cutting,
 * and the radius below which a part is not cut. */
static const double LARGE_SHARE = 0.5, SMALL_SHARE = 0x1p-8, STUCK_PART = 0x1p-9;

/* A part is not cut if its radius is at most this times the error of its reference point. */
static const double ROUNDED_PART = 8;

/* Points off a part, on both sides, are this share of the width away, then twice as far each time;
 * bound of their number. */
static const double STEP_SHARE = 0.125;
enum { STEPS = 6 };

/* Kinds of cubes that may have points outside the sweep. */
enum { NOT_INSIDE = CUBE_OUT | CUBE_BAND | CUBE_FLAT };

static void raise_low(supremum *of, double low, const double *at) {
    if (low > of->low) {
        of->low = low;
        memcpy(of->at, at, sizeof of->at);
    }
}

/* An upper bound of the distances of a part's points to the sweep: 0 if the reference point is so
 * deep inside that the whole part is in the sweep. */
static double outside_bound(suprema *s, const asked_part *a) {
    double low = 0, unused;
    if (a->known.pmc == GRAZE_OUT)
        return a->known.high + a->part.radius;
    if (a->known.pmc == GRAZE_IN)
        band_nearest(&low, &unused, &s->space, a->part.x, NOT_INSIDE, 0);
    return larger(a->part.radius - low, 0);
}

/* Does a triangle meet none but flat cubes, or cubes beside these, of the cubes below one? */
static int is_part_flat_below(const suprema *s, const mesh_part *part, const box *around,
                              uint32_t index) {
    const cube *c = &s->space.item[index];
    cube_span here;
    cube_span_set(&here, c, s->mesh);
    if ((c->kind == CUBE_FLAT && !c->child) || c->beside || !box_meets(around, &here.space) ||
        chord_meets(&here.shape, &here.all, part->corner, part->error) == CHORD_MISSES)
        return 1;
    int flat = c->child != 0;
    for (uint32_t k = 0; k < 8 && flat; k++)
        flat = is_part_flat_below(s, part, around, c->child + k);
    return flat;
}

/* Is a part proved to lie in the sweep's boundary? */
static int is_part_flat(const suprema *s, const mesh_part *part) {
    const cube *root = &s->space.item[0];
    int within = part->node == PART_OF_TRIANGLE && root->kind & CUBE_FLAT;
    box around;
    for (int i = 0; i < 3 && within; i++) {
        const double *v = part->corner + i;
        around.low[i] = smaller(v[0], smaller(v[3], v[6])) - part->error;
        around.high[i] = larger(v[0], larger(v[3], v[6])) + part->error;
        within = around.low[i] > root->centre[i] - root->half &&
                 around.high[i] < root->centre[i] + root->half;
    }
    return within && is_part_flat_below(s, part, &around, 0);
}

/* Is a part's reference point proved to? */
static int is_at_flat(const suprema *s, const mesh_part *part) {
    mesh_part point = *part;
    for (int k = 0; k < 9; k++)
        point.corner[k] = part->x[k % 3];
    point.node = PART_OF_TRIANGLE;
    return is_part_flat(s, &point);
}

/* An upper bound of the distances of a part's points to the sweep's complement. From the reference
 * point the distance to cubes outside is an upper bound; that to cubes not certainly inside is a
 * lower bound, which raises `low`. */
static double inside_bound(suprema *s, const asked_part *a) {
    double low, high, unused;
    if (a->known.pmc == GRAZE_OUT)
        return larger(a->part.radius - a->known.low, 0);
    band_nearest(&unused, &high, &s->space, a->part.x, CUBE_OUT | CUBE_FLAT, 0);
    high = smaller(high, a->out);
    if (a->known.pmc == GRAZE_IN) {
        band_nearest(&low, &unused, &s->space, a->part.x, NOT_INSIDE, 0);
        raise_low(&s->found[GRAZE_JUDGED_INSIDE], low - a->part.error, a->part.x);
    }
    if (high > a->part.error && is_at_flat(s, &a->part))
        high = a->part.error;
    return high + a->part.radius;
}

/* Append a part: ask its reference point, unless the part it is cut from has the same point. */
static graze_status take_mesh_part(suprema *s, const mesh_part *part, const asked_part *from) {
    TRY(ARRAY_GROW(s->context, s->part, s->part_capacity, s->part_count + 1, "parts of a mesh"));
    asked_part added = {.part = *part, .out = INFINITY};
    if (from && memcmp(from->part.x, part->x, sizeof part->x) == 0)
        added.known = from->known;
    else
        TRY(suprema_ask(&added.known, s, part->x, ASK_OUT));
    uint32_t number = (uint32_t)s->part_count;
    added.outside = smaller(outside_bound(s, &added), from ? from->outside : INFINITY);
    added.inside = smaller(inside_bound(s, &added), from ? from->inside : INFINITY);
    s->part[s->part_count++] = added;
    if (added.known.pmc == GRAZE_OUT)
        raise_low(&s->found[GRAZE_JUDGED_OUTSIDE], added.known.low - part->error, part->x);
    TRY(priority_add(&s->outer, s->context, added.outside, number));
    return priority_add(&s->inner, s->context, added.inside, number);
}

static graze_status cut_part(suprema *s, uint32_t number) {
    mesh_part halves[2];
    asked_part whole = s->part[number];
    s->part[number].is_cut = 1;
    mesh_part_cut(halves, s->mesh, &whole.part);
    for (int k = 0; k < 2; k++)
        TRY(take_mesh_part(s, &halves[k], &whole));
    return GRAZE_OK;
}

static int is_stuck(const suprema *s, const mesh_part *part) {
    return part->radius <= STUCK_PART * s->within || part->radius <= ROUNDED_PART * part->error ||
           s->part_count + 2 >= UINT32_MAX;
}

static graze_status look_outside(suprema *s) {
    waiting_part first = priority_take(&s->outer);
    asked_part *a = &s->part[first.number];
    a->is_cut = is_part_flat(s, &a->part);
    if (a->is_cut)
        return GRAZE_OK;
    if (!is_stuck(s, &a->part))
        return cut_part(s, first.number);
    s->found[GRAZE_JUDGED_OUTSIDE].stuck = 1;
    return priority_add(&s->outer, s->context, first.bound, first.number);
}

/* The cube of the band, or flat, that is nearest to a part's reference point and at most `most`
 * away. Large cubes are tried first, so that all cubes around the point shrink alike. */
static uint32_t nearest_large(suprema *s, const asked_part *a, double most) {
    double low, high;
    for (double share = LARGE_SHARE; share >= SMALL_SHARE; share *= 0.5) {
        uint32_t index = band_nearest(&low, &high, &s->space, a->part.x, NOT_INSIDE & ~CUBE_OUT,
                                      share * s->within);
        if (index != UINT32_MAX && low <= most)
            return index;
    }
    return UINT32_MAX;
}

/* Settle the cube, if no point around it is outside, or else cut it. Once cubes are small, the
 * nearest one is probed first: the point may be near a seam. */
static graze_status cut_nearest(suprema *s, uint32_t number, uint32_t index) {
    asked_part *a = &s->part[number];
    int *stuck = &s->found[GRAZE_JUDGED_INSIDE].stuck, done = 0;
    cube_sample around = {.has_out = 1};
    int open = index != UINT32_MAX && s->space.item[index].kind == CUBE_BAND;
    if (open && cube_radius(&s->space.item[index]) <= s->within)
        TRY(suprema_sample(&around, s, index));
    if (!around.has_out)
        TRY(suprema_settle(&done, s, index));
    if (!done && open && !a->is_probed &&
        cube_radius(&s->space.item[index]) <= PROBED_SHARE * s->within) {
        double low, high;
        uint32_t nearest = band_nearest(&low, &high, &s->space, a->part.x, CUBE_BAND, 0);
        a->is_probed = 1;
        return suprema_probe(stuck, s, nearest, a->part.x);
    }
    if (!done && index != UINT32_MAX)
        TRY(band_cut(&done, &s->space, index));
    *stuck |= !done;
    return GRAZE_OK;
}

/* The share of a part's bound that comes from undecided space around its reference point. */
static double open_space(suprema *s, const asked_part *a, double bound) {
    double low = 0, unused;
    if (a->known.pmc == GRAZE_OUT)
        return 0;
    band_nearest(&low, &unused, &s->space, a->part.x, NOT_INSIDE, 0);
    return bound - a->part.radius - low;
}

/* Ask about the next point off a part, along its triangle's normal. A point that is outside bounds
 * the distance of the reference point to the outside. */
static graze_status step_off(suprema *s, asked_part *a) {
    double step = ldexp(STEP_SHARE * s->within, a->steps / 2) * (a->steps % 2 ? -1 : 1), y[3];
    normal n;
    known_point known;
    normal_space(&n, s->mesh->corners.at + (size_t)a->part.simplex * 9, 0);
    double length = sqrt(dot3(n.at, n.at));
    a->steps++;
    if (!(length > 0))
        return GRAZE_OK;
    for (int i = 0; i < 3; i++)
        y[i] = a->part.x[i] + step / length * n.at[i];
    TRY(suprema_ask(&known, s, y, ASK_NO_DISTANCE));
    if (known.pmc == GRAZE_OUT)
        a->out = distance_above(a->part.x, y);
    return GRAZE_OK;
}

/* Cut the part with the greatest bound or the space around it, whichever contributes more. */
static graze_status look_inside(suprema *s) {
    uint32_t number = priority_take(&s->inner).number;
    asked_part a = s->part[number];
    s->part[number].is_cut = is_part_flat(s, &a.part);
    if (s->part[number].is_cut)
        return GRAZE_OK;
    double bound = smaller(inside_bound(s, &a), a.inside);
    uint32_t nearest = bound >= a.inside ? nearest_large(s, &a, bound - a.part.radius) : UINT32_MAX;
    if (bound >= a.inside && !is_stuck(s, &a.part) &&
        (nearest == UINT32_MAX || open_space(s, &a, bound) < a.part.radius))
        return cut_part(s, number);
    if (bound >= a.inside && a.out == INFINITY && a.steps < STEPS && a.known.pmc != GRAZE_OUT) {
        TRY(step_off(s, &s->part[number]));
        a = s->part[number];
    } else if (bound >= a.inside) {
        TRY(cut_nearest(s, number, nearest));
    }
    bound = smaller(inside_bound(s, &a), bound);
    s->part[number].inside = bound;
    return priority_add(&s->inner, s->context, bound, number);
}

/* Drop parts that were cut for the other search, whose halves wait; then set both results. */
static void finish_mesh(suprema *s) {
    priority *waits[2] = {&s->outer, &s->inner};
    supremum *found[2] = {&s->found[GRAZE_JUDGED_OUTSIDE], &s->found[GRAZE_JUDGED_INSIDE]};
    for (int k = 0; k < 2; k++) {
        while (waits[k]->count && s->part[waits[k]->item[0].number].is_cut)
            (void)priority_take(waits[k]);
        const double *open = waits[k]->count ? s->part[waits[k]->item[0].number].part.x : NULL;
        supremum_finish(found[k], s, waits[k], open);
    }
}

graze_status search_mesh_begin(suprema *s) {
    mesh_part whole;
    mesh_part_of_node(&whole, s->mesh, 0);
    TRY(take_mesh_part(s, &whole, NULL));
    finish_mesh(s);
    return GRAZE_OK;
}

graze_status search_outside_step(suprema *s) {
    TRY(look_outside(s));
    finish_mesh(s);
    return GRAZE_OK;
}

graze_status search_inside_step(suprema *s) {
    TRY(look_inside(s));
    finish_mesh(s);
    return GRAZE_OK;
}
