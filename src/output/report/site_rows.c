/* Rows of sites. SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/report/report.h"

#include "decide/scene/scene.h"
#include "output/report/row_parts.h"
#include "questions/contact/contact.h"

static void put_numbers(text *t, const fmpq *x, int count) {
    for (int k = 0; k < count; k++) {
        text_rational(t, x + k);
        text_put(t, ",");
    }
}

void report_put_cell(text *t, const graze_cell *cell) {
    if (!cell->kind)
        return;
    static const char *const kinds[] = {"", "face ", "edge ", "vertex "};
    text_put(t, kinds[cell->kind]);
    text_count(t, cell->a);
    if (cell->kind == GRAZE_CELL_EDGE) {
        text_put(t, "-");
        text_count(t, cell->b);
    }
}

static const char *state_name(graze_state state) {
    return state == GRAZE_STATE_I   ? "I"
           : state == GRAZE_STATE_B ? "B"
           : state == GRAZE_STATE_O ? "O"
                                    : "";
}

static int is_trimmed(const graze_site_facts *f) {
    return f->trim == GRAZE_TRIM_NEAR || f->trim == GRAZE_TRIM_FAR;
}

/* theta, contact_order, orientation */
static void put_slice(text *t, const graze_site_facts *f) {
    if (!f->on_slice) {
        text_put(t, ",,,");
        return;
    }
    text_format(t, "%s,", report_sign(f->theta));
    if (f->order == GRAZE_ORDER_VANISHES)
        text_put(t, "inf,");
    else
        text_format(t, "%d,", f->order);
    text_format(t, "%s,", graze_orientation_name(f->orientation));
}

/* role to word */
static void put_site_answers(text *out, const graze_site *site) {
    const graze_site_facts *f = &site->facts;
    text_format(out, "%s,", graze_role_name(f->role));
    put_slice(out, f);
    text_format(out, "%s,%s,%s,%s,", state_name(f->left), state_name(f->right),
                is_trimmed(f) ? "yes" : "no", graze_trim_name(f->trim));
    report_put_time_near(out, site->near);
    text_put(out, ",");
    report_put_time_near(out, site->near_in);
    text_put(out, ",");
    text_put(out, site->trace.word);
}

void report_contact_csv(text *out, const graze_site *site, const char *rest) {
    const graze_site_facts *f = &site->facts;
    put_numbers(out, site->t, 1);
    put_numbers(out, site->y, site->dimension);
    put_numbers(out, site->world, site->dimension);
    report_put_cell(out, &f->cell);
    text_put(out, ",");
    if (site->missed)
        text_put(out, ",,,,,,,,,,,,");
    else
        put_site_answers(out, site);
    if (site->snapped)
        text_put(out, ",");
    if (site->snapped && !site->missed)
        text_rational(out, site->shift);
    if (rest) {
        text_put(out, ",");
        text_put(out, rest);
    }
    text_put(out, "\n");
}

static void json_order(json_writer *w, const char *key, int order) {
    if (order == GRAZE_ORDER_VANISHES)
        json_text(w, key, "inf");
    else
        json_count(w, key, (unsigned long)order);
}

static void json_slice(json_writer *w, const graze_site_facts *f) {
    if (!f->on_slice) {
        json_text(w, "theta", NULL);
        json_text(w, "contact_order", NULL);
        json_text(w, "orientation", NULL);
        return;
    }
    json_text(w, "theta", report_sign(f->theta));
    json_order(w, "contact_order", f->order);
    json_text(w, "orientation", graze_orientation_name(f->orientation));
}

static void json_facets(json_writer *w, const graze_site *site) {
    json_open(w, "facets", '[');
    for (size_t k = 0; k < site->germ_count; k++) {
        const site_germ *germ = &site->germ[k];
        json_open(w, NULL, '{');
        json_cell(w, "facet", &site->place.facet[germ->facet].name);
        json_text(w, "side", report_sign(germ->side));
        json_rational(w, "speed", germ->speed);
        json_rational(w, "drift", germ->drift);
        json_rational(w, "theta", germ->theta);
        json_order(w, "order", germ->order);
        json_text(w, "sign", report_sign(germ->sign));
        json_close(w, '}');
    }
    json_close(w, ']');
}

static void json_answers(json_writer *w, const graze_site *site) {
    const graze_site_facts *f = &site->facts;
    json_text(w, "role", graze_role_name(f->role));
    json_slice(w, f);
    json_state(w, "left", f->left);
    json_state(w, "right", f->right);
    json_text(w, "trimmed", is_trimmed(f) ? "yes" : "no");
    json_text(w, "status", graze_trim_name(f->trim));
    json_time(w, "near", site->near);
    json_time(w, "near_in", site->near_in);
    json_text(w, "word", site->trace.word);
}

/* Write nulls for the answers of a cell without contact. */
static void json_no_answers(json_writer *w) {
    static const char *const names[] = {"role", "theta",   "contact_order", "orientation",
                                        "left", "right",   "trimmed",       "status",
                                        "near", "near_in", "word"};
    for (size_t k = 0; k < sizeof names / sizeof *names; k++)
        json_text(w, names[k], NULL);
}

void report_contact_json(text *out, const graze_site *site) {
    json_writer w = {.out = out};
    const graze_site_facts *f = &site->facts;
    json_open(&w, NULL, '{');
    json_rational(&w, "time", site->t);
    json_point(&w, "body", site->y, site->dimension);
    json_point(&w, "point", site->world, site->dimension);
    json_cell(&w, "cell", &f->cell);
    if (site->missed)
        json_no_answers(&w);
    else
        json_answers(&w, site);
    if (site->missed)
        json_text(&w, "shift", NULL);
    else if (site->snapped)
        json_rational(&w, "shift", site->shift);
    json_facets(&w, site);
    json_close(&w, '}');
    text_put(out, "\n");
}
