/* Times of contacts of order 4 or more. SPDX-License-Identifier: GPL-3.0-or-later */
#include "questions/envelope/envelope.h"

#include "base/context/scope.h"
#include "questions/envelope/patch_ends.h"
#include "questions/envelope/sign_events.h"

static graze_status exists_before(int *out, const singular_view *v, const axis *x, size_t k) {
    HELD(algebraic, u);
    algebraic_set_rational(&u, x->sample + k);
    return singular_exists(out, v, &u);
}

/* Is point k of the axis the end of a piece before another one? It is looked at as the beginning
 * of that. */
static int is_joint(const graze_envelope *e, size_t piece, const axis *x, size_t k) {
    return k + 1 == x->count && piece + 1 < e->piece_count;
}

/* A time is an event if it has what one of the times beside it has not, or the reverse; where the
 * determinant vanishes for an instant alone, if it has such a point. `*past` is what there is just
 * before the piece, then what there is before its end. */
static graze_status watch_points(graze_envelope *e, const singular_view *v, axis *x, int *past) {
    const graze_cell *name = &e->cells.facet[v->facet].name;
    found_event what = {.kind = GRAZE_EVENT_SINGULAR,
                        .facet = *name,
                        .cell = *name,
                        .before = SIGN_NONE,
                        .after = SIGN_NONE};
    int lasting = singular_is_lasting(v);
    graze_status status = GRAZE_OK;
    for (size_t k = 0; k < x->count && !status; k++) {
        int here = 0, before = *past, after = 0;
        if (k > 0 && lasting)
            status = exists_before(&before, v, x, k);
        if (status || is_joint(e, v->piece, x, k)) {
            *past = before;
            break;
        }
        if (judge_is_break(e, v->piece, x, k))
            continue;
        status = singular_exists(&here, v, x->point[k]);
        if (k == 0 && v->piece == 0)
            before = here;
        after = here;
        if (!status && k + 1 < x->count && lasting)
            status = exists_before(&after, v, x, k + 1);
        if (!status && (lasting ? before != here || after != here : here))
            status = events_add(&e->events, v->context, &what, v->piece, x->point[k]);
    }
    return status;
}

graze_status singular_gather(graze_envelope *e, graze_context *context, size_t facet) {
    graze_status status = GRAZE_OK;
    int past = 0;
    for (size_t piece = 0; piece < e->piece_count && !status; piece++) {
        singular_view v;
        if (e->still[piece * e->cells.facet_count + facet])
            continue;
        singular_view_make(&v, e, context, facet, piece);
        if (singular_is_never(&v)) {
            past = 0;
        } else {
            axis x;
            status = singular_axis(&x, &v);
            if (!status)
                status = watch_points(e, &v, &x, &past);
            axis_clear(&x);
        }
        singular_view_clear(&v);
    }
    return status;
}
