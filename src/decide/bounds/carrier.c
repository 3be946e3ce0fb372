/* Bernstein coefficients of a point map, exactly, then rounded.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "decide/bounds/bounds.h"

#include <math.h>
#include "base/context/scope.h"
#include "base/number/bernstein.h"

/* After this number of halvings, a part whose weight is still small leaves its piece without bound.
 */
enum { HALF_LEVELS = 10 };

static slong degree_of(const point_map *map) {
    slong degree = fmpz_poly_degree(map->weight);
    for (int k = 0; k < map->dimension * (map->dimension + 1); k++)
        if (fmpz_poly_degree(&map->entry[k]) > degree)
            degree = fmpz_poly_degree(&map->entry[k]);
    return degree < 1 ? 1 : degree;
}

/* c 2^-exponent; sets *fits to 0 if it is too large. A number that is too small becomes 0, and the
 * filter's floor covers that error. */
static double scale_coefficient(const fmpz_t c, slong exponent, int *fits) {
    slong e;
    double m = fmpz_get_d_2exp(&e, c);
    e -= exponent;
    if (fmpz_is_zero(c) || e < -1000)
        return 0;
    if (e > 199) {
        *fits = 0;
        return 0;
    }
    return ldexp(m, (int)e);
}

static void convert_map(carrier *out, const point_map *map, const dyadic_interval *part) {
    int entries = map->dimension * (map->dimension + 1);
    slong n = out->degree + 1;
    LOCAL_VEC(fmpz, c, n);
    bernstein_from_poly(c, map->weight, out->degree, part);
    /* the least e with |c| < 2^e for all coefficients of the weight */
    slong exponent = FLINT_ABS(_fmpz_vec_max_bits(c, n));
    for (int j = 0; j <= entries; j++) {
        bernstein_from_poly(c, j < entries ? &map->entry[j] : map->weight, out->degree, part);
        for (slong k = 0; k < n; k++)
            out->entry[j * n + k] = scale_coefficient(c + k, exponent, &out->usable);
    }
    out->weight = out->entry + entries * n;
}

int carrier_make_on(carrier *out, const point_map *map, const dyadic_interval *part) {
    slong degree = degree_of(map);
    *out = (carrier){.dimension = map->dimension};
    if (degree > CARRIER_DEGREE)
        return 1;
    size_t entries = (size_t)(map->dimension * (map->dimension + 1));
    out->degree = (int)degree;
    out->usable = 1;
    out->entry = malloc((entries + 1) * (size_t)(degree + 1) * sizeof *out->entry);
    if (!out->entry)
        return 0;
    convert_map(out, map, part);
    return 1;
}

static int has_small_weight(const carrier *c) {
    for (int k = 0; k <= c->degree; k++)
        if (!(c->weight[k] > CARRIER_LEAST_WEIGHT))
            return 1;
    return 0;
}

static int make_with_halves(carrier *out, const point_map *map, const dyadic_interval *part,
                            int levels) {
    if (!carrier_make_on(out, map, part))
        return 0;
    if (!levels || !out->usable || !has_small_weight(out))
        return 1;
    dyadic_interval halves[2];
    out->half = calloc(2, sizeof *out->half);
    dyadic_interval_init(&halves[0]);
    dyadic_interval_init(&halves[1]);
    dyadic_interval_halves(&halves[0], &halves[1], part);
    int made = out->half != NULL;
    for (int k = 0; k < 2 && made; k++)
        made = make_with_halves(&out->half[k], map, &halves[k], levels - 1);
    dyadic_interval_clear(&halves[0]);
    dyadic_interval_clear(&halves[1]);
    return made;
}

int carrier_make(carrier *out, const point_map *map) {
    return make_with_halves(out, map, &unit_interval, HALF_LEVELS);
}

void carrier_clear(carrier *c) {
    for (int k = 0; k < 2 && c->half; k++)
        carrier_clear(&c->half[k]);
    free(c->half);
    free(c->entry);
    *c = (carrier){.usable = 0};
}
