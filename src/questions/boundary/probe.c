/* Bisection along lines of any direction.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A boundary point was found along one axis. From places 2^-7 of a cell beside it along the other
 * axes, further boundary points are looked for within 2^-5 of a cell. The normal of the plane
 * through all these points is near that of the boundary if the boundary is smooth there; results
 * built on it are verified.
 */
#include "questions/boundary/sampling.h"

#include "base/context/scope.h"
#include "base/number/vector.h"

enum { BESIDE = 7, WITHIN = 5, PLACES = 21 };

int probe_in_cell(const struct graze_boundary *b, const sample_cell *c, const fmpq *point) {
    int inside = 1;
    LOCAL(fmpq, at);
    for (int k = 0; k < b->dimension && inside; k++) {
        fmpq_sub(at, point + k, b->low + k);
        fmpq_div(at, at, b->side + k);
        fmpq_mul_2exp(at, at, c->level);
        inside = fmpq_cmp_ui(at, c->at[k]) > 0 && fmpq_cmp_ui(at, c->at[k] + 1ul) < 0;
    }
    return inside;
}

/* Classify the point base + share way. */
static graze_status ask_on_line(graze_pmc *out, asker *a, const fmpq *base, const fmpq *way,
                                const fmpq_t share) {
    for (int k = 0; k < a->boundary->dimension; k++) {
        fmpq_set(a->point + k, base + k);
        fmpq_addmul(a->point + k, way + k, share);
    }
    return asker_pmc(out, a, a->point);
}

graze_status probe_line(fmpq_t low, fmpq_t high, graze_pmc *pmc, asker *a, const fmpq *base,
                        const fmpq *way, unsigned bits) {
    graze_pmc first, answer;
    *pmc = GRAZE_PMC_NONE;
    TRY(ask_on_line(&first, a, base, way, low));
    if (first == GRAZE_OUT)
        return GRAZE_OK;
    TRY(ask_on_line(&answer, a, base, way, high));
    if (answer != GRAZE_OUT)
        return GRAZE_OK;
    *pmc = first;
    LOCAL_VEC(fmpq, width, 3);
    fmpq *gap = width + 1, *middle = width + 2;
    fmpq_one(gap);
    fmpq_div_2exp(gap, gap, bits);
    for (fmpq_sub(width, high, low); fmpq_cmp(width, gap) > 0; fmpq_div_2exp(width, width, 1)) {
        vector_middle(middle, low, high, 1);
        TRY(ask_on_line(&answer, a, base, way, middle));
        if (answer == GRAZE_OUT) {
            fmpq_set(high, middle);
        } else {
            fmpq_set(low, middle);
            *pmc = answer;
        }
    }
    return GRAZE_OK;
}

/* Set `way` to 2^-bits of a cell along an axis, upward or downward. */
static void axis_step(fmpq *way, const struct graze_boundary *b, int axis, unsigned bits,
                      int down) {
    for (int k = 0; k < b->dimension; k++)
        fmpq_zero(way + k);
    fmpq_div_2exp(way + axis, b->side + axis, b->reached + bits);
    if (down)
        fmpq_neg(way + axis, way + axis);
}

/* Find the vector from `inside` to a boundary point beside it along an axis; *found becomes 0 if
 * there is none. */
static graze_status find_beside(fmpq *out, int *found, asker *a, const fmpq *inside,
                                const fmpq *way, int axis) {
    const struct graze_boundary *b = a->boundary;
    int d = b->dimension;
    LOCAL_VEC(fmpq, base, d);
    LOCAL_VEC(fmpq, low, 2);
    fmpq *high = low + 1;
    graze_pmc pmc = GRAZE_PMC_NONE;
    fmpq_set_si(low, -1, 1);
    fmpq_one(high);
    axis_step(out, b, axis, BESIDE, 0);
    vector_add(base, inside, out, d);
    TRY(probe_line(low, high, &pmc, a, base, way, PLACES - WITHIN));
    for (int k = 0; k < d; k++)
        fmpq_addmul(out + k, way + k, low);
    *found = pmc != GRAZE_PMC_NONE;
    return GRAZE_OK;
}

graze_status probe_normal(fmpq *out, int *found, asker *a, const fmpq *outside,
                          const fmpq *inside) {
    const struct graze_boundary *b = a->boundary;
    int d = b->dimension;
    LOCAL_VEC(fmpq, room, 13);
    fmpq *way = room, *beside = room + 3, *share = room + 9;
    vector_sub(way, outside, inside, d);
    for (int k = 0; k < d; k++)
        fmpq_div(share + k, way + k, b->side + k);
    int axis = vector_widest(share + 3, share, d); /* along which `way` has the most cells */
    axis_step(way, b, axis, WITHIN, fmpq_sgn(way + axis) < 0);
    *found = 1;
    for (int k = 1; k < d && *found; k++)
        TRY(find_beside(beside + 3 * (k - 1), found, a, inside, way, (axis + k) % d));
    if (d == 3) {
        vector_cross(out, beside, beside + 3);
    } else {
        fmpq_set(out, beside + 1);
        fmpq_neg(out + 1, beside);
    }
    return GRAZE_OK;
}
