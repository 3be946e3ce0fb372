/* Making a solid.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_SOLID_CREATE_H
#define GRAZE_SOLID_CREATE_H

#include "input/solid/solid.h"

/** Make a solid of a soup, which it takes over (also on failure): validation, bounds,
 * tree, side tests. */
graze_status solid_create(graze_solid **out, graze_context *context, soup *input, unsigned flags);

/** Read a curved solid (csg_read). `sha256` is that of a file read before, or NULL. */
graze_status solid_create_curved(graze_solid **out, graze_context *context, const char *path,
                                 const unsigned char *sha256);

/** Read a curved solid from text (csg_read_text).
 * @param sha256 that of the file that the text is, or is made of */
graze_status solid_create_curved_text(graze_solid **out, graze_context *context, const char *name,
                                      const char *text, size_t length,
                                      const unsigned char sha256[32]);

/** GRAZE_EINPUT: a file is not the one that was validated. */
graze_status solid_is_another(graze_context *context, const char *path);

#endif
