/* Answers contact points: each is a site of the scene, and a row.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/context/scope.h"
#include "base/number/text.h"
#include "program/points/points.h"
#include "program/run/results.h"

static graze_status make_site(graze_site **out, graze_context *context, const graze_scene *scene,
                              const site_rows *rows, size_t row) {
    const site_form *form = &rows->columns->sites;
    graze_rationals number = rows->number + row * (size_t)rows->columns->numbers;
    if (form->snap)
        return (form->in_world ? graze_site_snap_at : graze_site_snap)(
            out, context, scene, number[0], number + 1, rows->cell[row]);
    return (form->in_world ? graze_site_create_at : graze_site_create)(out, context, scene,
                                                                       number[0], number + 1);
}

static graze_status add_site_row(text *out, graze_context *context, const graze_scene *scene,
                                 const site_rows *rows, graze_format format, size_t row) {
    graze_site *site = NULL;
    char *line = NULL;
    graze_status status = make_site(&site, context, scene, rows, row);
    if (!status)
        status = graze_site_row(&line, context, site, format, rows->texts[row].rest);
    if (!status)
        text_put(out, line);
    graze_free(line);
    graze_site_destroy(site);
    return status;
}

graze_status site_answer(row_run *r, graze_context *context, const graze_scene *scene,
                         const site_rows *rows, graze_format format) {
    struct row_text *table = &r->out[RESULT_TABLE];
    graze_status status = GRAZE_OK;
    HELD(text, all);
    while (r->done < rows->count && !status) {
        status = add_site_row(&all, context, scene, rows, format, r->done);
        r->done += !status;
    }
    table->length = all.length;
    if (all.failed)
        r->done = 0;
    table->text = text_take(&all);
    return table->text || status ? status : GRAZE_ESYSTEM;
}
