/* Names of answers and of groupings. SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/compare/compare.h"

#include "output/compare/counts.h"

const char *const pmc_words[3] = {"in", "on", "out"};

int judged_of(int judged, int contacts) {
    if (judged == JUDGED_WORD)
        return 1;
    return (judged >= JUDGED_CELL && judged <= JUDGED_SHIFT) == contacts;
}

const char *grouping_name(grouping g) {
    static const char *const names[GROUPING_COUNT] = {"stratum",    "k",    "sdf",    "class",
                                                      "definition", "case", "status", "role"};
    return names[g];
}

const char *grouping_title(grouping g) {
    return g == BY_DISTANCE ? "k (distance 2^-k)"
           : g == BY_SDF    ? "sdf (the power of ten below its size)"
                            : grouping_name(g);
}

int comparison_has_no_on(const graze_comparison *c) {
    return c->judged[JUDGED_PMC] && c->golden_on && !c->answered_on;
}
