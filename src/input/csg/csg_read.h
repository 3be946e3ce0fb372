/* Curved solids of `.csg.json` files (src/program/cli/formats.md, Curved solids).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CSG_CSG_READ_H
#define GRAZE_CSG_CSG_READ_H

#include "input/csg/csg.h"

/** 1 if a file of this name has a curved solid. */
int csg_is_named(const char *path);

/**
 * Read a file.
 * @param[out] out    on success cleared by csg_clear
 * @param[out] sha256 of the file's bytes
 * @return GRAZE_ESYSTEM, GRAZE_EINPUT, GRAZE_EILLEGAL, GRAZE_ELIMIT, GRAZE_ECANCELED
 */
graze_status csg_read(csg *out, unsigned char sha256[32], graze_context *context, const char *path);

/** As csg_read, from text, which messages call `name`. */
graze_status csg_read_text(csg *out, graze_context *context, const char *name, const char *text,
                           size_t length);

#endif
