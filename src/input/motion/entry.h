/* The entries of a motion file: JSON values to functions, numbers and integers.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_MOTION_ENTRY_H
#define GRAZE_MOTION_ENTRY_H

#include "input/motion/json_tree.h"
#include "input/motion/quotient.h"

/** Fault for which an entry is refused while the entry that makes a motion illegal is searched for.
 */
typedef enum entry_fault { FAULT_NONE, FAULT_POLE, FAULT_SINGULAR } entry_fault;

/** The part of a piece that is being made, with u in [0, 1] running along it. */
typedef struct stretch {
    int dimension;
    fmpq_t from, to;    /* in s, which runs from 0 to 1 along the piece as written */
    fmpq_t lo, hi;      /* the same in t */
    fmpz_poly_q_t t, s; /* as functions of u */
    entry_fault fault;  /* fault for which an entry is refused on this stretch, beside bad input */
} stretch;

/** All of a piece lo < hi; dimension d. */
void stretch_init(stretch *part, int dimension, const fmpq_t lo, const fmpq_t hi);
void stretch_clear(stretch *part);
/** Narrow to [from, to] in s. */
void stretch_set(stretch *part, const fmpq_t lo, const fmpq_t hi, const fmpq_t from,
                 const fmpq_t to);

/** The function of u an expression or a JSON number stands for. */
graze_status entry_function(fmpz_poly_q_t out, graze_context *context, const json *value,
                            const stretch *part);
/** entry_function that refuses a pole on a stretch whose fault is FAULT_POLE. */
graze_status entry_finite(fmpz_poly_q_t out, graze_context *context, const json *value,
                          const stretch *part);
/** An array of `count` such functions. */
graze_status entry_vector(fmpz_poly_q_t *out, graze_context *context, const json *value,
                          size_t count, const stretch *part);
/** A number, as JSON number or as expression without t and s. */
graze_status entry_number(fmpq_t out, graze_context *context, const json *value);
/** A number that is an integer. */
graze_status entry_integer(fmpz_t out, graze_context *context, const json *value);

/** GRAZE_EILLEGAL "... `what` at t = ..." if p has a root on the stretch [lo, hi] of t, or is zero.
 */
graze_status entry_no_root(graze_context *context, const json *where, const fmpz_poly_t p,
                           const fmpq_t lo, const fmpq_t hi, const char *what);

#endif
