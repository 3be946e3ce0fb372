/* The cover by each contact, in words. SPDX-License-Identifier: GPL-3.0-or-later
 *
 * In E^2 a contact covers, to first order, a few sectors between rays of its own arrangement
 * (proofs/topology.md C46). In E^3 a facet's half-space is given and, if first order leaves a plane
 * open, the sides of this plane that the contact covers.
 */
#include "output/report/row_parts.h"

#include "base/context/scope.h"

typedef struct closings_maker {
    text *t;
    graze_context *context;
    const graze_scene *scene;
    const topo_finding *topo;
    int dimension;
} closings_maker;

void closings_form(text *t, const fmpz *normal, int dimension) {
    int first = 1;
    for (int k = 0; k < dimension; k++) {
        if (fmpz_is_zero(normal + k))
            continue;
        text_put(t, first ? "" : " + ");
        if (!fmpz_is_one(normal + k)) {
            text_integer(t, normal + k);
            text_put(t, " ");
        }
        text_format(t, "d%c", "xyz"[k]);
        first = 0;
    }
}

void closings_place(text *t, const graze_scene *scene, const germ *g) {
    static const char *const cells[2][3] = {{"corner", "edge", ""}, {"vertex", "edge", "facet"}};
    const graze_motion *motion = scene->motion;
    size_t k = 0;
    LOCAL(fmpq, time);
    while (motion_tracing(&motion->piece[k], scene->options.operation) != g->map)
        k++;
    if (g->has_time) {
        fmpq_sub(time, motion->piece[k].hi, motion->piece[k].lo);
        fmpq_mul(time, time, &g->time);
        fmpq_add(time, time, motion->piece[k].lo);
        text_put(t, "t = ");
        tell_rational_time(t, motion, time);
        text_put(t, fmpq_is_zero(&g->time)  ? " and after"
                    : fmpq_is_one(&g->time) ? " and before"
                                            : "");
    } else {
        text_put(t, "an irrational t between ");
        tell_rational_time(t, motion, motion->piece[k].lo);
        text_put(t, " and ");
        tell_rational_time(t, motion, motion->piece[k].hi);
    }
    text_format(t, ", %s", cells[motion->dimension - 2][cone_cell_dimension(&g->cone)]);
}

/* Does a germ alone cover a direction? */
static graze_status covers(int *out, const closings_maker *m, germ *g, const fmpz *direction) {
    germ_list alone = {.count = 1, .capacity = 1, .item = g, .bounded = 1};
    germ_cover cover;
    graze_status status = germs_cover(&cover, &alone, m->context, direction);
    *out = !status && cover.covered;
    return status;
}

/* Append a facet's half-space about the point. */
static graze_status put_half_space(const closings_maker *m, germ *g) {
    int d = m->dimension, inside = 0;
    LOCAL_VEC(fmpz, normal, d);
    for (int column = 0; column < d; column++)
        for (int row = 0; row < d; row++)
            fmpz_addmul(normal + column, g->to_body + row * d + column, g->cone.normal + row);
    direction_reduce(normal, d);
    TRY(covers(&inside, m, g, normal));
    closings_form(m->t, normal, d);
    text_put(m->t, inside ? " >= 0" : " <= 0");
    return GRAZE_OK;
}

/* Append the sectors that a germ of E^2 covers. */
static graze_status put_in_plane(const closings_maker *m, germ *g) {
    sector_list found = {0, 0, NULL};
    sector_question asked = {.germ = g, .part = GERM_WHOLE};
    graze_status status = sectors_find(&found, m->context, &asked);
    for (size_t k = 0; k < found.count && !status; k++)
        sentence_put(m->t, k ? "sector-more" : "sector", found.ray + 4 * k, 2,
                     found.ray + 4 * k + 2, 2);
    text_put(m->t, found.all ? "all directions" : found.count ? "" : "no sector");
    sectors_clear(&found);
    return status;
}

/* Append the sides of the open plane that a germ covers. */
static graze_status put_sides(const closings_maker *m, germ *g) {
    int side[2] = {0, 0};
    LOCAL_VEC(fmpz, normal, 3);
    _fmpz_vec_set(normal, m->topo->across, 3);
    for (int k = 0; k < 2; k++) {
        TRY(covers(&side[k], m, g, normal));
        _fmpz_vec_neg(normal, normal, 3);
    }
    if (side[0] || side[1]) {
        text_put(m->t, "; it closes ");
        closings_form(m->t, m->topo->across, 3);
        text_put(m->t, side[0] && side[1] ? " on both sides of 0" : side[0] ? " > 0" : " < 0");
    }
    return GRAZE_OK;
}

static graze_status put_germ(const closings_maker *m, germ *g) {
    text_put(m->t, "  at ");
    closings_place(m->t, m->scene, g);
    text_put(m->t, ": ");
    if (cone_cell_dimension(&g->cone) == m->dimension - 1)
        TRY(put_half_space(m, g));
    else if (m->dimension == 2)
        TRY(put_in_plane(m, g));
    else
        text_format(m->t, "the cone between %lu planes and what its way sweeps",
                    (unsigned long)g->cone.count);
    if (m->topo->has_across)
        TRY(put_sides(m, g));
    text_put(m->t, "\n");
    return GRAZE_OK;
}

static int of_unsweep(const graze_scene *scene) {
    return scene->options.operation == GRAZE_UNSWEEP;
}

static graze_status put_hint(const closings_maker *m, const fmpq *point) {
    int found = 0;
    ulong places = 0;
    LOCAL_VEC(fmpq, near, 3);
    const char *beyond = of_unsweep(m->scene) ? "in" : "out";
    TRY(hint_find(&found, near, &places, m->context, m->scene, point, m->topo));
    if (found)
        sentence_put(m->t, "hint-found", beyond, near, 3, places);
    else
        sentence_put(m->t, "hint-none", beyond);
    return GRAZE_OK;
}

graze_status closings_explain(text *t, graze_context *context, const graze_scene *scene,
                              const fmpq *point, const topo_finding *topo) {
    closings_maker m = {t, context, scene, topo, scene->motion->dimension};
    const plane_list *planes = NULL;
    HELD(germ_list, germs);
    TRY(topo_planes(&planes, context, scene));
    TRY(germs_find(&germs, context, scene, planes, point));
    text_format(
        t, "Contacts, and the directions (dx, dy%s) from P that each covers%s to first order:\n",
        m.dimension == 3 ? ", dz" : "", of_unsweep(scene) ? ", by what is outside the solid," : "");
    for (size_t k = 0; k < germs.count; k++)
        TRY(put_germ(&m, &germs.item[k]));
    if (!germs.bounded)
        text_put(t, "  and some that are not looked at\n");
    return topo->position == GRAZE_TOPO_UNDECIDED && m.dimension == 3 ? put_hint(&m, point)
                                                                      : GRAZE_OK;
}
