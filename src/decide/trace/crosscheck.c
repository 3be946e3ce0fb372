/* The filter checked against the exact path. SPDX-License-Identifier: GPL-3.0-or-later */
#include "decide/trace/trace.h"

#include "base/context/scope.h"

static const uint32_t WHOLE = UINT32_C(1) << WINDOW_LEVELS;

static graze_status expect_state(tracer *r, size_t piece, uint32_t at, graze_state expected) {
    graze_state state = GRAZE_STATE_ABSENT;
    LOCAL(fmpq, u);
    fmpq_set_ui(u, at, WHOLE);
    TRY(tracer_locate(&state, r, piece, u));
    if (state != expected)
        return context_fail(r->context, GRAZE_EINTERNAL,
                            "a certain crossing and an exact location disagree on a state");
    return GRAZE_OK;
}

graze_status crosscheck_crossing(tracer *r, size_t piece, int enters) {
    last_seen last = r->last;
    r->last = (last_seen){1, piece, enters ? GRAZE_STATE_I : GRAZE_STATE_O, 0};
    if (!last.any || last.after != GRAZE_STATE_ABSENT)
        return GRAZE_OK;
    /* No window opens the piece of a crossing that comes first in it, so 0 is off the boundary. */
    return expect_state(r, piece, last.piece == piece ? last.to : 0,
                        enters ? GRAZE_STATE_O : GRAZE_STATE_I);
}

graze_status crosscheck_window(tracer *r, size_t piece, uint32_t from, uint32_t to) {
    last_seen last = r->last;
    r->last = (last_seen){1, piece, GRAZE_STATE_ABSENT, to};
    if (!last.any || last.after == GRAZE_STATE_ABSENT)
        return GRAZE_OK;
    /* No window closes the piece of a crossing that comes last in it, so its end is off the
     * boundary. */
    return expect_state(r, last.piece, last.piece == piece ? from : WHOLE, last.after);
}
