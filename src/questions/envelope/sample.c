/* Draws contact points at random. SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/context/scope.h"
#include "base/number/vector.h"
#include "base/number/random.h"
#include "questions/envelope/patch_ends.h"

/* Is a time strictly within its piece? */
static int is_inner_time(const graze_time *time) {
    return !algebraic_is_rational(&time->u) ||
           (!fmpq_is_zero(time->u.value) && !fmpq_is_one(time->u.value));
}

/* A gap: an interval of a piece between the times with the numbers `from` and `to`; SIZE_MAX stands
 * for an end of the piece.
 */
typedef struct time_gap {
    size_t piece, from, to;
} time_gap;

/* Find the gap whose number is `wanted` modulo the number of gaps. */
static time_gap find_time_gap(const graze_envelope *e, unsigned long wanted) {
    const event_list *list = &e->events;
    size_t inner = 0;
    for (size_t k = 0; k < list->time_count; k++)
        inner += is_inner_time(list->time[k]) ? 1 : 0;
    size_t left = wanted % (inner + e->piece_count);
    time_gap gap = {0, SIZE_MAX, SIZE_MAX};
    for (size_t k = 0; k < list->time_count; k++) {
        if (!is_inner_time(list->time[k]))
            continue;
        for (; gap.piece < list->time[k]->piece; gap.piece++, gap.from = SIZE_MAX)
            if (left-- == 0)
                return gap;
        gap.to = k;
        if (left-- == 0)
            return gap;
        gap.from = k;
        gap.to = SIZE_MAX;
    }
    for (; left > 0; left--, gap.from = SIZE_MAX)
        gap.piece++;
    return gap;
}

/* Draw a rational parameter strictly between the ends of a gap; up to three random halvings may
 * move it towards one of them. */
static graze_status pick_parameter(fmpq_t out, graze_context *context, const graze_envelope *e,
                                   const time_gap *gap, random_stream *r) {
    HELD(algebraic, low);
    HELD(algebraic, high);
    HELD(algebraic, middle);
    fmpq_one(high.value);
    if (gap->from != SIZE_MAX)
        algebraic_set(&low, &e->events.time[gap->from]->u);
    if (gap->to != SIZE_MAX)
        algebraic_set(&high, &e->events.time[gap->to]->u);
    TRY(algebraic_between(out, context, &low, &high));
    for (size_t steps = random_below(r, 4); steps > 0; steps--) {
        algebraic_set_rational(&middle, out);
        TRY(random_below(r, 2) ? algebraic_between(out, context, &low, &middle)
                               : algebraic_between(out, context, &middle, &high));
    }
    return GRAZE_OK;
}

graze_status sample_make(graze_site *out, int *found, graze_context *context,
                         const graze_envelope *e, unsigned long seed, unsigned long index) {
    int d = e->cells.dimension;
    random_stream r;
    graze_curve curve = {.count = 0};
    random_seed(&r, seed, index);
    time_gap gap = find_time_gap(e, index);
    const motion_piece *piece = &e->scene->motion->piece[gap.piece];
    LOCAL(fmpq, t);
    LOCAL_VEC(fmpq, y, d);
    *found = 0;
    TRY(pick_parameter(t, context, e, &gap, &r));
    motion_time_at(t, piece, t);
    TRY(contact_curve_find(&curve, context, e, t));
    graze_status status = GRAZE_OK;
    if (curve.count) {
        const curve_part *part = &curve.part[random_below(&r, curve.count)];
        LOCAL(fmpq, lambda); /* of a point strictly between the part's ends if these differ */
        fmpq_set_si(lambda, (slong)random_below(&r, 15) + 1, 16);
        vector_between(y, part->a, part->b, lambda, d);
        status = site_make(out, context, e->scene, t, y);
        *found = !status;
    }
    contact_curve_clear(&curve);
    return status;
}
