/* Roles by the signs of g; at saddles and pinches by the directions that the germs leave open.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/contact/contact.h"

#include <flint/fmpz_vec.h>
#include "base/context/context.h"
#include "base/context/scope.h"
#include "decide/trace/trace.h"
#include "graze/contact.h"
#include "input/solid/solid.h"
#include "questions/contact/nearby.h"
#include "questions/topo/topo.h"

/* The signs of g on one side of t. */
typedef struct g_signs {
    int any, all_positive, all_negative, some_positive, some_negative;
} g_signs;

static g_signs signs_on(const graze_site *s, int side) {
    g_signs out = {0, 1, 1, 0, 0};
    for (size_t k = 0; k < s->germ_count; k++) {
        if (s->germ[k].side != side)
            continue;
        int sign = fmpq_sgn(s->germ[k].speed);
        out.any = 1;
        out.all_positive &= sign > 0;
        out.all_negative &= sign < 0;
        out.some_positive |= sign > 0;
        out.some_negative |= sign < 0;
    }
    return out;
}

/* Is a direction of the body in the germ's cone, or in its sweep along a leading direction? */
static graze_status is_in_germ(int *out, graze_context *context, germ *g, const fmpz *u) {
    graze_state state = GRAZE_STATE_O;
    TRY(cone_state(&state, &g->cone, context, u));
    *out = state != GRAZE_STATE_O;
    for (int k = 0; k < g->side_count && !*out; k++) {
        int in_interior;
        TRY(cone_sweep(&in_interior, out, &g->cone, context, NULL, u, g->side[k].e));
    }
    return GRAZE_OK;
}

/* *out = 1 if the direction u, in the body's space, is in none of the germs (is_in_germ). */
static graze_status is_in_none(int *out, graze_context *context, germ_list *germs, const fmpz *u) {
    int covered = 0;
    for (size_t j = 0; j < germs->count && !covered; j++)
        TRY(is_in_germ(&covered, context, &germs->item[j], u));
    *out = !covered;
    return GRAZE_OK;
}

/* Does a leading direction point into the interior? Then all directions are covered. */
static graze_status leads_inside(int *out, graze_context *context, germ_list *germs) {
    *out = 0;
    for (size_t j = 0; j < germs->count; j++)
        for (int k = 0; k < germs->item[j].side_count && !*out; k++) {
            graze_state state = GRAZE_STATE_O;
            TRY(cone_state(&state, &germs->item[j].cone, context, germs->item[j].side[k].e));
            *out = state == GRAZE_STATE_I;
        }
    return GRAZE_OK;
}

/* Look for an uncovered direction among the outward normals and their sum: often there is one, and
 * no arrangement is needed. */
static graze_status try_normals(int *found, graze_context *context, germ_list *germs,
                                const neighborhood *p) {
    int d = p->dimension;
    LOCAL_VEC(fmpz, sum, d);
    for (size_t k = 0; k < p->count && !*found; k++) {
        _fmpz_vec_add(sum, sum, p->facet[k].normal, d);
        TRY(is_in_none(found, context, germs, p->facet[k].normal));
    }
    if (!*found)
        TRY(is_in_none(found, context, germs, sum));
    return GRAZE_OK;
}

/* Is a direction in a cell of full dimension around ray r covered by none of the germs? All germs,
 * which are of one time, carry a direction to the body alike. */
static graze_status look_for_open(int *found, graze_context *context, germ_list *germs,
                                  const borders *b, size_t r) {
    HELD(ray_cells, cells, b, r);
    LOCAL_VEC(fmpz, u, b->dimension);
    for (size_t k = 0; k < cells.count && !*found; k += b->dimension == 2 ? 1 : 2) {
        germ_to_body(u, &germs->item[0], cells.item + k * (size_t)b->dimension);
        TRY(is_in_none(found, context, germs, u));
    }
    return GRAZE_OK;
}

static graze_status look_everywhere(int *found, graze_context *context, germ_list *germs) {
    int refused = 0;
    HELD(borders, b, germs->item[0].cone.dimension);
    TRY(borders_find(&b, &refused, context, germs));
    if (refused)
        return context_fail(context, GRAZE_ELIMIT,
                            "more planes border what is covered about the point than the %d that "
                            "are looked at",
                            BORDER_PLANES);
    for (size_t r = 0; r < b.ray_count && !*found; r++)
        TRY(look_for_open(found, context, germs, &b, r));
    return GRAZE_OK;
}

/* Do the germs beside t leave a direction open? */
static graze_status look_at_germs(int *out, graze_context *context, const graze_site *s,
                                  const plane_list *planes) {
    int inside = 0;
    HELD(germ_list, germs);
    int both = s->side[0].present && s->side[1].present && s->side[0].piece == s->side[1].piece;
    for (int k = both; k < 2; k++)
        if (s->side[k].present)
            TRY(germs_at(&germs, context, s->scene, planes, s->world, s->side[k].piece,
                         s->side[k].u));
    TRY(leads_inside(&inside, context, &germs));
    if (!inside)
        TRY(try_normals(out, context, &germs, &s->place));
    return inside || *out ? GRAZE_OK : look_everywhere(out, context, &germs);
}

static graze_status is_open_at(int *out, graze_context *context, const graze_site *s) {
    plane_list planes;
    *out = 0;
    TRY(around_planes(&planes, context, s->scene->solid, s->y));
    graze_status status = look_at_germs(out, context, s, &planes);
    planes_clear(&planes);
    return status;
}

graze_status role_decide(graze_role *out, graze_context *context, const graze_site *s) {
    g_signs before = signs_on(s, -1), after = signs_on(s, 1);
    int contact = 0;
    if (s->place.kind == PLACE_OTHER)
        TRY(is_open_at(&contact, context, s));
    else if (s->place.kind == PLACE_REFLEX)
        contact = !(after.any && after.some_positive) && !(before.any && before.some_negative);
    else
        contact = !(after.any && after.all_positive) && !(before.any && before.all_negative);
    *out = contact                                     ? GRAZE_ROLE_CONTACT
           : before.all_positive && after.all_positive ? GRAZE_ROLE_EGRESS
           : before.all_negative && after.all_negative ? GRAZE_ROLE_INGRESS
                                                       : GRAZE_ROLE_HIDDEN;
    return GRAZE_OK;
}

const char *graze_role_name(graze_role role) {
    static const char *const names[] = {
        [GRAZE_ROLE_CONTACT] = "contact",
        [GRAZE_ROLE_EGRESS] = "egress",
        [GRAZE_ROLE_INGRESS] = "ingress",
        [GRAZE_ROLE_HIDDEN] = "hidden",
    };
    return name_at(names, sizeof names / sizeof *names, (size_t)role);
}

const char *graze_trim_name(graze_trim trim) {
    static const char *const names[] = {
        [GRAZE_TRIM_SLIDES] = "slides",   [GRAZE_TRIM_SIMPLE] = "simple",
        [GRAZE_TRIM_MEETS] = "meets",     [GRAZE_TRIM_NEAR] = "trimmed_near",
        [GRAZE_TRIM_FAR] = "trimmed_far",
    };
    return name_at(names, sizeof names / sizeof *names, (size_t)trim);
}

const char *graze_orientation_name(graze_orientation orientation) {
    static const char *const names[] = {
        [GRAZE_ORIENTATION_PRESERVING] = "preserving",
        [GRAZE_ORIENTATION_REVERSING] = "reversing",
        [GRAZE_ORIENTATION_DEGENERATE] = "degenerate",
    };
    return name_at(names, sizeof names / sizeof *names, (size_t)orientation);
}
