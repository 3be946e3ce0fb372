/* Where tangent planes meet, verified by exact classification.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The two planes that differ most are intersected exactly and, in E^3, with a third one: the plane
 * farthest from containing the direction of the line of the first two. The common point is only a
 * guess: it is taken if it is on and a point next to it is out; else a pair of points near it, one
 * out and one not, is looked for by bisection along the sum of the normals.
 */
#include "questions/boundary/sampling.h"

#include <math.h>
#include "base/context/scope.h"
#include "base/number/vector.h"

/* Two unit normals of a feature have an inner product below EDGE_COSINE; a third one has at least
 * the sine CORNER_SINE against the plane of these two. */
#define EDGE_COSINE 0.95
#define CORNER_SINE 0.3

typedef struct selection {
    const tangent *plane[3];
    int count; /* number of planes: d or, for an edge of E^3, 2; 0: no feature */
} selection;

int feature_between(const tangent *a, const tangent *b) {
    return a->known && b->known && dot3(a->unit, b->unit) < EDGE_COSINE;
}

static void select_pair(selection *s, const tangent *const *list, size_t count) {
    double least = EDGE_COSINE;
    for (size_t i = 0; i < count; i++)
        for (size_t j = 0; j < i; j++) {
            if (!list[i]->known || !list[j]->known || dot3(list[i]->unit, list[j]->unit) >= least)
                continue;
            least = dot3(list[i]->unit, list[j]->unit);
            s->plane[0] = list[j];
            s->plane[1] = list[i];
            s->count = 2;
        }
}

static void select_third(selection *s, const tangent *const *list, size_t count) {
    double axis[3], most = CORNER_SINE;
    const double *a = s->plane[0]->unit, *b = s->plane[1]->unit;
    cross3(axis, a, b);
    double length = sqrt(dot3(axis, axis));
    for (size_t i = 0; i < count; i++) {
        double sine = fabs(dot3(axis, list[i]->unit)) / length;
        if (!list[i]->known || !(sine > most))
            continue;
        most = sine;
        s->plane[2] = list[i];
        s->count = 3;
    }
}

/* Set a row of the linear system: normal . x = value. */
static void put_row(fmpq_mat_t a, fmpq_mat_t right, int row, const fmpq *normal,
                    const fmpq_t value) {
    vector_set(fmpq_mat_entry(a, row, 0), normal, (int)fmpq_mat_ncols(a));
    fmpq_set(fmpq_mat_entry(right, row, 0), value);
}

/* Find the common point of the planes; for two planes in E^3 the point of their line that is
 * nearest to the reference. */
static int meet_planes(fmpq *out, const selection *s, int d, const fmpq *reference) {
    LOCAL_VEC(fmpq, along, 3);
    LOCAL(fmpq, value);
    LOCAL(fmpq_mat, a, d, d);
    LOCAL(fmpq_mat, right, d, 1);
    LOCAL(fmpq_mat, x, d, 1);
    for (int row = 0; row < s->count; row++) {
        fmpq_neg(value, s->plane[row]->form + d);
        put_row(a, right, row, s->plane[row]->form, value);
    }
    if (s->count < d) {
        vector_cross(along, s->plane[0]->form, s->plane[1]->form);
        _fmpq_vec_dot(value, along, reference, d);
        put_row(a, right, 2, along, value);
    }
    int solved = fmpq_mat_solve(x, a, right);
    if (solved)
        vector_set(out, fmpq_mat_entry(x, 0, 0), d);
    return solved;
}

/* Set `way` to a direction given in doubles, scaled to the length of one cell along the axis on
 * which it is longest, measured in cells. */
static void outward(fmpq *way, const struct graze_boundary *b, const double *direction) {
    enum { UNIT = 1024 };
    LOCAL_VEC(fmpq, share, 4);
    fmpq *most = share + 3;
    for (int k = 0; k < b->dimension; k++) {
        fmpq_set_si(way + k, lround(direction[k] * UNIT), UNIT);
        fmpq_div(share + k, way + k, b->side + k);
    }
    (void)vector_widest(most, share, b->dimension);
    fmpq_mul_2exp(most, most, b->reached);
    for (int k = 0; k < b->dimension && !fmpq_is_zero(most); k++)
        fmpq_div(way + k, way + k, most);
}

/* Set the feature's points to base + share way. */
static void set_points(feature *out, int d, const fmpq *base, const fmpq *way, const fmpq_t inside,
                       const fmpq_t outside) {
    for (int k = 0; k < d; k++) {
        fmpq_mul(out->inside + k, way + k, inside);
        fmpq_add(out->inside + k, out->inside + k, base + k);
        fmpq_mul(out->outside + k, way + k, outside);
        fmpq_add(out->outside + k, out->outside + k, base + k);
    }
}

/* Confirm a base that is on: look for a point that is out, 2^-BISECT_BITS of a cell away from it
 * along the sum of the normals or along one of them. */
static graze_status confirm_on(feature *out, asker *a, const selection *s, const fmpq *base,
                               fmpq *way) {
    const struct graze_boundary *b = a->boundary;
    graze_pmc pmc = GRAZE_PMC_NONE;
    LOCAL_VEC(fmpq, zero, 2);
    fmpq *gap = zero + 1;
    fmpq_one(gap);
    fmpq_div_2exp(gap, gap, BISECT_BITS);
    for (int k = 0; k <= s->count && pmc != GRAZE_OUT; k++) {
        if (k > 0)
            outward(way, b, s->plane[k - 1]->unit);
        set_points(out, b->dimension, base, way, zero, gap);
        TRY(asker_pmc(&pmc, a, out->outside));
    }
    out->pmc = pmc == GRAZE_OUT ? GRAZE_ON : GRAZE_PMC_NONE;
    return GRAZE_OK;
}

/* Bisect between the base and a point beside it along `way`, 2^-13, then 2^-8, then 2^-4 of a cell
 * away. */
static graze_status bisect_from(feature *out, asker *a, graze_pmc pmc, const fmpq *base,
                                const fmpq *way) {
    const struct graze_boundary *b = a->boundary;
    static const unsigned reach[] = {13, 8, 4};
    LOCAL_VEC(fmpq, low, 2);
    fmpq *high = low + 1;
    out->pmc = GRAZE_PMC_NONE;
    for (size_t k = 0; k < sizeof reach / sizeof *reach && !out->pmc; k++) {
        fmpq *far = pmc == GRAZE_OUT ? low : high, *near = pmc == GRAZE_OUT ? high : low;
        fmpq_zero(near);
        fmpq_set_si(far, pmc == GRAZE_OUT ? -1 : 1, 1);
        fmpq_div_2exp(far, far, reach[k]);
        TRY(probe_line(low, high, &out->pmc, a, base, way, BISECT_BITS));
    }
    if (out->pmc)
        set_points(out, b->dimension, base, way, low, high);
    return GRAZE_OK;
}

static graze_status verify(feature *out, asker *a, const selection *s, const fmpq *base) {
    const struct graze_boundary *b = a->boundary;
    double sum[3] = {0, 0, 0};
    LOCAL_VEC(fmpq, way, b->dimension);
    graze_pmc pmc;
    for (int k = 0; k < s->count; k++)
        for (int i = 0; i < b->dimension; i++)
            sum[i] += s->plane[k]->unit[i];
    outward(way, b, sum);
    TRY(asker_pmc(&pmc, a, base));
    return pmc == GRAZE_ON ? confirm_on(out, a, s, base, way) : bisect_from(out, a, pmc, base, way);
}

static graze_status try_selection(feature *out, int *found, asker *a, const sample_cell *c,
                                  const selection *s, const fmpq *reference) {
    const struct graze_boundary *b = a->boundary;
    LOCAL_VEC(fmpq, base, b->dimension);
    out->pmc = GRAZE_PMC_NONE;
    if (meet_planes(base, s, b->dimension, reference) && probe_in_cell(b, c, base))
        TRY(verify(out, a, s, base));
    *found = out->pmc && probe_in_cell(b, c, out->inside) && probe_in_cell(b, c, out->outside);
    return GRAZE_OK;
}

graze_status feature_find(feature *out, int *found, asker *a, const sample_cell *c,
                          const tangent *const *list, size_t count, const fmpq *reference) {
    const struct graze_boundary *b = a->boundary;
    selection s = {.count = 0};
    *found = 0;
    select_pair(&s, list, count);
    if (s.count && b->dimension == 3)
        select_third(&s, list, count);
    for (; s.count >= 2 && !*found; s.count--)
        TRY(try_selection(out, found, a, c, &s, reference));
    return GRAZE_OK;
}

void feature_init(feature *f) {
    f->outside = _fmpq_vec_init(6);
    f->inside = f->outside + 3;
}

void feature_clear(feature *f) {
    _fmpq_vec_clear(f->outside, 6);
}
