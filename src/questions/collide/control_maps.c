/* Control maps from Bernstein coefficients. SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/context/scope.h"
#include "questions/collide/placing.h"

static int form_count(int d) {
    return d * (d + 1) + 1;
}

void map_forms_init(map_forms *out, const point_map *map, const dyadic_interval *interval) {
    int n = form_count(map->dimension);
    out->dimension = map->dimension;
    out->degree = fmpz_poly_degree(map->weight);
    for (int k = 0; k + 1 < n; k++)
        out->degree = FLINT_MAX(out->degree, fmpz_poly_degree(&map->entry[k]));
    for (int k = 0; k + 1 < n; k++)
        bernstein_form_init(&out->form[k], &map->entry[k], out->degree, interval);
    bernstein_form_init(&out->form[n - 1], map->weight, out->degree, interval);
}

void map_forms_clear(map_forms *forms) {
    for (int k = 0; k < form_count(forms->dimension); k++)
        bernstein_form_clear(&forms->form[k]);
}

void map_forms_split(map_forms *forms, map_forms *right) {
    right->dimension = forms->dimension;
    right->degree = forms->degree;
    for (int k = 0; k < form_count(forms->dimension); k++)
        bernstein_form_split(&forms->form[k], &right->form[k]);
}

/* Allocate the entries and, behind them, the scratch memory. */
static int make_map_room(control_maps *out, size_t count, int d) {
    size_t entries = count * (size_t)(d * (d + 1));
    double *grown = realloc(out->entry, (entries + 9 * count) * sizeof *grown);
    if (!grown)
        return 0;
    out->dimension = d;
    out->entry = grown;
    out->room = grown + entries;
    out->count = count;
    return 1;
}

static void measure_maps(control_maps *maps) {
    int d = maps->dimension;
    maps->shift = maps->slope = 0;
    for (size_t k = 0; k < maps->count; k++)
        for (int i = 0; i < d; i++) {
            const double *row = maps->entry + k * (size_t)(d * (d + 1)) + i * (d + 1);
            double sum = 0;
            for (int j = 0; j < d; j++)
                sum += fabs(row[j]);
            maps->slope = larger(sum, maps->slope);
            maps->shift = larger(fabs(row[d]), maps->shift);
        }
}

/* x / w for w > 0, with a relative error of at most 2^-48. */
static double quotient(const fmpz_t x, const fmpz_t w) {
    slong ex, ew;
    double m = fmpz_get_d_2exp(&ex, x) / fmpz_get_d_2exp(&ew, w);
    slong e = ex - ew;
    return m == 0 ? 0 : e > 1000 ? HUGE_VAL * m : e < -1000 ? 0 : ldexp(m, (int)e);
}

int control_maps_set(control_maps *out, const map_forms *forms) {
    int d = forms->dimension, n = form_count(d) - 1;
    if (!make_map_room(out, (size_t)forms->degree + 1, d))
        return 0;
    LOCAL_VEC(fmpz, x, 2);
    fmpz *w = x + 1;
    for (slong j = 0; j <= forms->degree; j++) {
        wide_get_fmpz(w, &forms->form[n].c, j);
        if (fmpz_sgn(w) <= 0)
            out->count = 0;
        for (int k = 0; k < n && out->count; k++) {
            wide_get_fmpz(x, &forms->form[k].c, j);
            out->entry[j * n + k] = quotient(x, w);
        }
    }
    measure_maps(out);
    return 1;
}

void control_maps_clear(control_maps *maps) {
    free(maps->entry);
    *maps = (control_maps){0};
}

void control_maps_bound(box *out, const control_maps *maps, const box *of) {
    int d = maps->dimension;
    for (int i = 0; i < 3; i++) {
        out->low[i] = i < d ? (maps->count ? INFINITY : -INFINITY) : 0;
        out->high[i] = -out->low[i];
    }
    for (size_t k = 0; k < maps->count; k++) {
        box image;
        box_image(&image, maps->entry + k * (size_t)(d * (d + 1)), d, of);
        for (int i = 0; i < d; i++) {
            if (!(image.low[i] <= image.high[i])) { /* past the range of doubles */
                image.low[i] = -INFINITY;
                image.high[i] = INFINITY;
            }
            out->low[i] = image.low[i] < out->low[i] ? image.low[i] : out->low[i];
            out->high[i] = image.high[i] > out->high[i] ? image.high[i] : out->high[i];
        }
    }
}
