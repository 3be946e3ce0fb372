/* A cube is classified as a cell of a grid is (decide/lattice/lattice.h), then tested for being
 * flat. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/judge/cube.h"

#include <math.h>
#include "base/context/array.h"
#include "base/context/scope.h"
#include "base/number/rounding.h"

/* The relative rounding error of a computed distance is less than 2^-48. */
static const double ROUND_UP = 1 + 0x1p-48, ROUND_DOWN = 1 - 0x1p-48;

/* The test for flat cubes is given up once more than ROUGH_MOST cubes are in the band and the flat
 * ones are less than 1 / FLAT_SHARE of these. */
enum { ROUGH_MOST = 1000, FLAT_SHARE = 16 };

/* The root's half side has few bits, and its centre few more, so that cubes below are exact. */
enum { ROOT_BITS = 8 };

static void choose_root(cube *root, const double *low, const double *high) {
    double half = 0;
    int exponent;
    for (int k = 0; k < 3; k++)
        half = fmax(half, 0.5 * (high[k] - low[k]));
    (void)frexp(half * (1 + 0x1p-6), &exponent);
    double unit = ldexp(1, exponent - ROOT_BITS);
    root->half = (ceil(half * (1 + 0x1p-6) / unit) + 1) * unit;
    for (int k = 0; k < 3; k++)
        root->centre[k] = rint((0.5 * low[k] + 0.5 * high[k]) / unit) * unit;
}

graze_status band_init(band *b, graze_context *context, const graze_scene *scene) {
    double low[3], high[3], unused;
    *b = (band){.count = 1};
    cell_asker_init(&b->ask, context, scene);
    b->ask.corners = 1;
    TRY(ARRAY_GROW(context, b->item, b->capacity, 1, "cubes of space"));
    LOCAL_VEC(fmpq, box_low, 6);
    fmpq *box_high = box_low + 3;
    b->item[0] = (cube){.kind = CUBE_BAND};
    TRY(scene_box(box_low, box_high, context, scene));
    for (int k = 0; k < 3; k++) {
        rational_bounds(&low[k], &unused, box_low + k);
        rational_bounds(&unused, &high[k], box_high + k);
    }
    choose_root(&b->item[0], low, high);
    const cube *root = &b->item[0];
    for (int k = 0; k < 3; k++)
        if (!(fabs(root->centre[k]) + root->half <= CARRIER_REACH &&
              fabs(root->centre[k]) <= 0x1p30 * root->half))
            return context_fail(context, GRAZE_ELIMIT,
                                "the sweep is 2^30 times as far from the origin as it is large, "
                                "or beyond 2^200: doubles do not cut it into cubes");
    return GRAZE_OK;
}

void band_clear(band *b) {
    free(b->item);
    cell_asker_clear(&b->ask);
}

static graze_status decide_cube(cell_asker *ask, const judged_mesh *mesh, int flat, cube *c) {
    point_box points = {.half = {c->half, c->half, c->half}};
    anchors near = {.count = 0};
    graze_pmc pmc;
    if (flat)
        return flat_child(c, ask->context, mesh);
    memcpy(points.centre, c->centre, sizeof c->centre);
    TRY(cell_certain(&pmc, ask, &points, &near));
    c->kind = pmc == GRAZE_IN ? CUBE_IN : pmc == GRAZE_OUT ? CUBE_OUT : CUBE_BAND;
    if (mesh && c->kind == CUBE_BAND)
        TRY(flat_decide(c, ask, mesh));
    return GRAZE_OK;
}

/* Set the kind of a cut cube, and of those that contain it, to the kinds of the cubes below. */
static void tell_parents(band *b, uint32_t index) {
    for (;;) {
        unsigned char below = 0;
        for (int k = 0; k < 8; k++)
            below |= b->item[b->item[index].child + (uint32_t)k].kind;
        int same = below == b->item[index].kind;
        b->item[index].kind = below;
        if (same || index == 0)
            return;
        index = b->item[index].parent;
    }
}

void band_settle(band *b, uint32_t index, unsigned char kind) {
    b->item[index].kind = kind;
    if (index)
        tell_parents(b, b->item[index].parent);
}

int band_can_cut(const band *b, const cube *c) {
    double quarter = 0.5 * c->half;
    for (int k = 0; k < 3; k++)
        if (c->centre[k] + quarter - c->centre[k] != quarter ||
            c->centre[k] - quarter - c->centre[k] != -quarter)
            return 0;
    return c->level < CUBE_LEVELS && b->count + 8 < UINT32_MAX;
}

cube cube_part(const cube *whole, int k) {
    cube c = {.half = 0.5 * whole->half, .level = whole->level + 1};
    for (int i = 0; i < 3; i++)
        c.centre[i] = whole->centre[i] + (k >> i & 1 ? c.half : -c.half);
    return c;
}

graze_status band_parts(cube part[8], const band *b, cell_asker *ask, uint32_t index) {
    int flat = b->item[index].kind == CUBE_FLAT;
    TRY(context_poll(ask->context));
    for (int k = 0; k < 8; k++) {
        part[k] = cube_part(&b->item[index], k);
        part[k].parent = index;
        TRY(decide_cube(ask, flat || !b->gave_up ? b->mesh : NULL, flat, &part[k]));
    }
    return GRAZE_OK;
}

graze_status band_take_parts(band *b, const cube part[8]) {
    uint32_t index = part[0].parent;
    TRY(ARRAY_GROW(b->ask.context, b->item, b->capacity, b->count + 8, "cubes of space"));
    memcpy(b->item + b->count, part, 8 * sizeof *part);
    b->decided += 8;
    b->item[index].child = (uint32_t)b->count;
    b->count += 8;
    for (int k = 0; k < 8; k++) {
        b->flat += part[k].kind == CUBE_FLAT || part[k].beside;
        b->rough += part[k].kind == CUBE_BAND;
    }
    if (b->rough > ROUGH_MOST && FLAT_SHARE * b->flat < b->rough)
        b->gave_up = 1; /* the boundary is curved, or is not the mesh */
    tell_parents(b, index);
    return GRAZE_OK;
}

graze_status band_cut(int *done, band *b, uint32_t index) {
    cube part[8];
    *done = band_can_cut(b, &b->item[index]);
    if (!*done)
        return GRAZE_OK;
    TRY(band_parts(part, b, &b->ask, index));
    return band_take_parts(b, part);
}

/* Is a point in the closed cube? The corners are exact. */
static int holds_point(const cube *c, const double *point) {
    for (int i = 0; i < 3; i++)
        if (!(point[i] >= c->centre[i] - c->half && point[i] <= c->centre[i] + c->half))
            return 0;
    return 1;
}

graze_pmc band_membership(const band *b, const double *point) {
    const cube *c = &b->item[0];
    if (!holds_point(c, point))
        return GRAZE_OUT;
    while (c->child) {
        uint32_t part = 0;
        for (int i = 0; i < 3; i++)
            part |= (uint32_t)(point[i] > c->centre[i]) << i;
        c = &b->item[c->child + part];
    }
    return c->kind == CUBE_IN ? GRAZE_IN : c->kind == CUBE_OUT ? GRAZE_OUT : GRAZE_PMC_NONE;
}

/* The squared distance from a point to a cube, with rounding errors. */
static double square_to_cube(const cube *c, const double *point) {
    double sum = 0;
    for (int i = 0; i < 3; i++) {
        double off = fabs(point[i] - c->centre[i]) - c->half;
        if (off > 0)
            sum += off * off;
    }
    return sum;
}

typedef struct nearest_cube {
    band *b;
    const double *point;
    int kinds;
    double least, square;
    uint32_t found;
} nearest_cube;

static void search_cubes(nearest_cube *s, uint32_t index) {
    const cube *c = &s->b->item[index];
    double square = square_to_cube(c, s->point);
    s->b->seen++;
    if (!(c->kind & s->kinds) || !(square < s->square) || c->half < s->least)
        return;
    if (!c->child) {
        double all = sqrt(square) + 2 * cube_radius(c);
        if (c->kind == CUBE_FLAT && !(s->kinds & CUBE_BAND))
            square = all * all;
        if (square < s->square) {
            s->square = square;
            s->found = index;
        }
        return;
    }
    /* Search the child that holds the point, or is nearest to it, first. */
    uint32_t first = 0;
    for (int i = 0; i < 3; i++)
        first |= (uint32_t)(s->point[i] > c->centre[i]) << i;
    uint32_t child = c->child;
    for (uint32_t k = 0; k < 8; k++)
        search_cubes(s, child + (first ^ k));
}

uint32_t band_nearest(double *low, double *high, band *b, const double *point, int kinds,
                      double least) {
    nearest_cube s = {b, point, kinds, least, INFINITY, UINT32_MAX};
    const cube *root = &b->item[0];
    if (kinds & CUBE_OUT) {
        double off = INFINITY;
        for (int i = 0; i < 3; i++)
            off = fmin(off, root->half - fabs(point[i] - root->centre[i]));
        s.square = off > 0 ? off * off : 0;
    }
    search_cubes(&s, 0);
    *low = s.square == INFINITY ? 0 : sqrt(s.square) * ROUND_DOWN;
    *high = sqrt(s.square) * ROUND_UP;
    /* The rounding errors of differences are relative to the coordinates. */
    double blur = 0x1p-50 * (root->half + fabs(root->centre[0]) + fabs(root->centre[1]) +
                             fabs(root->centre[2]));
    *low = fmax(*low - blur, 0);
    *high += blur;
    return s.found;
}
