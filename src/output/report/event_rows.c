/* Rows of events. SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/report/report.h"

#include "decide/bounds/bounds.h"
#include "decide/scene/scene.h"
#include "decide/trace/trace.h"
#include "output/report/row_parts.h"
#include "questions/envelope/envelope.h"

graze_status report_events_header(char **out, graze_context *context, const graze_scene *scene,
                                  const char *notes) {
    return table_head(out, context, scene, notes, "time,time_near,kind,facet,cell,before,after",
                      NULL);
}

static const char *sign_text(int sign) {
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
    text_format(out, ",%s,%s\n", sign_text(event->before), sign_text(event->after));
}

graze_status report_curve_header(char **out, graze_context *context, const graze_scene *scene,
                                 const char *notes) {
    return table_head(out, context, scene, notes,
                      scene->motion->dimension == 2 ? "time,kind,cell,ax,ay,bx,by"
                                                    : "time,kind,cell,ax,ay,az,bx,by,bz",
                      "theta_a,theta_b,orientation,status,chain,form");
}

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
    text_format(out, ",%s,%s,%s,%s,", sign_text(f->theta_a), sign_text(f->theta_b),
                known_name(graze_orientation_name(f->orientation)), graze_trim_name(f->trim));
    text_count(out, f->chain);
    text_format(out, ",%s\n", known_name(graze_chain_form_name(f->form)));
}

graze_status report_patches_header(char **out, graze_context *context, const graze_scene *scene,
                                   const char *notes) {
    return table_head(
        out, context, scene, notes,
        "patch,kind,cell,from,from_near,to,to_near,a,b,theta_a,theta_b,orientation,time",
        scene->motion->dimension == 2 ? "bx,by,x,y,status" : "bx,by,bz,x,y,z,status");
}

graze_status report_joints_header(char **out, graze_context *context, const graze_scene *scene,
                                  const char *notes) {
    return table_head(out, context, scene, notes, "cell,from,from_near,to,to_near,form,patches",
                      NULL);
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
    text_format(out, ",%s,%s,%s,", sign_text(f->theta_a), sign_text(f->theta_b),
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
