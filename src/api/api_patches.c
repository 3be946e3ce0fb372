/* The public functions of patches and joints.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "api/api.h"

#include "output/report/report.h"
#include "questions/envelope/envelope.h"

graze_status graze_patches_create(graze_patches **out, graze_context *context,
                                  const graze_envelope *envelope) {
    PUBLIC_OUT(out, context, envelope);
    CREATE(out, made, free, patches_make(made, context, envelope));
}

DESTROYER(graze_patches, patches_clear(of))
FACT(size_t, graze_patches_count, graze_patches, of->count, 0)

graze_patch graze_patches_at(const graze_patches *patches, size_t index) {
    graze_patch none = {0};
    return index < graze_patches_count(patches) ? patches->item[index].facts : none;
}

void graze_patches_sample(mpq_t time, mpq_t *body, mpq_t *world, const graze_patches *patches,
                          size_t index) {
    if (!time || !body || !world || index >= graze_patches_count(patches))
        return;
    const patch *item = &patches->item[index];
    fmpq_get_mpq(time, item->t);
    api_point_out(body, item->body, patches->envelope->cells.dimension);
    api_point_out(world, item->world, patches->envelope->cells.dimension);
}

FACT(size_t, graze_patches_joint_count, graze_patches, of->joint_count, 0)

graze_patch_joint graze_patches_joint(const graze_patches *patches, size_t index) {
    graze_patch_joint out = {0};
    if (index >= graze_patches_joint_count(patches))
        return out;
    const patch_joint *joint = &patches->joint[index];
    out.cell = joint->cell;
    out.from = patches->moments.time[joint->from];
    out.to = patches->moments.time[joint->to];
    out.form = joint->form;
    out.count = joint->count;
    out.patch = patches->member + joint->first;
    return out;
}

graze_status graze_patches_header(char **out, graze_context *context,
                                  const graze_envelope *envelope, const char *notes) {
    PUBLIC_OUT(out, context, envelope);
    return report_table_head(out, context, envelope->scene, TABLE_PATCHES, notes, NULL);
}

graze_status graze_patches_joint_header(char **out, graze_context *context,
                                        const graze_envelope *envelope, const char *notes) {
    PUBLIC_OUT(out, context, envelope);
    return report_table_head(out, context, envelope->scene, TABLE_JOINTS, notes, NULL);
}

/* Make the two times of a row canonical, and then write the row. */
static graze_status finish_row(char **out, graze_context *context, const graze_patches *patches,
                               size_t index, size_t from, size_t to,
                               void (*report)(text *, const graze_patches *, size_t)) {
    HELD(text, t);
    TRY(time_canonicalise(patches->moments.time[from], context));
    TRY(time_canonicalise(patches->moments.time[to], context));
    report(&t, patches, index);
    return text_finish(out, context, &t);
}

graze_status graze_patches_row(char **out, graze_context *context, const graze_patches *patches,
                               size_t index) {
    PUBLIC_OUT(out, context, patches);
    REFUSED(index >= patches->count, "there is no such patch");
    const patch *item = &patches->item[index];
    return finish_row(out, context, patches, index, item->from, item->to, report_patch);
}

graze_status graze_patches_joint_row(char **out, graze_context *context,
                                     const graze_patches *patches, size_t index) {
    PUBLIC_OUT(out, context, patches);
    REFUSED(index >= patches->joint_count, "there is no such joint");
    const patch_joint *joint = &patches->joint[index];
    return finish_row(out, context, patches, index, joint->from, joint->to, report_joint);
}
