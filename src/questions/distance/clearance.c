/* Cubes about a point in which all points have one membership: the largest is sought by the
 * exponent of its half width, then by eighths.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/distance/distance.h"

#include <math.h>
#include "base/number/rounding.h"
#include "decide/lattice/lattice.h"

/* Half widths of cubes are less than 2^SIZE_ABOVE times the size of the solid's box, and at least
 * 2^-SIZE_BELOW times. */
enum { SIZE_ABOVE = 5, SIZE_BELOW = 52 };

/* The half widths tried are a power of two plus multiples of 1 / SIZE_PARTS of that power. */
enum { SIZE_PARTS = 8 };

typedef struct cube_search {
    cell_asker ask;
    anchors near;
    point_box cube;
    double off; /* the point is at most this far from the centre in each coordinate */
    graze_pmc pmc;
    graze_status status;
} cube_search;

/* Set the centre to the point's coordinates, rounded down to doubles. */
static void centre_cube(cube_search *s, const fmpq *point) {
    s->off = 0;
    for (int k = 0; k < s->ask.scene->motion->dimension; k++) {
        double low, high;
        rational_bounds(&low, &high, point + k);
        s->cube.centre[k] = low;
        if (high > low)
            s->off = larger(s->off, nextafter(high - low, (double)INFINITY));
    }
}

/* A lower bound of the point's distance from the sides of the cube with a half width. */
static double radius_of(const cube_search *s, double half) {
    return s->off > 0 ? nextafter(half - s->off, 0) : half;
}

/* Is it proved that all points of the cube with a half width have the point's membership? */
static int has_one_pmc(cube_search *s, double half) {
    graze_pmc found = GRAZE_PMC_NONE;
    if (s->status || !(radius_of(s, half) > 0))
        return 0;
    for (int k = 0; k < s->ask.scene->motion->dimension; k++)
        s->cube.half[k] = half;
    s->status = context_poll(s->ask.context);
    if (!s->status)
        s->status = cell_certain(&found, &s->ask, &s->cube, &s->near);
    return !s->status && found == s->pmc;
}

/* The exponent of the size of the solid's box. */
static int exponent_of_solid(const graze_scene *scene) {
    const box *all = &scene->filter.solid->boxes.node[0].box;
    double size = 0;
    for (int k = 0; k < scene->motion->dimension; k++)
        size = larger(size, all->high[k] - all->low[k]);
    return size > 0 && isfinite(size) ? ilogb(size) : 0;
}

/* The largest radius found; `known` if none above it is found. */
static double search_radius(cube_search *s, double known) {
    int high = exponent_of_solid(s->ask.scene) + SIZE_ABOVE, low = high - SIZE_ABOVE - SIZE_BELOW;
    double best = 0;
    if (known > 0 && ilogb(known) >= low)
        low = ilogb(known); /* a cube of this size would tell nothing new */
    else if (has_one_pmc(s, ldexp(1, low)))
        best = ldexp(1, low);
    else
        return known;
    while (high - low > 1) {
        int middle = low + (high - low) / 2;
        if (has_one_pmc(s, ldexp(1, middle))) {
            low = middle;
            best = ldexp(1, middle);
        } else {
            high = middle;
        }
    }
    for (int step = SIZE_PARTS / 2, parts = SIZE_PARTS; step; step /= 2) {
        double half = ldexp((double)(parts + step) / SIZE_PARTS, low);
        if (half > known && has_one_pmc(s, half)) {
            parts += step;
            best = half;
        }
    }
    return best > 0 ? larger(known, radius_of(s, best)) : known;
}

graze_status distance_to_boundary(double *low, graze_context *context, const graze_scene *scene,
                                  const fmpq *point, graze_pmc pmc, const distance *found) {
    cube_search s = {.pmc = pmc};
    *low = pmc == GRAZE_OUT ? found->low : pmc == GRAZE_IN ? -found->high : 0;
    if (pmc != GRAZE_IN && pmc != GRAZE_OUT)
        return GRAZE_OK;
    s.status = filter_lay_bricks(&scene->filter, context);
    cell_asker_init(&s.ask, context, scene);
    centre_cube(&s, point);
    *low = search_radius(&s, larger(*low, 0));
    cell_asker_clear(&s.ask);
    return s.status;
}
