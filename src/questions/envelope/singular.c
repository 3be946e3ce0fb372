/* Times of contacts of order 4 or more. SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/context/scope.h"
#include "questions/envelope/patch_ends.h"

static graze_status exists_before(int *out, const singular_view *v, const axis *x, size_t k) {
    HELD(algebraic, u);
    algebraic_set_rational(&u, x->sample + k);
    return singular_exists(out, v, &u);
}

/* Is point k of the axis the end of a piece that another piece follows? Such a time is examined as
 * the beginning of the next piece. */
static int is_joint(const graze_envelope *e, size_t piece, const axis *x, size_t k) {
    return k + 1 == x->count && piece + 1 < e->piece_count;
}

/* Add the times of a piece at which the facet has a singular point but not just before or just
 * after, or the reverse. If the determinant is 0 only at single times, add those at which the facet
 * has one. `*past` says whether it has one just before the piece; it is set to the answer just
 * before the piece's end. */
static graze_status watch_points(graze_envelope *e, const singular_view *v, axis *x, int *past) {
    const graze_cell *name = &e->cells.facet[v->facet].name;
    found_event what = {.kind = GRAZE_EVENT_SINGULAR,
                        .facet = *name,
                        .cell = *name,
                        .before = SIGN_NONE,
                        .after = SIGN_NONE};
    int lasting = singular_is_lasting(v);
    for (size_t k = 0; k < x->count; k++) {
        int here = 0, before = *past, after = 0;
        if (k > 0 && lasting)
            TRY(exists_before(&before, v, x, k));
        if (is_joint(e, v->piece, x, k)) {
            *past = before;
            return GRAZE_OK;
        }
        if (judge_is_break(e, v->piece, x, k))
            continue;
        TRY(singular_exists(&here, v, x->point[k]));
        if (k == 0 && v->piece == 0)
            before = here;
        after = here;
        if (k + 1 < x->count && lasting)
            TRY(exists_before(&after, v, x, k + 1));
        if (lasting ? before != here || after != here : here)
            TRY(events_add(&e->events, v->context, &what, v->piece, x->point[k]));
    }
    return GRAZE_OK;
}

graze_status singular_gather(graze_envelope *e, graze_context *context, size_t facet) {
    int past = 0;
    for (size_t piece = 0; piece < e->piece_count; piece++) {
        if (e->still[piece * e->cells.facet_count + facet])
            continue;
        HELD(singular_view, v, e, context, facet, piece);
        if (singular_is_never(&v)) {
            past = 0;
            continue;
        }
        ZEROED(axis, x);
        TRY(singular_axis(&x, &v));
        TRY(watch_points(e, &v, &x, &past));
    }
    return GRAZE_OK;
}
