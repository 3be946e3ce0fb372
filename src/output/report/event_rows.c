/* Rows of events. SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/report/row_parts.h"

static const char *known_name(const char *name) {
    return name[0] == 'n' && name[1] == 'o' && name[2] == 'n' ? "" : name;
}

void report_curve(text *out, const graze_curve *curve, const curve_part *part) {
    const graze_curve_part *f = &part->facts;
    text_rational(out, curve->t);
    text_format(out, ",%s,", graze_curve_kind_name(f->kind));
    report_put_cell(out, &f->cell);
    for (int k = 0; k < 2 * curve->dimension; k++) {
        text_put(out, ",");
        text_rational(out, k < curve->dimension ? part->a + k : part->b + k - curve->dimension);
    }
    text_format(out, ",%s,%s,%s,%s,", report_sign(f->theta_a), report_sign(f->theta_b),
                known_name(graze_orientation_name(f->orientation)), graze_trim_name(f->trim));
    text_count(out, f->chain);
    text_format(out, ",%s\n", known_name(graze_chain_form_name(f->form)));
}

/* `,from,from_near,to,to_near` */
static void put_interval(text *out, const graze_time *from, const graze_time *to) {
    text_put(out, ",");
    report_put_time_near(out, from);
    text_put(out, ",");
    report_put_time_near(out, to);
}

void report_patch(text *out, const graze_patches *patches, size_t index) {
    const patch *item = &patches->item[index];
    const graze_patch *f = &item->facts;
    int d = patches->envelope->cells.dimension;
    text_count(out, index);
    text_format(out, ",%s,", graze_curve_kind_name(f->kind));
    report_put_cell(out, &f->cell);
    put_interval(out, f->from, f->to);
    text_put(out, ",");
    report_put_cell(out, &f->a);
    text_put(out, ",");
    report_put_cell(out, &f->b);
    text_format(out, ",%s,%s,%s,", report_sign(f->theta_a), report_sign(f->theta_b),
                known_name(graze_orientation_name(f->orientation)));
    text_rational(out, item->t);
    for (int k = 0; k < 2 * d; k++) {
        text_put(out, ",");
        text_rational(out, k < d ? item->body + k : item->world + k - d);
    }
    text_format(out, ",%s\n", graze_trim_name(f->trim));
}

void report_joint(text *out, const graze_patches *patches, size_t index) {
    const patch_joint *joint = &patches->joint[index];
    report_put_cell(out, &joint->cell);
    put_interval(out, patches->moments.time[joint->from], patches->moments.time[joint->to]);
    text_format(out, ",%s,", known_name(graze_chain_form_name(joint->form)));
    for (size_t k = 0; k < joint->count; k++) {
        if (k > 0)
            text_put(out, " ");
        text_count(out, patches->member[joint->first + k]);
    }
    text_put(out, "\n");
}
