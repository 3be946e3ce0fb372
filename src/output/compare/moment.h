/* Times as tables of contact points have them: a number, or `root(c0 c1 ...;a;b)`.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_COMPARE_MOMENT_H
#define GRAZE_COMPARE_MOMENT_H

#include "input/delimited/field.h"

/** The forms, for messages. */
#define MOMENT_FORMS "1/2 or root(-1 0 2;0;1)"

/** Is a field a root: whole numbers with a blank between each two, at least three, and the two ends
 * of an interval? Equal roots are equal text (src/program/cli/formats.md, Contact points). */
int moment_is_root(field f);
/** Is it a number token or a root? */
int moment_is_token(field f);

/** Is it the same time? Numbers go by their value after rounding. GRAZE_EINPUT, GRAZE_ELIMIT. */
graze_status moment_same(int *same, graze_context *context, field a, field b);

#endif
