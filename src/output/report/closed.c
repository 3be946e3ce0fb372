/* Positions in words. SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/report/closed.h"

#include "output/report/closings.h"

/* What each level says of a point, by whether a witness shows that its contacts leave a gap. */
static const char *meaning_of(const topo_finding *topo) {
    int closed = topo->position != GRAZE_TOPO_BOUNDARY;
    switch (topo->level) {
    case GRAZE_LEVEL_FIRST_ORDER:
        return closed ? "to first order the contacts cover every direction about P, each with "
                        "those near it"
                      : "to first order no contact covers the direction from P to the point below";
    case GRAZE_LEVEL_CLOSED_CONES:
        return "closed cones that contacts cover exactly fill all directions about P, with what is "
               "covered to first order";
    case GRAZE_LEVEL_EDGES:
        return "the contacts cover every direction about P to first order, with the ways that pass "
               "between parts or along an edge";
    case GRAZE_LEVEL_LEADING_TERMS:
        return closed ? "contacts close on both sides of a plane through P and, by their leading "
                        "terms, overlap in each of its directions"
                      : "contacts close on both sides of a plane through P, but leave a gap in it "
                        "that is thinner than every cone";
    case GRAZE_LEVEL_SECTION:
        return "near P, or near it on each side of a plane, nothing depends on one direction; "
               "every "
               "part into which curves cut small squares across it was looked at";
    case GRAZE_LEVEL_CURVES:
        return "every part into which curves cut a small square about P was looked at";
    default:
        return NULL;
    }
}

static void put_undecided(text *t, const topo_finding *topo) {
    text_format(t, "it is undecided: %s.\n", topo->reason);
    if (!topo->has_across)
        return;
    text_put(t, "All directions (dx, dy, dz) are covered to first order but some of the plane ");
    closings_form(t, topo->across, 3);
    text_put(t, " = 0:\na gap along it would be thinner "
                "than every cone.\n");
}

/* Up to what number of a path's or square's places something holds. */
static void put_reach(text *t, const char *before, const topo_finding *topo) {
    text_put(t, before);
    text_rational(t, &topo->reach);
    text_put(t, ".\n");
}

static void put_path(text *t, const topo_finding *topo) {
    text_format(t, "). So are all points P + s^%ld ", (long)topo->order);
    closings_vector(t, topo->open, 3);
    text_format(t, " + s^%ld (", (long)topo->order + 1);
    text_rational(t, &topo->lift);
    text_put(t, ") ");
    closings_vector(t, topo->across, 3);
    put_reach(t, " with 0 < s <= ", topo);
}

static void put_square(text *t, const topo_finding *topo, int dimension) {
    text_put(t, "). Every smaller square than its own, P + x ");
    closings_vector(t, topo->along[0], dimension);
    text_put(t, " + y ");
    closings_vector(t, topo->along[1], dimension);
    put_reach(t,
              " with the larger of |x|, |y|\nbelow its value there, has such a point too; that "
              "value is ",
              topo);
}

/* The witness, and what is known of the points between. */
static void put_witness(text *t, const topo_finding *topo, graze_pmc pmc, int dimension) {
    text_format(t, "A point that is %s: (", graze_pmc_name(pmc));
    for (int k = 0; k < dimension; k++) {
        text_put(t, k ? ", " : "");
        text_rational(t, topo->witness + k);
    }
    switch (finding_witness(topo)) {
    case WITNESS_PATH:
        put_path(t, topo);
        break;
    case WITNESS_SQUARE:
        put_square(t, topo, dimension);
        break;
    default:
        text_put(t, "). So are all points P + s ");
        closings_vector(t, topo->direction, dimension);
        put_reach(t, " with 0 < s <= ", topo);
    }
}

static void explain_finding(text *t, const topo_finding *topo, const char *answer, graze_pmc pmc,
                            int dimension) {
    const char *meaning = meaning_of(topo);
    if (topo->position == GRAZE_TOPO_UNDECIDED) {
        put_undecided(t, topo);
        return;
    }
    text_format(t, "it is `%s`, by level `%s`.\n", answer, graze_topo_level_name(topo->level));
    if (meaning)
        text_format(t, "That is, %s.\n", meaning);
    if (topo->has_witness)
        put_witness(t, topo, pmc, dimension);
}

void closed_explain(text *t, const topo_finding *topo, int dimension) {
    text_put(t, "\nRelative to the closed set ");
    explain_finding(t, topo, graze_topo_name(topo->position), GRAZE_OUT, dimension);
}

void closed_explain_regular(text *t, const topo_finding *regular, int dimension) {
    text_put(t, "\nRegular, in the closure of the unsweep's interior: ");
    explain_finding(t, regular, graze_regular_name(regular->position), GRAZE_IN, dimension);
}
