/* Positions in words. SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/report/row_parts.h"

/* For each level two sentences: one if the contacts cover a neighbourhood of the point, one if a
 * witness shows a gap. */
static const char *const meanings[][2] = {
    [GRAZE_LEVEL_FIRST_ORDER] = {"covered-first-order", "gap-first-order"},
    [GRAZE_LEVEL_CLOSED_CONES] = {"covered-closed-cones", "covered-closed-cones"},
    [GRAZE_LEVEL_EDGES] = {"covered-edges", "covered-edges"},
    [GRAZE_LEVEL_LEADING_TERMS] = {"covered-leading-terms", "gap-leading-terms"},
    [GRAZE_LEVEL_SECTION] = {"searched-section", "searched-section"},
    [GRAZE_LEVEL_CURVES] = {"searched-curves", "searched-curves"}};

static void put_undecided(text *t, const topo_finding *topo) {
    sentence_put(t, "closed-open", topo->reason);
    if (!topo->has_across)
        return;
    sentence_put(t, "closed-plane");
    closings_form(t, topo->across, 3);
    sentence_put(t, "closed-gap");
}

/* Append the witness, and what holds for the points between the witness and P. */
static void put_witness(text *t, const topo_finding *topo, graze_pmc pmc, int dimension) {
    sentence_put(t, "closed-point", graze_pmc_name(pmc), topo->witness, dimension);
    switch (finding_witness(topo)) {
    case WITNESS_PATH:
        sentence_put(t, "closed-path", (ulong)topo->order, topo->open, 3, (ulong)topo->order + 1,
                     &topo->lift, topo->across, 3, &topo->reach);
        break;
    case WITNESS_SQUARE:
        sentence_put(t, "closed-square", topo->along[0], dimension, topo->along[1], dimension,
                     &topo->reach);
        break;
    default:
        sentence_put(t, "closed-ray", topo->direction, dimension, &topo->reach);
    }
}

void closed_explain(text *t, const topo_finding *topo, int is_regular, int dimension) {
    const char *meaning = meanings[topo->level][topo->position == GRAZE_TOPO_BOUNDARY];
    sentence_put(t, is_regular ? "closed-regular" : "closed");
    if (topo->position == GRAZE_TOPO_UNDECIDED) {
        put_undecided(t, topo);
        return;
    }
    sentence_put(t, "closed-is",
                 is_regular ? graze_regular_name(topo->position) : graze_topo_name(topo->position),
                 graze_topo_level_name(topo->level));
    if (meaning)
        sentence_put(t, "closed-means", meaning);
    if (topo->has_witness)
        put_witness(t, topo, is_regular ? GRAZE_IN : GRAZE_OUT, dimension);
}
