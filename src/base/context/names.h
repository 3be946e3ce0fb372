/* Names of the values of an enum.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CONTEXT_NAMES_H
#define GRAZE_CONTEXT_NAMES_H

#include <stddef.h>

/** names[value], or "none" for a value beyond `count` or without a name. */
const char *name_at(const char *const *names, size_t count, size_t value);

#endif
