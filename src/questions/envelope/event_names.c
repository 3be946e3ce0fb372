/* Names of events, answers and reasons. SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/context/context.h"
#include "graze/envelope.h"

const char *graze_event_kind_name(graze_event_kind kind) {
    static const char *const names[] = {
        [GRAZE_EVENT_SADDLE] = "saddle", [GRAZE_EVENT_REACH] = "reach",
        [GRAZE_EVENT_MEET] = "meet",     [GRAZE_EVENT_CUSP] = "cusp",
        [GRAZE_EVENT_TURN] = "turn",     [GRAZE_EVENT_SINGULAR] = "singular",
    };
    return name_at(names, sizeof names / sizeof *names, (size_t)kind);
}

const char *graze_decomposable_name(graze_decomposable decomposable) {
    static const char *const names[] = {
        [GRAZE_DECOMPOSABLE_YES] = "yes",
        [GRAZE_DECOMPOSABLE_NO] = "no",
        [GRAZE_DECOMPOSABLE_UNDECIDED] = "undecided",
    };
    return name_at(names, sizeof names / sizeof *names, (size_t)decomposable);
}

const char *graze_decomposable_reason_name(graze_decomposable_reason reason) {
    static const char *const names[] = {
        [GRAZE_REASON_THETA] = "theta is negative on a slice",
        [GRAZE_REASON_REFLEX] = "a slice crosses a reflex edge",
        [GRAZE_REASON_BREAK] = "contact on one side of a break, into the solid on the other",
        [GRAZE_REASON_VERTEX] = "a slice or run reaches a vertex and enters the solid there",
        [GRAZE_REASON_PIECES] = "the motion has a break",
        [GRAZE_REASON_ZERO] = "theta is not positive on a closed slice",
        [GRAZE_REASON_REACHES] =
            "a slice or run reaches a reflex edge or a vertex that is not convex",
        [GRAZE_REASON_POSITIVE] = "theta is positive on all slices, none of them and no run "
                                  "reaches a reflex edge or a vertex that is not convex",
    };
    return name_at(names, sizeof names / sizeof *names, (size_t)reason);
}

const char *graze_curve_kind_name(graze_curve_kind kind) {
    static const char *const names[] = {
        [GRAZE_CURVE_SLICE] = "slice",
        [GRAZE_CURVE_RUN] = "run",
        [GRAZE_CURVE_POINT] = "point",
        [GRAZE_CURVE_WHOLE] = "whole",
    };
    return name_at(names, sizeof names / sizeof *names, (size_t)kind);
}

const char *graze_chain_form_name(graze_chain_form form) {
    static const char *const names[] = {
        [GRAZE_CHAIN_CLOSED] = "closed",
        [GRAZE_CHAIN_OPEN] = "open",
        [GRAZE_CHAIN_BRANCHING] = "branching",
    };
    return name_at(names, sizeof names / sizeof *names, (size_t)form);
}
