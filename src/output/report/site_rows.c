/* Rows of sites. SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/report/row_parts.h"

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

const char *report_sign(int sign) {
    return sign == GRAZE_SIGN_ABSENT ? "" : sign > 0 ? "+" : sign < 0 ? "-" : "0";
}

void report_event(text *out, const graze_envelope *envelope, const found_event *event) {
    report_put_time_near(out, envelope->events.time[event->time]);
    text_format(out, ",%s,", graze_event_kind_name(event->kind));
    report_put_cell(out, &event->facet);
    if (event->other.kind)
        text_put(out, " and ");
    report_put_cell(out, &event->other);
    text_put(out, ",");
    report_put_cell(out, &event->cell);
    text_format(out, ",%s,%s\n", report_sign(event->before), report_sign(event->after));
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

static void json_order(json_writer *w, const char *key, int is_there, int order) {
    if (is_there && order != GRAZE_ORDER_VANISHES)
        json_count(w, key, (unsigned long)order);
    else
        json_text(w, key, is_there ? "inf" : NULL);
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
        json_order(w, "order", 1, germ->order);
        json_text(w, "sign", report_sign(germ->sign));
        json_close(w, '}');
    }
    json_close(w, ']');
}

/* Write the answers; nulls for those of a cell without contact, or of a contact on no slice. */
static void json_answers(json_writer *w, const graze_site *site) {
    const graze_site_facts *f = &site->facts;
    int met = !site->missed, on_slice = met && f->on_slice;
    json_text(w, "role", met ? graze_role_name(f->role) : NULL);
    json_text(w, "theta", on_slice ? report_sign(f->theta) : NULL);
    json_order(w, "contact_order", on_slice, f->order);
    json_text(w, "orientation", on_slice ? graze_orientation_name(f->orientation) : NULL);
    json_state(w, "left", met ? f->left : GRAZE_STATE_ABSENT);
    json_state(w, "right", met ? f->right : GRAZE_STATE_ABSENT);
    json_text(w, "trimmed", !met ? NULL : is_trimmed(f) ? "yes" : "no");
    json_text(w, "status", met ? graze_trim_name(f->trim) : NULL);
    json_time(w, "near", met ? site->near : NULL);
    json_time(w, "near_in", met ? site->near_in : NULL);
    json_text(w, "word", met ? site->trace.word : NULL);
}

void report_contact_json(text *out, const graze_site *site) {
    json_writer w = {.out = out};
    const graze_site_facts *f = &site->facts;
    json_open(&w, NULL, '{');
    json_rational(&w, "time", site->t);
    json_point(&w, "body", site->y, site->dimension);
    json_point(&w, "point", site->world, site->dimension);
    json_cell(&w, "cell", &f->cell);
    json_answers(&w, site);
    if (site->missed)
        json_text(&w, "shift", NULL);
    else if (site->snapped)
        json_rational(&w, "shift", site->shift);
    json_facets(&w, site);
    json_close(&w, '}');
    text_put(out, "\n");
}
