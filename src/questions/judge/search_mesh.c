/* The greatest distances of the mesh to the sweep and to its complement: parts of the mesh, the one
 * first that can hold the greatest. SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Both distances change by no more than the way from a point to the next, so that of a part's point
 * bounds them in the part.
 */
#include "questions/judge/search_mesh.h"

#include <math.h>
#include <string.h>
#include "base/context/array.h"
#include "decide/filter/chord.h"
#include "decide/filter/normal.h"
#include "questions/judge/flat_cube.h"

/* Half sides of cubes that are cut, as shares of the width. Parts of less than the last are stuck.
 */
static const double LARGE_SHARE = 0.5, SMALL_SHARE = 0x1p-8, STUCK_PART = 0x1p-9;

/* Of those so small beside the error of their point most is rounding: they are stuck too. */
static const double ROUNDED_PART = 8;

/* Cubes that are perhaps not in the sweep. */
enum { NOT_INSIDE = CUBE_OUT | CUBE_BAND | CUBE_FLAT };

static void raise_low(supremum *of, double low, const double *at) {
    if (low > of->low) {
        of->low = low;
        memcpy(of->at, at, sizeof of->at);
    }
}

/* Where a part's point is so far inside that all of the part is, nothing of it is outside. */
static double outside_bound(suprema *s, const asked_part *a) {
    double low = 0, unused;
    if (a->known.pmc == GRAZE_OUT)
        return a->known.high + a->part.radius;
    if (a->known.pmc == GRAZE_IN)
        band_nearest(&low, &unused, &s->space, a->part.x, NOT_INSIDE, 0);
    return larger(a->part.radius - low, 0);
}

/* Whether a triangle meets flat cubes alone, of those below one. */
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

/* Whether a part is of the boundary. */
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

/* Whether a part's point is. */
static int is_at_flat(const suprema *s, const mesh_part *part) {
    mesh_part point = *part;
    for (int k = 0; k < 9; k++)
        point.corner[k] = part->x[k % 3];
    point.node = PART_OF_TRIANGLE;
    return is_part_flat(s, &point);
}

/* The distance from a part's point to the complement of the sweep: to what is certainly outside at
 * most, to what is not certainly inside at least. */
static double inside_bound(suprema *s, const asked_part *a) {
    double low, high, unused;
    if (a->known.pmc == GRAZE_OUT)
        return larger(a->part.radius - a->known.low, 0);
    band_nearest(&unused, &high, &s->space, a->part.x, CUBE_OUT | CUBE_FLAT, 0);
    if (a->known.pmc == GRAZE_IN) {
        band_nearest(&low, &unused, &s->space, a->part.x, NOT_INSIDE, 0);
        raise_low(&s->found[GRAZE_JUDGED_INSIDE], low - a->part.error, a->part.x);
    }
    if (high > a->part.error && is_at_flat(s, &a->part))
        high = a->part.error;
    return high + a->part.radius;
}

/* Take a part up: ask its point, unless that of the part it is from is the same. */
static graze_status take_mesh_part(suprema *s, const mesh_part *part, const asked_part *from) {
    graze_status status = array_grow(s->context, &s->part, &s->part_capacity, s->part_count + 1,
                                     sizeof *s->part, "parts of a mesh");
    asked_part added = {.part = *part};
    if (status)
        return status;
    if (from && memcmp(from->part.x, part->x, sizeof part->x) == 0)
        added.known = from->known;
    else
        status = suprema_ask(&added.known, s, part->x, ASK_OUT);
    uint32_t number = (uint32_t)s->part_count;
    if (status)
        return status;
    added.outside = smaller(outside_bound(s, &added), from ? from->outside : INFINITY);
    added.inside = smaller(inside_bound(s, &added), from ? from->inside : INFINITY);
    s->part[s->part_count++] = added;
    if (added.known.pmc == GRAZE_OUT)
        raise_low(&s->found[GRAZE_JUDGED_OUTSIDE], added.known.low - part->error, part->x);
    status = priority_add(&s->outer, s->context, added.outside, number);
    return status ? status : priority_add(&s->inner, s->context, added.inside, number);
}

static graze_status cut_part(suprema *s, uint32_t number) {
    mesh_part halves[2];
    asked_part whole = s->part[number];
    graze_status status = GRAZE_OK;
    s->part[number].is_cut = 1;
    mesh_part_cut(halves, s->mesh, &whole.part);
    for (int k = 0; k < 2 && !status; k++)
        status = take_mesh_part(s, &halves[k], &whole);
    return status;
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

/* The cube of the band, or flat, nearest to a part's point, no further than `most`, of those that
 * are largest but for some powers of two: so all around it shrinks alike. */
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

/* Cut it, unless nothing around it is outside and it is settled; once cubes are small, see first
 * whether the nearest of all is perhaps in a seam. */
static graze_status cut_nearest(suprema *s, uint32_t number, uint32_t index) {
    asked_part *a = &s->part[number];
    int *stuck = &s->found[GRAZE_JUDGED_INSIDE].stuck, done = 0;
    cube_sample around = {.has_out = 1};
    graze_status status = GRAZE_OK;
    int open = index != UINT32_MAX && s->space.item[index].kind == CUBE_BAND;
    if (open && cube_radius(&s->space.item[index]) <= s->within)
        status = suprema_sample(&around, s, index);
    if (!status && !around.has_out)
        status = suprema_settle(&done, s, index);
    if (!status && !done && open && !a->is_probed &&
        cube_radius(&s->space.item[index]) <= PROBED_SHARE * s->within) {
        double low, high;
        uint32_t nearest = band_nearest(&low, &high, &s->space, a->part.x, CUBE_BAND, 0);
        a->is_probed = 1;
        return suprema_probe(stuck, s, nearest, a->part.x);
    }
    if (!status && !done && index != UINT32_MAX)
        status = band_cut(&done, &s->space, index);
    *stuck |= !status && !done;
    return status;
}

/* How much of a part's bound is the space around its point. */
static double open_space(suprema *s, const asked_part *a, double bound) {
    double low = 0, unused;
    if (a->known.pmc == GRAZE_OUT)
        return 0;
    band_nearest(&low, &unused, &s->space, a->part.x, NOT_INSIDE, 0);
    return bound - a->part.radius - low;
}

/* The part may be cut, or the space around it, whichever leaves more open. */
static graze_status look_inside(suprema *s) {
    uint32_t number = priority_take(&s->inner).number;
    asked_part a = s->part[number];
    s->part[number].is_cut = is_part_flat(s, &a.part);
    if (s->part[number].is_cut)
        return GRAZE_OK;
    double bound = smaller(inside_bound(s, &a), a.inside);
    graze_status status = GRAZE_OK;
    uint32_t nearest = bound >= a.inside ? nearest_large(s, &a, bound - a.part.radius) : UINT32_MAX;
    if (bound >= a.inside && !is_stuck(s, &a.part) &&
        (nearest == UINT32_MAX || open_space(s, &a, bound) < a.part.radius))
        return cut_part(s, number);
    if (bound >= a.inside)
        status = cut_nearest(s, number, nearest);
    bound = smaller(inside_bound(s, &a), bound);
    s->part[number].inside = bound;
    return status ? status : priority_add(&s->inner, s->context, bound, number);
}

/* Parts that were cut for the other search have left their place to others. */
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
    graze_status status = take_mesh_part(s, &whole, NULL);
    finish_mesh(s);
    return status;
}

graze_status search_outside_step(suprema *s) {
    graze_status status = look_outside(s);
    finish_mesh(s);
    return status;
}

graze_status search_inside_step(suprema *s) {
    graze_status status = look_inside(s);
    finish_mesh(s);
    return status;
}
