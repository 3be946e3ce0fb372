/* Parts that graze validate shares with graze compare.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CLI_COMPARE_H
#define GRAZE_CLI_COMPARE_H

#include "graze.h"

/** Do the options of a comparison go together? Returns an exit status and says what is wrong. */
int compare_check(const graze_compare_options *o);

#endif
