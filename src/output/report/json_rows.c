/* One point's verdict and contacts as a line of JSON (src/program/cli/formats.md, JSON Lines).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/report/row_parts.h"

#include "decide/verdict/verdict.h"

/* Write the cells of a contact; for a curved solid the titles of the primitives. */
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

/* Write the first place where a state is not decided. */
static void json_undecided(json_writer *w, const graze_scene *scene, const undecided_place *place) {
    json_open(w, "undecided", '{');
    json_time(w, "t", place->where.from);
    json_features(w, scene, &place->where);
    json_text(w, "reason", place->reason);
    json_close(w, '}');
}

static void json_verdict(json_writer *w, const graze_scene *scene, const graze_verdict *v) {
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

/* Write the verdict, the word and the contacts. */
static void json_trace(json_writer *w, const graze_scene *scene, const graze_trace *trace) {
    json_verdict(w, scene, &trace->verdict);
    json_text(w, "word", trace->word);
    json_open(w, "contacts", '[');
    for (size_t k = 0; k < trace->contact_count && !trace->undecided; k++)
        json_contact(w, scene, &trace->contact[k]);
    json_close(w, ']');
    if (trace->undecided)
        json_undecided(w, scene, trace->undecided);
}

void report_json(text *out, const row *r) {
    int d = r->scene->motion->dimension;
    json_writer w = {.out = out};
    json_open(&w, NULL, '{');
    json_point(&w, "point", r->point, d);
    json_text(&w, "pmc", graze_pmc_name(r->trace->verdict.pmc));
    if (!r->shown->at_rest)
        json_trace(&w, r->scene, r->trace);
    for (const column_set *set = NULL; (set = columns_next(set, r->shown));)
        set->json(&w, r);
    json_close(&w, '}');
    text_put(out, "\n");
}
