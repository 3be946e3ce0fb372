/* The public functions of sites.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "api/api.h"

#include "output/report/report.h"
#include "questions/contact/contact.h"

/* Create a site at the point y; if `in_world`, the caller's point is P, and the inverse map carries
 * it to y. */
static graze_status create(graze_site **out, graze_context *context, const graze_scene *scene,
                           const mpq_t time, graze_rationals point, int in_world,
                           const graze_cell *cell) {
    LOCAL_VEC(fmpq, y, scene->motion->dimension);
    LOCAL(fmpq, t);
    TRY(api_rational(t, context, time));
    TRY(api_point(y, context, scene, point));
    if (in_world)
        TRY(site_to_body(y, context, scene, t));
    CREATE(out, made, free,
           cell ? site_snap(made, context, scene, t, y, cell)
                : site_make(made, context, scene, t, y));
}

static graze_status check_and_create(graze_site **out, graze_context *context,
                                     const graze_scene *scene, const mpq_t time,
                                     graze_rationals point, const char *function, int in_world,
                                     const graze_cell *cell) {
    EMPTY(out);
    GIVEN_TO(function, out, context, scene, time, point);
    if (scene->options.operation != GRAZE_SWEEP)
        return api_misuse(context, function, "the scene is an unsweep; expected a sweep");
    TRY(api_takes(context, function, scene->solid));
    IN_ENVIRONMENT();
    return create(out, context, scene, time, point, in_world, cell);
}

graze_status graze_site_create(graze_site **out, graze_context *context, const graze_scene *scene,
                               const mpq_t time, graze_rationals point) {
    return check_and_create(out, context, scene, time, point, "graze_site_create", 0, NULL);
}

graze_status graze_site_create_at(graze_site **out, graze_context *context,
                                  const graze_scene *scene, const mpq_t time,
                                  graze_rationals world) {
    return check_and_create(out, context, scene, time, world, "graze_site_create_at", 1, NULL);
}

graze_status graze_site_snap(graze_site **out, graze_context *context, const graze_scene *scene,
                             const mpq_t time, graze_rationals point, graze_cell cell) {
    return check_and_create(out, context, scene, time, point, "graze_site_snap", 0, &cell);
}

graze_status graze_site_snap_at(graze_site **out, graze_context *context, const graze_scene *scene,
                                const mpq_t time, graze_rationals world, graze_cell cell) {
    return check_and_create(out, context, scene, time, world, "graze_site_snap_at", 1, &cell);
}

int graze_site_shift(mpq_t out, const graze_site *site) {
    if (!site || !site->snapped || site->missed)
        return 0;
    fmpq_get_mpq(out, site->shift);
    return 1;
}

DESTROYER(graze_site, site_clear(of))
FACT(graze_site_facts, graze_site_get, graze_site, of->facts, (graze_site_facts){0})

void graze_site_point(mpq_t *body, mpq_t *world, const graze_site *site) {
    if (!body || !world || !site)
        return;
    api_point_out(body, site->y, site->dimension);
    api_point_out(world, site->world, site->dimension);
}

FACT(const graze_time *, graze_site_near, graze_site, of->near, NULL)
FACT(const graze_time *, graze_site_near_in, graze_site, of->near_in, NULL)

const graze_trace *graze_site_trace(const graze_site *site) {
    return site && !site->missed ? &site->trace : NULL;
}

FACT(size_t, graze_site_germ_count, graze_site, of->germ_count, 0)

graze_site_germ graze_site_germ_at(mpq_t speed, mpq_t drift, mpq_t theta, const graze_site *site,
                                   size_t index) {
    graze_site_germ out = {0};
    if (index >= graze_site_germ_count(site))
        return out;
    const site_germ *germ = &site->germ[index];
    out.facet = site->place.facet[germ->facet].name;
    out.side = germ->side;
    out.order = germ->order;
    out.sign = germ->sign;
    if (speed && drift && theta) {
        fmpq_get_mpq(speed, germ->speed);
        fmpq_get_mpq(drift, germ->drift);
        fmpq_get_mpq(theta, germ->theta);
    }
    return out;
}

graze_status graze_site_header(char **out, graze_context *context, const graze_scene *scene,
                               const char *notes, const char *columns) {
    PUBLIC_OUT(out, context, scene);
    return report_table_head(out, context, scene, TABLE_SITES, notes, columns);
}

graze_status graze_site_row(char **out, graze_context *context, const graze_site *site,
                            graze_format format, const char *rest) {
    PUBLIC_OUT(out, context, site);
    REFUSED(format != GRAZE_FORMAT_CSV && format != GRAZE_FORMAT_JSONL, "the format is unknown");
    HELD(text, t);
    if (format == GRAZE_FORMAT_CSV)
        report_contact_csv(&t, site, rest);
    else
        report_contact_json(&t, site);
    return text_finish(out, context, &t);
}
