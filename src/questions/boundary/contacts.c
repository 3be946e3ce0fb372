/* Contact points, which lead to parts that are thinner than the lattice.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/boundary/sampling.h"

#include "base/context/array.h"
#include "base/context/scope.h"
#include "decide/trace/trace.h"
#include "decide/verdict/verdict.h"
#include "questions/generate/generate.h"

/* The place of a cell: the bits of its coordinates interleaved (Morton code), so that the places
 * within a larger cell form an interval. */
static uint64_t place_of(const uint32_t at[3], int dimension, unsigned bits) {
    uint64_t out = 0;
    for (unsigned bit = bits; bit-- > 0;)
        for (int k = dimension; k-- > 0;)
            out = out << 1 | (at[k] >> bit & 1);
    return out;
}

static int compare_codes(const void *a, const void *b) {
    const uint64_t *x = a, *y = b;
    return *x < *y ? -1 : *x > *y;
}

int sample_cell_has_contact(const struct graze_boundary *b, const sample_cell *c) {
    unsigned below = (b->depth - c->level) * (unsigned)b->dimension;
    uint64_t first = place_of(c->at, b->dimension, c->level) << below;
    size_t at = array_first(&first, b->contacts, b->contact_count, sizeof first, compare_codes);
    return at < b->contact_count && b->contacts[at] - first < (uint64_t)1 << below;
}

/* Find the smallest cell that holds a point; returns 0 if the point is outside the box. */
static int cell_of(uint32_t at[3], const struct graze_boundary *b, const fmpq *point) {
    LOCAL(fmpq, share);
    LOCAL(fmpz, whole);
    int inside = 1;
    memset(at, 0, 3 * sizeof *at);
    for (int k = 0; k < b->dimension && inside; k++) {
        fmpq_sub(share, point + k, b->low + k);
        fmpq_div(share, share, b->side + k);
        fmpq_mul_2exp(share, share, b->depth);
        fmpz_fdiv_q(whole, fmpq_numref(share), fmpq_denref(share));
        inside = fmpz_sgn(whole) >= 0 && fmpz_cmp_ui(whole, 1ul << b->depth) < 0;
        at[k] = inside ? (uint32_t)fmpz_get_ui(whole) : 0;
    }
    return inside;
}

static graze_status ask(graze_context *context, struct graze_boundary *b, const fmpq *point) {
    graze_verdict verdict;
    uint32_t at[3];
    TRY(classify_answer(&verdict, context, b->scene, (query_point){.rational = point},
                        TRACE_PMC_BESIDE));
    b->asked++;
    if (verdict.pmc == GRAZE_ON && cell_of(at, b, point))
        b->contacts[b->contact_count++] = place_of(at, b->dimension, b->depth);
    return GRAZE_OK;
}

/* Make and classify the points of the generator's first rows. */
static graze_status ask_rows(graze_context *context, struct graze_boundary *b,
                             const graze_generator *generator, unsigned long count) {
    TRY(MAKE_ARRAY(context, b->contacts, count, "contact points"));
    HELD(sample, s);
    for (unsigned long row = 0; row < count; row++) {
        TRY(generator_sample(&s, context, generator, row));
        TRY(ask(context, b, s.point));
    }
    qsort(b->contacts, b->contact_count, sizeof *b->contacts, compare_codes);
    return GRAZE_OK;
}

graze_status boundary_contacts(graze_context *context, struct graze_boundary *b,
                               unsigned long count, unsigned long long seed) {
    static const graze_stratum strata[] = {
        GRAZE_STRATUM_FACE,  GRAZE_STRATUM_FACE_ODD, GRAZE_STRATUM_EDGE,  GRAZE_STRATUM_VERTEX,
        GRAZE_STRATUM_START, GRAZE_STRATUM_END,      GRAZE_STRATUM_BREAK, GRAZE_STRATUM_SLIDE};
    if (count == 0)
        return GRAZE_OK;
    unsigned long weights[GRAZE_STRATUM_COUNT] = {0};
    for (size_t k = 0; k < sizeof strata / sizeof *strata; k++)
        weights[strata[k]] = 1;
    struct graze_generator generator;
    graze_status status = generator_make(&generator, context, b->scene, seed, weights, 0);
    if (!status)
        status = ask_rows(context, b, &generator, count);
    generator_clear(&generator);
    return status;
}
