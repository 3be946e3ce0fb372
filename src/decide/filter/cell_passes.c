/* Parts of the time are halved until, for each simplex near a part, the velocity of the cell's
 * points across it has one certain sign, and simplices of opposite signs have no place in common
 * near the cell.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "decide/filter/search.h"

/* Bounds: the level to which parts of the time are cut, the number of simplices near one part, and
 * the number of nodes visited for a cell. */
enum { PASS_LEVELS = 20, PASS_NEAR = 64, PASS_VISITS = 30000 };

/* The level of a span that is one time of a piece. */
enum { INSTANT = WINDOW_LEVELS + 1 };

/* A part whose curve is shorter than this share of the points' spread is not cut. */
static const double LEAST_LENGTH = 0.25;

/* As LEAST_LENGTH once a contact is not certain, when only a facet that crosses the whole cell is
 * still looked for: that needs longer parts. */
static const double LEAST_PIERCING = 1;

/* As LEAST_LENGTH while a slab's normal is sought: it need not be exact. */
static const double LEAST_FOR_NORMAL = 4;

/* A simplex, at a leaf, near a part of the time; and on which side of the times of contacts with it
 * the trajectories of the cell's points are inside. */
typedef struct near_simplex {
    uint32_t node, simplex;
    int pierced;     /* the simplex crosses the whole cell: all trajectories go through it */
    unsigned inside; /* bits of side_of_contact */
} near_simplex;

typedef struct near_simplices {
    int count, overflow; /* overflow is 1 if more simplices are near than there is room for */
    near_simplex item[PASS_NEAR];
} near_simplices;

/* On which sides of the time of a contact a trajectory is certainly inside; for an unsweep, inside
 * the complement. */
enum side_of_contact { INSIDE_BEFORE = 1, INSIDE_AFTER = 2 };

typedef struct passing {
    curve *curve;
    const filter *filter;
    const point_box *points;
    const cell_walls *walls; /* or NULL */
    const graze_motion *motion;
    int failed, pierced, visits;
    int last;        /* the part is not cut any more, so that a slab must take what is open in it */
    uint32_t sloped; /* 1 + the piece that `slope` belongs to; 0: none */
    double slope[3]; /* bound of a point's velocity minus the centre's */
} passing;

/* Set `slope` for a piece: bounds of the difference between the steps, from one control coefficient
 * to the next, of a point of the cell and of the centre. */
static void find_slope(passing *p, uint32_t piece) {
    const carrier *map = &p->curve->course->piece[piece];
    int d = map->dimension, n = map->degree;
    if (p->sloped == piece + 1)
        return;
    p->sloped = piece + 1;
    for (int i = 0; i < d; i++) {
        double sum = 0;
        for (int j = 0; j < d; j++) {
            const double *x = map->entry + (i * (d + 1) + j) * (n + 1);
            double step = 0, size = fabs(x[0]);
            for (int k = 0; k < n; k++) {
                step = larger(step, fabs(x[k + 1] - x[k]));
                size = larger(size, fabs(x[k + 1]));
            }
            sum += (step + 0x1p-50 * size + FILTER_FLOOR) * p->points->half[j];
        }
        p->slope[i] = FILTER_SLACK * sum + FILTER_FLOOR;
    }
}

/* The side of the times of contacts with a simplex on which the cell's points are inside, by the
 * steps between the control coefficients `first` to `last` of a part; 0 if it is not certain. */
static unsigned sides_of_contact(passing *p, const span *part, uint32_t simplex, int first,
                                 int last) {
    const corners *corners = &p->filter->solid->corners;
    int d = p->curve->dimension;
    const double *v = corners->at + (size_t)simplex * (size_t)(d * d);
    shift_bound shift = curve_shift(p->curve, part);
    normal n;
    double size = 0, spread = 0, share = ldexp(1, -part->level);
    unsigned sides = INSIDE_BEFORE | INSIDE_AFTER;
    normal_of(&n, v, corners->error, d);
    find_slope(p, part->piece);
    for (int i = 0; i < d; i++) {
        size += fabs(n.at[i]);
        spread += (fabs(n.at[i]) + n.error) * p->slope[i] * share;
    }
    double bound =
        FILTER_SLACK * (spread + size * (2 * shift.error + 32 * UNIT_ROUNDING * shift.size) +
                        6 * n.error * (shift.size + shift.error)) +
        FILTER_FLOOR;
    const double *w = curve_coefficients(p->curve, part, d);
    for (int k = first; k < last && sides; k++) {
        double speed = 0;
        for (int i = 0; i < d; i++) {
            const double *x = curve_coefficients(p->curve, part, i);
            speed += n.at[i] * (x[k + 1] - x[k] - v[i] * (w[k + 1] - w[k]));
        }
        sides &= speed > bound ? INSIDE_BEFORE : speed < -bound ? INSIDE_AFTER : 0u;
    }
    if (!sides)
        return 0;
    sides ^= p->filter->proves == GRAZE_STATE_I ? 0u : INSIDE_BEFORE | INSIDE_AFTER;
    return flip(FLIP_SPEED, sides == INSIDE_AFTER) ? INSIDE_AFTER : INSIDE_BEFORE;
}

static void take_near_simplex(near_simplices *list, uint32_t node, uint32_t simplex, int pierced) {
    if (list->count == PASS_NEAR)
        list->overflow = 1;
    else
        list->item[list->count++] =
            (near_simplex){.node = node, .simplex = simplex, .pierced = pierced};
}

static int is_slabbed(const passing *p) {
    return p->walls && p->walls->slab;
}

/* Is there a slab without a normal yet? */
static int seeks_normal(const passing *p) {
    return is_slabbed(p) && !(p->walls->slab->reach > 0);
}

/* Do the cell's walls keep corners of a simplex away in a part of a piece, or at its start? Or does
 * the slab take them? */
static int are_held_out(const passing *p, const span *part, uint32_t simplex, unsigned mask) {
    int instant = part->level == INSTANT;
    if (!p->walls || !(part->degree || instant))
        return 0;
    if (is_slabbed(p))
        return cell_slab_takes(p->walls->slab, p->curve, part,
                               instant   ? PART_INSTANT
                               : p->last ? PART_LAST
                                         : PART_CUT,
                               simplex, mask);
    return walls_hold_out(p->walls, p->motion, p->filter->solid, part, simplex, mask);
}

/* Add the simplices below a node that a thick span may meet. */
static void find_near(near_simplices *out, passing *p, uint32_t node, const span *wide) {
    static const double none[3] = {0, 0, 0};
    const corners *corners = &p->filter->solid->corners;
    size_t d = (size_t)p->curve->dimension;
    while (!out->overflow) {
        const tree_node *here = &p->filter->solid->boxes.node[node];
        p->visits++;
        if (flip(FLIP_CELL, !span_meets(wide, &here->box)) ||
            point_box_misses_slab(p->filter, wide, here, none))
            return;
        if (!here->child) {
            chord_meeting found = chord_meets(
                p->curve, wide, corners->at + (size_t)here->simplex * d * d, corners->error);
            if (found != CHORD_MISSES &&
                (is_slabbed(p) || !are_held_out(p, wide, here->simplex, 7)))
                take_near_simplex(out, node, here->simplex,
                                  flip(FLIP_PIERCE, found == CHORD_PIERCES));
            return;
        }
        find_near(out, p, here->child, wide);
        node = here->child + 1;
    }
}

/* Is the side of each near simplex certain, and equal for any two that have a place in common?
 * Points beside a slab have no contact with what it takes. */
static int contacts_are_certain(const passing *p, near_simplices *near, const span *wide) {
    unsigned shared;
    for (int k = 0; k < near->count; k++) {
        if (!near->item[k].inside && is_slabbed(p) &&
            are_held_out(p, wide, near->item[k].simplex, 7))
            near->item[k].inside = INSIDE_BEFORE | INSIDE_AFTER;
        if (!near->item[k].inside)
            return 0;
        for (int l = 0; l < k; l++)
            if (!(near->item[k].inside & near->item[l].inside) &&
                common_place_is_near(p->filter->solid, wide, near->item[k].simplex,
                                     near->item[l].simplex) &&
                !(common_corners(&shared, p->filter->solid, near->item[k].simplex,
                                 near->item[l].simplex) &&
                  are_held_out(p, wide, near->item[l].simplex, shared)))
                return 0;
    }
    return 1;
}

/* Does a near simplex with no other one in its relative interior cross the whole cell? */
static int one_is_pierced(const passing *p, const near_simplices *near) {
    int found = 0;
    for (int k = 0; k < near->count && !near->overflow && !found; k++) {
        found = near->item[k].pierced;
        for (int l = 0; l < near->count && found; l++)
            found = l == k || !may_rest_inside(p->filter->solid, near->item[k].simplex,
                                               near->item[l].simplex);
    }
    return found;
}

static void pass_part(passing *p, uint32_t index, const near_simplices *around);

static void pass_halves(passing *p, uint32_t index, const near_simplices *around) {
    if (!curve_cut(p->curve, index)) {
        p->failed = 1;
        return;
    }
    uint32_t child = p->curve->spans[index].child;
    for (uint32_t half = child; half < child + 2; half++)
        pass_part(p, half, around);
}

/* Decide a part of one piece with simplices near it, or its halves. */
static void pass_near(passing *p, uint32_t index, near_simplices *near, const span *wide,
                      const double *spread) {
    const span *part = &p->curve->spans[index];
    double most = larger(spread[0], larger(spread[1], spread[2]));
    for (int k = 0; k < near->count && !near->overflow && !p->failed; k++)
        near->item[k].inside = sides_of_contact(p, part, near->item[k].simplex, 0, part->degree);
    if (!p->failed && !near->overflow && contacts_are_certain(p, near, wide))
        return;
    double least = p->failed ? LEAST_PIERCING : seeks_normal(p) ? LEAST_FOR_NORMAL : LEAST_LENGTH;
    if (part->level < PASS_LEVELS && largest3(part->along) + part->bend > least * most) {
        pass_halves(p, index, near->overflow ? NULL : near);
        return;
    }
    p->last = 1;
    p->failed |= !is_slabbed(p) || near->overflow || !contacts_are_certain(p, near, wide);
    p->last = 0;
}

/* Decide a part of the time; `around`: the simplices near a longer part, or NULL. */
static void pass_part(passing *p, uint32_t index, const near_simplices *around) {
    const span *part = &p->curve->spans[index];
    double spread[3];
    near_simplices near = {.count = 0};
    if (p->pierced || p->visits >= PASS_VISITS || (p->failed && is_slabbed(p)))
        return;
    if (part->lost || (part->degree && !point_box_spread(spread, p->curve, p->points, part))) {
        p->failed = 1;
        return;
    }
    if (!part->bounded || !point_box_spread(spread, p->curve, p->points, part)) {
        if (part->level < PASS_LEVELS)
            pass_halves(p, index, around);
        else
            p->failed = 1;
        return;
    }
    span wide = point_box_widen(part, spread);
    for (int k = 0; around && k < around->count; k++)
        find_near(&near, p, around->item[k].node, &wide);
    if (!around)
        find_near(&near, p, 0, &wide);
    if (part->degree && one_is_pierced(p, &near))
        p->pierced = 1;
    else if (near.count && !part->degree)
        pass_halves(p, index, near.overflow ? NULL : &near);
    else if (near.count)
        pass_near(p, index, &near, &wide, spread);
}

/* Are contacts at a time between two pieces, or at an end of the motion, certain? The piece before
 * that time decides whether points are inside before it, the next piece whether they are inside
 * after it. */
static int joint_is_certain(passing *p, size_t joint) {
    size_t pieces = p->curve->course->piece_count;
    piece_time when = joint ? (piece_time){(uint32_t)(joint - 1), 1} : (piece_time){0, 0};
    near_simplices near = {.count = 0};
    box around;
    span wide;
    if (!point_box_places(&around, p->curve, p->filter, &when, p->points->half))
        return 0;
    span_of_box(&wide, p->curve, &around);
    wide.piece = when.piece;
    wide.start = joint ? WINDOW_WHOLE : 0;
    wide.level = INSTANT;
    find_near(&near, p, 0, &wide);
    if (near.overflow)
        return 0;
    for (int k = 0; k < near.count; k++) {
        near_simplex *n = &near.item[k];
        const span *before = joint ? curve_piece(p->curve, joint - 1) : NULL;
        if (before && before->degree)
            n->inside |=
                sides_of_contact(p, before, n->simplex, before->degree - 1, before->degree) &
                INSIDE_BEFORE;
        const span *after = joint < pieces ? curve_piece(p->curve, joint) : NULL;
        if (after && after->degree)
            n->inside |= sides_of_contact(p, after, n->simplex, 0, 1) & INSIDE_AFTER;
    }
    return contacts_are_certain(p, &near, &wide);
}

cell_passage cell_passes(curve *memory, const filter *f, const point_box *points,
                         const cell_walls *walls, const graze_motion *motion) {
    passing p = {.curve = memory, .filter = f, .points = points, .walls = walls, .motion = motion};
    pass_part(&p, 0, NULL);
    if (p.pierced)
        return CELL_PIERCED;
    for (size_t k = 0; k <= memory->course->piece_count && !p.failed; k++)
        p.failed |= !joint_is_certain(&p, k);
    return p.failed || p.visits >= PASS_VISITS || memory->out_of_memory ? CELL_DOUBTFUL
                                                                        : CELL_PASSES;
}
