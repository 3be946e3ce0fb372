/* Results and the names of their levels. SPDX-License-Identifier: GPL-3.0-or-later */
#include "questions/topo/topo.h"

#include "base/context/context.h"
#include "decide/scene/scene.h"
#include "decide/trace/trace.h"
#include "decide/verdict/verdict.h"
#include "questions/topo/eliminate.h"
#include "questions/topo/near.h"

const char *graze_topo_name(graze_topo topo) {
    static const char *const name[] = {"none", "interior", "boundary", "exterior", "undecided"};
    return name_at(name, sizeof name / sizeof *name, (size_t)topo);
}

const char *graze_regular_name(graze_topo topo) {
    return topo == GRAZE_TOPO_INTERIOR || topo == GRAZE_TOPO_BOUNDARY ? "yes"
           : topo == GRAZE_TOPO_EXTERIOR                              ? "no"
                                                                      : graze_topo_name(topo);
}

const char *graze_topo_level_name(graze_topo_level level) {
    static const char *const name[] = {"none",         "word",  "first_order", "curves",
                                       "closed_cones", "edges", "section",     "leading_terms"};
    return name_at(name, sizeof name / sizeof *name, (size_t)level);
}

void finding_init(topo_finding *f) {
    *f = (topo_finding){
        .reason = "", .witness = {{0, 1}, {0, 1}, {0, 1}}, .reach = {0, 1}, .lift = {0, 1}};
}

void finding_clear(topo_finding *f) {
    fmpq_clear(&f->reach);
    fmpq_clear(&f->lift);
    for (int k = 0; k < 3; k++) {
        fmpq_clear(f->witness + k);
        fmpz_clear(f->direction + k);
        fmpz_clear(f->along[0] + k);
        fmpz_clear(f->along[1] + k);
        fmpz_clear(f->open + k);
        fmpz_clear(f->across + k);
    }
}

topo_witness finding_witness(const topo_finding *f) {
    return f->level == GRAZE_LEVEL_FIRST_ORDER     ? WITNESS_RAY
           : f->level == GRAZE_LEVEL_LEADING_TERMS ? WITNESS_PATH
                                                   : WITNESS_SQUARE;
}

void finding_set(topo_finding *f, graze_topo position, graze_topo_level level) {
    f->position = position;
    f->level = level;
}

void finding_undecided(topo_finding *f, const char *reason) {
    finding_set(f, GRAZE_TOPO_UNDECIDED, GRAZE_LEVEL_NONE);
    f->reason = reason;
}

graze_status beyond_closed(int *out, graze_context *context, const graze_scene *scene,
                           const fmpq *point) {
    graze_verdict verdict;
    graze_pmc wanted = scene->options.operation == GRAZE_UNSWEEP ? GRAZE_IN : GRAZE_OUT;
    graze_status status =
        classify_verdict(&verdict, context, scene, (query_point){.rational = point});
    *out = !status && verdict.pmc == wanted;
    return status;
}
