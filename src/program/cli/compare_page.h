/* The page of a comparison.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CLI_COMPARE_PAGE_H
#define GRAZE_CLI_COMPARE_PAGE_H

#include "program/run/load.h"

/**
 * Write the golden points as a page that marks those on which the candidate is wrong. The scene is
 * that of the options' solid and motion, with what the golden table's head says of it. Returns an
 * exit status and says what is wrong.
 */
int compare_page(const char *file, const char *golden, const char *candidate,
                 const graze_compare_options *options, const context_options *context);

#endif
