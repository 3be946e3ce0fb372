/* One point's verdict and contacts as a line of JSON (src/program/cli/formats.md, JSON Lines).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */

#include "output/report/report.h"

#include <stdio.h>
#include "base/context/scope.h"
#include "decide/scene/scene.h"
#include "decide/trace/trace.h"
#include "decide/verdict/verdict.h"
#include "input/csg/csg.h"
#include "output/report/row_parts.h"
#include "questions/distance/distance.h"
#include "questions/topo/topo.h"

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
    json_contact_kind(w, "kind", verdict_kind(c->left, c->right));
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

/* A finding, whose keys begin with the name of its question. */
typedef struct json_finding {
    json_writer *w;
    const char *question;
    const topo_finding *found;
    int dimension;
    char key[32];
} json_finding;

static const char *key_of(json_finding *f, const char *end) {
    snprintf(f->key, sizeof f->key, "%s_%s", f->question, end);
    return f->key;
}

/* The path P + s^order along + s^(order + 1) lift across on which a witness lies. */
static void json_path(json_finding *f) {
    json_integers(f->w, key_of(f, "direction"), f->found->open, 3);
    json_integers(f->w, key_of(f, "normal"), f->found->across, 3);
    json_count(f->w, key_of(f, "order"), (unsigned long)f->found->order);
    json_rational(f->w, key_of(f, "z"), &f->found->lift);
}

/* The witness, and the ray, the path or the square on which it lies. */
static void json_witness(json_finding *f) {
    topo_witness kind = finding_witness(f->found);
    json_point(f->w, key_of(f, "witness"), f->found->witness, f->dimension);
    if (kind == WITNESS_PATH) {
        json_path(f);
    } else if (kind == WITNESS_RAY) {
        json_integers(f->w, key_of(f, "direction"), f->found->direction, f->dimension);
    } else if (f->dimension == 3) {
        json_open(f->w, key_of(f, "plane"), '[');
        for (int k = 0; k < 2; k++)
            json_integers(f->w, NULL, f->found->along[k], f->dimension);
        json_close(f->w, ']');
    }
    json_rational(f->w, key_of(f, kind == WITNESS_SQUARE ? "rho" : "epsilon"), &f->found->reach);
}

static void json_position(json_writer *w, const char *question, const char *answer,
                          const topo_finding *found, int dimension) {
    json_finding f = {w, question, found, dimension, ""};
    json_text(w, question, answer);
    if (found->position == GRAZE_TOPO_UNDECIDED)
        json_text(w, key_of(&f, "reason"), found->reason);
    else
        json_text(w, key_of(&f, "level"), graze_topo_level_name(found->level));
    if (found->has_witness)
        json_witness(&f);
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
    LOCAL(fmpq, time);
    distance_time(time, found, scene->motion);
    json_rational(w, "sdf_t", time);
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
    if (r->shown->boundary)
        json_bound(&w, "boundary_low", r->boundary, 0);
    if (r->shown->motion_error > 0)
        json_text(&w, "certain", report_certainty(&r->space, r->shown->motion_error));
    if (r->shown->moments)
        inside_json(&w, &r->inside, r->scene->motion);
    if (r->shown->topo)
        json_position(&w, "topo", graze_topo_name(r->topo.position), &r->topo, d);
    if (r->shown->regular)
        json_position(&w, "regular", graze_regular_name(r->regular.position), &r->regular, d);
    json_close(&w, '}');
    text_put(out, "\n");
}
