/* One point's verdict and contacts as a line of JSON (src/program/cli/formats.md, JSON Lines).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */

#include "output/report/json_rows.h"

#include "base/number/rational.h"
#include "decide/verdict/verdict.h"
#include "output/report/enclosure.h"
#include "output/report/json_values.h"

/* The cells of a contact; of a curved solid primitives, by their titles. */
static void json_features(json_writer *w, const graze_scene *scene, const contact *c) {
    const csg *curved = scene->solid->curved;
    json_open(w, "features", '[');
    for (size_t k = 0; k < c->cell_count; k++) {
        if (!curved) {
            json_cell(w, NULL, &c->cell[k]);
            continue;
        }
        json_open(w, NULL, '{');
        json_text(w, "primitive", curved->primitive[c->cell[k].a].title);
        json_close(w, '}');
    }
    json_close(w, ']');
}

static void json_contact(json_writer *w, const graze_scene *scene, const contact *c) {
    json_open(w, NULL, '{');
    json_kind(w, "kind", verdict_kind(c->left, c->right));
    json_state(w, "left", c->left);
    json_state(w, "right", c->right);
    json_time(w, "from", c->from);
    json_time(w, "to", c->to);
    json_features(w, scene, c);
    json_close(w, '}');
}

/* The first place where a state is not decided. */
static void json_undecided(json_writer *w, const graze_scene *scene, const undecided_place *place) {
    json_open(w, "undecided", '{');
    json_time(w, "t", place->where.from);
    json_features(w, scene, &place->where);
    json_text(w, "reason", place->reason);
    json_close(w, '}');
}

static void json_verdict(json_writer *w, const graze_scene *scene, const graze_verdict *v) {
    json_text(w, "pmc", graze_pmc_name(v->pmc));
    if (scene->options.operation != GRAZE_SWEEP)
        return;
    json_text(w, "class", graze_class_name(v->class_));
    if (v->class_ == GRAZE_CLASS_UNDECIDED)
        return;
    if (v->definition)
        json_count(w, "definition", (unsigned long)v->definition);
    else
        json_text(w, "definition", "ext");
    json_count(w, "case", (unsigned long)v->case_);
    json_count(w, "i", v->i);
    json_count(w, "t", v->t);
}

/* A list of integers. */
static void json_integers(json_writer *w, const char *key, const fmpz *v, int count) {
    json_open(w, key, '[');
    for (int k = 0; k < count; k++)
        json_integer(w, NULL, v + k);
    json_close(w, ']');
}

/* The path P + s^order along + s^(order + 1) lift across on which a witness lies. */
static void json_path(json_writer *w, const topo_finding *topo) {
    json_integers(w, "topo_direction", topo->open, 3);
    json_integers(w, "topo_normal", topo->across, 3);
    json_count(w, "topo_order", (unsigned long)topo->order);
    json_rational(w, "topo_z", &topo->lift);
}

/* The witness, and the ray, the path or the square on which it lies. */
static void json_witness(json_writer *w, const topo_finding *topo, int dimension) {
    topo_witness kind = finding_witness(topo);
    json_point(w, "topo_witness", topo->witness, dimension);
    if (kind == WITNESS_PATH) {
        json_path(w, topo);
    } else if (kind == WITNESS_RAY) {
        json_integers(w, "topo_direction", topo->direction, dimension);
    } else if (dimension == 3) {
        json_open(w, "topo_plane", '[');
        for (int k = 0; k < 2; k++)
            json_integers(w, NULL, topo->along[k], dimension);
        json_close(w, ']');
    }
    json_rational(w, kind == WITNESS_SQUARE ? "topo_rho" : "topo_epsilon", &topo->reach);
}

static void json_topo(json_writer *w, const topo_finding *topo, int dimension) {
    json_text(w, "topo", graze_topo_name(topo->position));
    if (topo->position == GRAZE_TOPO_UNDECIDED)
        json_text(w, "topo_reason", topo->reason);
    else
        json_text(w, "topo_level", graze_topo_level_name(topo->level));
    if (topo->has_witness)
        json_witness(w, topo, dimension);
}

static void json_bound(json_writer *w, const char *key, double bound, int up) {
    char decimal[BOUND_ROOM];
    report_bound(decimal, bound, up);
    json_number(w, key, decimal);
}

static void json_distance(json_writer *w, const graze_scene *scene, const distance *found) {
    json_bound(w, "sdf_low", found->low, 0);
    json_bound(w, "sdf_high", found->high, 1);
    if (found->at) {
        json_time(w, "sdf_t", found->at);
        return;
    }
    fmpq_t time;
    fmpq_init(time);
    distance_time(time, found, scene->motion);
    json_rational(w, "sdf_t", time);
    fmpq_clear(time);
}

void report_json(text *out, const row *r) {
    const graze_trace *trace = r->trace;
    int d = r->scene->motion->dimension;
    json_writer w = {.out = out};
    json_open(&w, NULL, '{');
    json_point(&w, "point", r->point, d);
    json_verdict(&w, r->scene, &trace->verdict);
    json_text(&w, "word", trace->word);
    json_open(&w, "contacts", '[');
    for (size_t k = 0; k < trace->contact_count && !trace->undecided; k++)
        json_contact(&w, r->scene, &trace->contact[k]);
    json_close(&w, ']');
    if (trace->undecided)
        json_undecided(&w, r->scene, trace->undecided);
    if (r->shown->sdf > 0)
        json_distance(&w, r->scene, &r->space);
    if (r->shown->motion_error > 0)
        json_text(&w, "certain", report_certainty(&r->space, r->shown->motion_error));
    if (r->shown->moments)
        inside_json(&w, &r->inside, r->scene->motion);
    if (r->shown->topo)
        json_topo(&w, &r->topo, d);
    json_close(&w, '}');
    text_put(out, "\n");
}
