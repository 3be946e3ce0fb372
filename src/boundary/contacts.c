/* Contact points, which lead to parts that are thinner than the lattice.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <stdlib.h>
#include <string.h>
#include "boundary/boundary.h"

/* The bits of the coordinates in turn, so that a cell is an interval of places. */
static uint64_t place_of(const uint32_t at[3], int dimension, unsigned bits) {
    uint64_t out = 0;
    for (unsigned bit = bits; bit-- > 0;)
        for (int k = dimension; k-- > 0;)
            out = out << 1 | (at[k] >> bit & 1);
    return out;
}

int cell_has_contact(const struct graze_boundary *b, const cell *c) {
    unsigned below = (b->depth - c->level) * (unsigned)b->dimension;
    uint64_t first = place_of(c->at, b->dimension, c->level) << below;
    size_t low = 0, high = b->contact_count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (b->contacts[middle] < first)
            low = middle + 1;
        else
            high = middle;
    }
    return low < b->contact_count && b->contacts[low] - first < (uint64_t)1 << below;
}

/* The smallest cell that holds the point at hand; 0 if it is outside the box. */
static int cell_of(uint32_t at[3], struct graze_boundary *b) {
    mpz_t whole;
    mpz_init(whole);
    int inside = 1;
    memset(at, 0, 3 * sizeof *at);
    for (int k = 0; k < b->dimension && inside; k++) {
        mpq_sub(b->point[k], b->point[k], b->low[k]);
        mpq_div(b->point[k], b->point[k], b->side[k]);
        mpq_mul_2exp(b->point[k], b->point[k], b->depth);
        mpz_fdiv_q(whole, mpq_numref(b->point[k]), mpq_denref(b->point[k]));
        inside = mpz_sgn(whole) >= 0 && mpz_cmp_ui(whole, 1ul << b->depth) < 0;
        at[k] = inside ? (uint32_t)mpz_get_ui(whole) : 0;
    }
    mpz_clear(whole);
    return inside;
}

static int compare_places(const void *a, const void *b) {
    const uint64_t *x = a, *y = b;
    return *x < *y ? -1 : *x > *y;
}

static graze_status ask(graze_context *context, struct graze_boundary *b,
                        const graze_generator *generator, unsigned long row, mpq_t time) {
    graze_sample made;
    graze_verdict verdict;
    uint32_t at[3];
    graze_status status = graze_generator_point(b->point, time, &made, context, generator, row);
    if (!status)
        status = graze_classify(&verdict, context, b->scene, (const mpq_t *)b->point, 1);
    if (status)
        return status;
    b->asked++;
    if (verdict.pmc == GRAZE_ON && cell_of(at, b))
        b->contacts[b->contact_count++] = place_of(at, b->dimension, b->depth);
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
    graze_generator *generator = NULL;
    graze_status status = graze_generator_create(&generator, context, b->scene, seed, weights, 0);
    b->contacts = status ? NULL : malloc(count * sizeof *b->contacts);
    if (!status && !b->contacts)
        status = context_fail(context, GRAZE_ESYSTEM, "out of memory for contact points");
    mpq_t time;
    mpq_init(time);
    for (unsigned long row = 0; row < count && !status; row++)
        status = ask(context, b, generator, row, time);
    mpq_clear(time);
    graze_generator_destroy(generator);
    if (b->contact_count)
        qsort(b->contacts, b->contact_count, sizeof *b->contacts, compare_places);
    return status;
}
