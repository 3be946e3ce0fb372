/* Lattice points and cells, and the exact answers at points.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/boundary/sampling.h"

#include "base/context/scope.h"
#include "decide/trace/trace.h"
#include "decide/verdict/verdict.h"

uint64_t lattice_key(const uint32_t at[3]) {
    return (uint64_t)at[0] | (uint64_t)at[1] << 21 | (uint64_t)at[2] << 42;
}

uint32_t key_coordinate(uint64_t key, int axis) {
    return (uint32_t)(key >> 21 * axis) & ((1u << 21) - 1);
}

void lattice_point(fmpq *out, const struct graze_boundary *b, uint64_t key) {
    for (int k = 0; k < b->dimension; k++) {
        fmpq_set_ui(out + k, key_coordinate(key, k), 1ul << (b->depth + 1));
        fmpq_mul(out + k, out + k, b->side + k);
        fmpq_add(out + k, out + k, b->low + k);
    }
}

uint64_t sample_cell_corner(const struct graze_boundary *b, const sample_cell *c, unsigned index) {
    uint32_t at[3] = {0, 0, 0};
    for (int k = 0; k < b->dimension; k++)
        at[k] = (c->at[k] + (index >> k & 1)) << (b->depth + 1 - c->level);
    return lattice_key(at);
}

graze_pmc lattice_known(const struct graze_boundary *b, uint64_t key) {
    size_t index = number_index_find(&b->points, key);
    return index < b->points.count ? (graze_pmc)b->points.value[index] : GRAZE_PMC_NONE;
}

graze_status lattice_classify(graze_pmc *out, graze_context *context, struct graze_boundary *b,
                              uint64_t key) {
    *out = lattice_known(b, key);
    if (*out)
        return GRAZE_OK;
    if (b->points.count + b->asked >= b->budget) {
        b->complete = 0;
        return GRAZE_OK;
    }
    graze_verdict verdict;
    lattice_point(b->point, b, key);
    TRY(classify_answer(&verdict, context, b->scene, (query_point){.rational = b->point},
                        TRACE_PMC));
    *out = verdict.pmc;
    b->known[verdict.pmc]++;
    return number_index_add(&b->points, key, (unsigned char)verdict.pmc)
               ? GRAZE_OK
               : context_fail(context, GRAZE_ESYSTEM, "out of memory for the points of a boundary");
}

graze_status asker_pmc(graze_pmc *out, asker *a, const fmpq *point) {
    graze_verdict verdict;
    TRY(classify_answer(&verdict, a->context, a->boundary->scene, (query_point){.rational = point},
                        TRACE_PMC_BESIDE));
    a->asked++;
    *out = verdict.pmc;
    return GRAZE_OK;
}

int sample_cell_mixed(const struct graze_boundary *b, const sample_cell *c, unsigned mask,
                      unsigned bits) {
    int out = 0, rest = 0;
    for (unsigned k = 0; k < 1u << b->dimension; k++) {
        if ((k & mask) != bits)
            continue;
        graze_pmc pmc = lattice_known(b, sample_cell_corner(b, c, k));
        out |= pmc == GRAZE_OUT;
        rest |= pmc != GRAZE_OUT;
    }
    return out && rest;
}
