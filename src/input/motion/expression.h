/* Expressions in t and s: text to rational function (src/program/cli/formats.md, Motions).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_MOTION_EXPRESSION_H
#define GRAZE_MOTION_EXPRESSION_H

#include "input/motion/quotient.h"

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

#endif
