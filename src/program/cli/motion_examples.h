/* Examples of motion files.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CLI_MOTION_EXAMPLES_H
#define GRAZE_CLI_MOTION_EXAMPLES_H

/** Motion files that have every key, each one line of JSON behind a `#` line that says what it
 * shows. */
extern const char motion_examples[];

#endif
