/* Writes a picture's bytes.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_DRAW_SAVE_H
#define GRAZE_DRAW_SAVE_H

#include "base/number/text.h"

/** Write bytes into a file, or, for `-.svg` and other names that are `-` and an ending, to standard
 * output. @return GRAZE_ESYSTEM */
graze_status save_file(graze_context *context, const char *file, const text *bytes);

#endif
