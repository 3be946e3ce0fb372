/* A motion while it is read: pieces, entries, expressions.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_INPUT_MOTION_DRAFT_H
#define GRAZE_INPUT_MOTION_DRAFT_H

#include "input/motion/affine.h"

/* Motions in the making: pieces with rational functions as entries, not yet point maps. */

/** M(t) for t = lo + (hi - lo) u, u in [0, 1]. */
typedef struct draft_piece {
    fmpq_t lo, hi;
    unsigned long row; /* the line of a log from which the piece comes; 0: none */
    int rigid;         /* a piece between key frames: `frame` has its rotation and shift */
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
 * Append a piece, rigid or not, whose values the caller sets. The pointer is valid until the next
 * piece is appended.
 * @return GRAZE_ELIMIT more than the limit `pieces`; GRAZE_ECANCELED; GRAZE_ESYSTEM
 */
graze_status draft_append(draft_piece **out, graze_context *context, draft *d, int rigid);
/** Replace the frame of every rigid piece by its map; draft_relative and draft_follow take no rigid
 * pieces. */
graze_status draft_spread(draft *d, graze_context *context);

/** frame^-1 moving ([IS] eq. 7) from the later start to the earlier end, cut at the breaks of both.
 * Both motions are legal and have no rigid piece, and the same dimension; the first pieces of both
 * have a time in common.
 * @param[out] out empty
 */
graze_status draft_relative(draft *out, graze_context *context, const draft *moving,
                            const draft *frame);

/** Append the motion `next`: its interval becomes [from, from + 1], and each of its maps is applied
 * after `end`, the last map of `out` ([IS] eq. 29). `end` becomes the new last map.
 */
graze_status draft_follow(draft *out, graze_context *context, const draft *next, slong from,
                          affine *end);

/** Set *out to the motion of a legal draft, with rigid pieces or without; to NULL on failure. */
graze_status draft_finish(graze_motion **out, graze_context *context, const draft *d);

/* Expressions in t and s: text to rational function (src/program/cli/formats.md, Motions). */

/**
 * The value of an expression. Numbers are rounded token by token as the context says; a text that
 * is wholly one number token, such as "22/7", is rounded as one.
 *
 *   sum     = product { (+|-) product }
 *   product = signed { (*|/) signed }
 *   signed  = (+|-) signed | power
 *   power   = primary [ ^ [+|-] digits ]
 *   primary = number | t | s | ( sum )
 *
 * @param[out] out  initialised; in lowest terms
 * @param t, s      what the two names stand for, rational functions of one common variable; both
 *                  NULL where only a number makes sense
 * @return GRAZE_EINPUT with the place in the text; GRAZE_ELIMIT digits, degree or depth
 */
graze_status expression_value(fmpz_poly_q_t out, graze_context *context, const char *text,
                              size_t length, const fmpz_poly_q_struct *t,
                              const fmpz_poly_q_struct *s);

/**
 * Read a MOTION and check that it is legal: pieces in order, no pole and no zero determinant on a
 * closed piece, continuous at the breaks; the motions inside it are checked likewise.
 * @param[out] out  uninitialised; the caller clears it, also after a failure
 * @param dimension dimension of the motion around this one, or 0
 * @return GRAZE_EINPUT, GRAZE_EILLEGAL, GRAZE_ELIMIT with file, line and path; GRAZE_ECANCELED
 */
graze_status motion_read_draft(draft *out, graze_context *context, const json *value,
                               int dimension);

/* Motions made of pieces and of keyframes, from parsed JSON. */

/** Read a motion given by pieces, or by keyframes; `out` is empty and has the motion's dimension.
 */
graze_status motion_read_pieces(draft *out, graze_context *context, const json *pieces);
graze_status motion_read_keyframes(draft *out, graze_context *context, const json *keyframes);

#endif
