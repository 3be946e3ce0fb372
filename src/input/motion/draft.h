/* Motions in the making: pieces with rational functions as entries, not yet point maps.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_MOTION_DRAFT_H
#define GRAZE_MOTION_DRAFT_H

#include "input/motion/common_map.h"

/** M(t) for t = lo + (hi - lo) u, u in [0, 1]. */
typedef struct draft_piece {
    fmpq_t lo, hi;
    unsigned long row; /* the line of the log that it comes from; 0: none is given */
    int rigid; /* between key frames: a rotation with its shift, which is to become point maps */
    union {
        affine map;       /* unless rigid */
        common_map frame; /* if rigid */
    };
} draft_piece;

/** Pieces in order, each following the one before it. */
typedef struct draft {
    int dimension;
    size_t count, capacity;
    draft_piece *piece;
} draft;

void draft_init(draft *d, int dimension);
void draft_clear(draft *d);
/**
 * One more piece at the end, its values to be set; it lives until the next call.
 * @return GRAZE_ELIMIT more than the limit `pieces`; GRAZE_ECANCELED; GRAZE_ESYSTEM
 */
graze_status draft_append(draft_piece **out, graze_context *context, draft *d);
/** draft_append for a rigid piece. */
graze_status draft_append_rigid(draft_piece **out, graze_context *context, draft *d);
/** Give every rigid piece its map: later steps take drafts without rigid pieces. */
graze_status draft_spread(draft *d, graze_context *context);

/**
 * frame^-1 moving ([IS] eq. 7), cut at the breaks of both. The two have one dimension and one
 * interval and are legal.
 * @param[out] out empty
 */
graze_status draft_relative(draft *out, graze_context *context, const draft *moving,
                            const draft *frame);

/**
 * Append `next`, run after all that is in `out`: its own interval becomes [from, from + 1], and
 * every position of it is taken after `end`, the end of what came before ([IS] eq. 29). `end` is
 * moved on to the end of `next`.
 */
graze_status draft_follow(draft *out, graze_context *context, const draft *next, slong from,
                          affine *end);

/** The motion of a legal draft, rigid or not; `out` is NULL on failure. */
graze_status draft_finish(graze_motion **out, graze_context *context, const draft *d);

#endif
