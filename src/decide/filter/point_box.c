/* Spans of the centre's trajectory, made so thick that they hold those of all points of a box,
 * against the solid's tree.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <math.h>
#include "decide/filter/search.h"

/* The deepest levels to which spans are cut: against boxes, and against a simplex. */
enum { CELL_BOX_LEVELS = 16, CELL_LEVELS = 8 };

/* Bound of the simplices that are tested between a cell and an anchor. */
enum { JOIN_TESTS = 64 };

/* Bound of the times at which the places of a cell are looked up in the bricks. */
enum { CELL_TIMES = 16 };

/* A span is cut for one simplex where it strays from its chord by more than this share of the
 * points' spread. */
static const double LEAST_BEND = 0.25;

/* Entries of a carrier below this have been rounded to 0. */
static const double LOST_ENTRY = 0x1p-1000;

typedef struct cell_search {
    curve *curve;
    const filter *filter;
    const point_box *points;
    int meets; /* a point of the cell may meet the boundary */
} cell_search;

/* How far the trajectory of a point of the cell can be from the centre's, in all of one piece; 0 if
 * there is no bound. */
static int spread_over_piece(double spread[3], const carrier *map, const double *half) {
    int d = map->dimension, n = map->degree;
    double second[3];
    if (!map->usable)
        return 0;
    if (map->half) {
        if (!spread_over_piece(spread, &map->half[0], half) ||
            !spread_over_piece(second, &map->half[1], half))
            return 0;
        for (int i = 0; i < d; i++)
            spread[i] = larger(spread[i], second[i]);
        return 1;
    }
    for (int i = 0; i < d; i++) {
        double most = 0;
        for (int k = 0; k <= n; k++) {
            double sum = 0;
            for (int j = 0; j < d; j++)
                sum += (fabs(map->entry[(i * (d + 1) + j) * (n + 1) + k]) + LOST_ENTRY) * half[j];
            if (!(map->weight[k] > CARRIER_LEAST_WEIGHT))
                return 0;
            most = larger(most, sum / map->weight[k]);
        }
        spread[i] = FILTER_SLACK * most + FILTER_FLOOR;
    }
    return 1;
}

/* The spread over a group of pieces; for a group without bound it is set to 0 and not used, since
 * the group is cut. */
static void spread_over_group(double spread[3], const piece_group *g, int d, const double *half) {
    for (int i = 0; i < d; i++) {
        double sum = 0;
        for (int j = 0; j < d; j++) {
            int e = i * (d + 1) + j;
            sum += (larger(fabs(g->first[e]), fabs(g->last[e])) + g->off[e]) * half[j];
        }
        spread[i] = g->bounded ? FILTER_SLACK * sum + FILTER_FLOOR : 0;
    }
}

int point_box_spread(double spread[3], const curve *memory, const point_box *points,
                     const span *part) {
    const course *course = memory->course;
    spread[2] = 0;
    if (part->lost)
        return 0;
    if (part->degree)
        return spread_over_piece(spread, &course->piece[part->piece], points->half);
    spread_over_group(spread, &course->group[part->group], course->dimension, points->half);
    return 1;
}

static void descend_cell(cell_search *s, uint32_t node, uint32_t index, const double *spread);

/* Cut a span and descend with both halves. The halves of a group have spreads of their own. */
static void cut_cell(cell_search *s, uint32_t node, uint32_t index, const double *spread) {
    int several = !s->curve->spans[index].degree;
    if (!curve_cut(s->curve, index)) {
        s->meets = 1;
        return;
    }
    uint32_t child = s->curve->spans[index].child;
    for (uint32_t half = child; half < child + 2 && !s->meets; half++) {
        double own[3];
        if (several && !point_box_spread(own, s->curve, s->points, &s->curve->spans[half]))
            s->meets = 1;
        else
            descend_cell(s, node, half, several ? own : spread);
    }
}

span point_box_widen(const span *part, const double *spread) {
    span wide = *part;
    for (int i = 0; i < 3; i++) {
        wide.thick[i] += spread[i];
        wide.wide[i] += spread[i];
    }
    wide.far += larger(spread[0], larger(spread[1], spread[2]));
    return wide;
}

/* Test the simplex of a leaf against a span widened by the spread. */
static void meet_cell(cell_search *s, uint32_t node, uint32_t index, const double *spread) {
    const corners *corners = &s->filter->solid->corners;
    size_t d = (size_t)s->curve->dimension, simplex = s->filter->solid->boxes.node[node].simplex;
    span wide = point_box_widen(&s->curve->spans[index], spread);
    double most = larger(spread[0], larger(spread[1], spread[2]));
    chord_meeting found =
        chord_meets(s->curve, &wide, corners->at + simplex * d * d, corners->error);
    if (flip(FLIP_CELL, found == CHORD_MISSES))
        return;
    if (!wide.degree || (wide.bend > LEAST_BEND * most && wide.level < CELL_LEVELS))
        cut_cell(s, node, index, spread);
    else
        s->meets = 1;
}

box box_around(const box *b, const double *spread) {
    box out = *b;
    for (int i = 0; i < 3; i++) {
        out.low[i] -= spread[i];
        out.high[i] += spread[i];
    }
    return out;
}

int point_box_misses_slab(const filter *f, const span *part, const tree_node *node,
                          const double *spread) {
    double wide[3];
    if (!node->child || !part->bounded)
        return 0;
    for (int i = 0; i < 3; i++)
        wide[i] = part->wide[i] + spread[i];
    return !chord_meets_slab(part, wide, slab_below(&f->solid->slabs, node));
}

static void descend_cell(cell_search *s, uint32_t node, uint32_t index, const double *spread) {
    while (!s->meets) {
        const span *piece = &s->curve->spans[index];
        const tree_node *here = &s->filter->solid->boxes.node[node];
        box around = box_around(&here->box, spread);
        if (flip(FLIP_CELL, !span_meets(piece, &around)) ||
            point_box_misses_slab(s->filter, piece, here, spread))
            return;
        int thick = here->child && span_is_thick(s->curve, piece, &around);
        if ((thick || !piece->bounded) && piece->level < CELL_BOX_LEVELS) {
            cut_cell(s, node, index, spread);
            return;
        }
        if (!piece->bounded) {
            s->meets = 1;
        } else if (!here->child) {
            meet_cell(s, node, index, spread);
            return;
        } else {
            descend_cell(s, here->child, index, spread);
            node = here->child + 1;
        }
    }
}

int point_box_begin(curve *memory, const filter *f, const point_box *points) {
    filter_point centre;
    for (int i = 0; i < 3; i++) {
        if (!(points->half[i] <= CARRIER_REACH))
            return 0;
        centre.at[i] = points->centre[i];
    }
    return f->solid->corners.at && curve_set(memory, &f->course, &centre, &f->solid->corners);
}

int point_box_places(box *out, curve *memory, const filter *f, const piece_time *when,
                     const double *half) {
    double place[4], off[4], spread[3] = {0, 0, 0};
    const span *whole = curve_piece(memory, when->piece);
    if (!whole || whole->lost)
        return 0;
    curve_at(place, off, memory, whole, when->at);
    if (!place_bound(out, place, off, f->solid->input.dimension) ||
        (half && !spread_over_piece(spread, &f->course.piece[when->piece], half)))
        return 0;
    *out = box_around(out, spread);
    return 1;
}

int point_box_is_settled(curve *memory, const filter *f, const point_box *points, size_t *hint) {
    size_t pieces = f->course.piece_count, each = pieces < CELL_TIMES ? CELL_TIMES / pieces : 1;
    size_t step = pieces * each / CELL_TIMES + 1;
    const interior *bricks = filter_bricks(f);
    if (!bricks || !bricks->state)
        return 0;
    for (size_t k = 0; k < pieces * each; k += step) {
        size_t time = (*hint + k) % (pieces * each);
        piece_time when = {(uint32_t)(time / each), ((double)(time % each) + 0.5) / (double)each};
        box around;
        if (point_box_places(&around, memory, f, &when, points->half) &&
            flip(FLIP_INTERIOR, interior_state(bricks, &around) == f->proves)) {
            *hint = time;
            return 1;
        }
    }
    return 0;
}

int point_box_joins(curve *memory, const filter *f, const point_box *points, const anchor *to) {
    size_t tests = JOIN_TESTS;
    box all;
    if (!point_box_places(&all, memory, f, &to->when, points->half))
        return 0;
    for (int i = 0; i < 3; i++) {
        all.low[i] = smaller(all.low[i], to->around.low[i]);
        all.high[i] = larger(all.high[i], to->around.high[i]);
    }
    return flip(FLIP_JOIN, box_is_empty(f->solid, &all, &tests));
}

int point_box_is_clear(curve *memory, const filter *f, const point_box *points) {
    cell_search s = {memory, f, points, 0};
    double spread[3];
    if (!point_box_spread(spread, memory, points, &memory->spans[0]))
        return 0;
    descend_cell(&s, 0, 0, spread);
    return !s.meets && !memory->out_of_memory;
}
