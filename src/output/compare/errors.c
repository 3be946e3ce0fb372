/* Counts errors by their leading digits.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/compare/compare.h"

#include <stdlib.h>
#include <string.h>
#include "output/compare/counts.h"

enum { LEAST = 10, MOST = 99, BINS = MOST - LEAST + 1, UNIT = 10000 };

static int add_to_bin(errors *e, ceiling size) {
    ceiling c = ceiling_short(size);
    if (c.exponent > LAST_DECADE) {
        e->past++;
        return 1;
    }
    if (c.exponent < FIRST_DECADE)
        c = (ceiling){(unsigned long)LEAST * UNIT, FIRST_DECADE};
    unsigned long **bin = &e->bin[c.exponent - FIRST_DECADE];
    if (!*bin && !(*bin = calloc(BINS, sizeof **bin)))
        return 0;
    (*bin)[c.digits / UNIT - LEAST]++;
    return 1;
}

int errors_add(errors *e, value_error one) {
    e->rows++;
    e->over += one.side > 0;
    e->under += one.side < 0;
    e->beyond += one.beyond != 0;
    if (ceiling_compare(one.size, e->largest) > 0)
        e->largest = one.size;
    if (one.side > 0 && ceiling_compare(one.size, e->largest_over) > 0)
        e->largest_over = one.size;
    return !one.size.digits || add_to_bin(e, one.size);
}

ceiling errors_quantile(const errors *e, unsigned long per_mille) {
    unsigned long wanted = (unsigned long)(((unsigned __int128)e->rows * per_mille + 999) / 1000);
    unsigned long counted = e->rows - e->over - e->under;
    for (int d = 0; d < DECADES && counted < wanted; d++)
        for (int k = 0; e->bin[d] && k < BINS; k++) {
            counted += e->bin[d][k];
            if (counted >= wanted)
                return (ceiling){(unsigned long)(k + LEAST) * UNIT, d + FIRST_DECADE};
        }
    return counted < wanted ? e->largest : (ceiling){0, 0};
}

void errors_clear(errors *e) {
    for (int d = 0; d < DECADES; d++)
        free(e->bin[d]);
    memset(e, 0, sizeof *e);
}
