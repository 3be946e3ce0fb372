/* Names of events, answers and reasons. SPDX-License-Identifier: GPL-3.0-or-later */
#include "graze/envelope.h"

const char *graze_event_kind_name(graze_event_kind kind) {
    switch (kind) {
    case GRAZE_EVENT_SADDLE:
        return "saddle";
    case GRAZE_EVENT_REACH:
        return "reach";
    case GRAZE_EVENT_MEET:
        return "meet";
    case GRAZE_EVENT_CUSP:
        return "cusp";
    case GRAZE_EVENT_TURN:
        return "turn";
    case GRAZE_EVENT_SINGULAR:
        return "singular";
    default:
        return "none";
    }
}

const char *graze_decomposable_name(graze_decomposable decomposable) {
    switch (decomposable) {
    case GRAZE_DECOMPOSABLE_YES:
        return "yes";
    case GRAZE_DECOMPOSABLE_NO:
        return "no";
    case GRAZE_DECOMPOSABLE_UNDECIDED:
        return "undecided";
    default:
        return "none";
    }
}

const char *graze_decomposable_reason_name(graze_decomposable_reason reason) {
    switch (reason) {
    case GRAZE_REASON_THETA:
        return "theta is negative on a slice";
    case GRAZE_REASON_REFLEX:
        return "a slice crosses a reflex edge";
    case GRAZE_REASON_BREAK:
        return "contact on one side of a break, into the solid on the other";
    case GRAZE_REASON_VERTEX:
        return "a slice or run reaches a vertex and enters the solid there";
    case GRAZE_REASON_PIECES:
        return "the motion has a break";
    case GRAZE_REASON_ZERO:
        return "theta is not positive on a closed slice";
    case GRAZE_REASON_REACHES:
        return "a slice or run reaches a reflex edge or a vertex that is not convex";
    case GRAZE_REASON_POSITIVE:
        return "theta is positive on all slices, none of them and no run reaches a reflex edge or "
               "a "
               "vertex that is not convex";
    default:
        return "none";
    }
}

const char *graze_curve_kind_name(graze_curve_kind kind) {
    switch (kind) {
    case GRAZE_CURVE_SLICE:
        return "slice";
    case GRAZE_CURVE_RUN:
        return "run";
    case GRAZE_CURVE_POINT:
        return "point";
    case GRAZE_CURVE_WHOLE:
        return "whole";
    default:
        return "none";
    }
}

const char *graze_chain_form_name(graze_chain_form form) {
    switch (form) {
    case GRAZE_CHAIN_CLOSED:
        return "closed";
    case GRAZE_CHAIN_OPEN:
        return "open";
    case GRAZE_CHAIN_BRANCHING:
        return "branching";
    default:
        return "none";
    }
}
