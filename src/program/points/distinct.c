/* A set of hashes, and counts of points that repeat.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "program/points/points.h"

/* After SPENT repeated points in succession a stratum is given up, after OVER all strata are. */
enum { SPENT = 20, OVER = 2000 };
/* The most points of other strata that are passed over for another point of one stratum. */
enum { PASSED = 1000 };

int distinct_wants(distinct *d, graze_stratum stratum) {
    if (d->is_wanted && d->wanted != stratum && ++d->passed == PASSED)
        d->is_wanted = 0;
    return !d->is_wanted || d->wanted == stratum;
}

/* Ask for another point of the stratum, unless it has been tried too often. */
static void want_another(distinct *d, graze_stratum stratum) {
    d->idle++;
    d->tries = d->is_wanted ? d->tries + 1 : 1;
    if (d->tries == SPENT)
        d->spent |= 1u << stratum;
    d->wanted = stratum;
    d->passed = 0;
    d->is_wanted = !(d->spent >> stratum & 1);
}

int distinct_add(distinct *d, graze_stratum stratum, const char *point, size_t length) {
    checksum sum = {0, 0, 0};
    checksum_add(&sum, point, length);
    uint64_t hash = checksum_value(&sum);
    size_t at = 0;
    if (slots_next(&d->seen, hash, &at) != SLOTS_NONE) {
        want_another(d, stratum);
        return 0;
    }
    d->failed |= !slots_add(&d->seen, hash);
    d->idle = 0;
    d->is_wanted = 0;
    return 1;
}

int distinct_is_over(const distinct *d) {
    return d->idle >= OVER;
}

void distinct_clear(distinct *d) {
    slots_clear(&d->seen);
}
