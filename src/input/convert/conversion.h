/* Motion files from angles in degrees, screws, joints and lists of poses.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The result is a text in the form of a motion file, read and checked before it is handed out, and
 * a report of the approximations with proved bounds.
 */
#ifndef GRAZE_CONVERT_CONVERSION_H
#define GRAZE_CONVERT_CONVERSION_H

#include "base/number/text.h"

/** A motion file and its report in the making; for text_init and text_clear. */
typedef struct conversion {
    text motion, report;
} conversion;

#endif
