/* A `.csg.json` file of OpenSCAD's `.csg` file.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_SCAD_SCAD_WRITE_H
#define GRAZE_SCAD_SCAD_WRITE_H

#include "input/scad/writer.h"

/** Whether a file of this name is one of OpenSCAD's. */
int scad_is_named(const char *path);

/**
 * Write the solid of a text. Each node stands in the line in which the text has it, so messages on
 * what is written name lines of the text.
 * @param[out] out    initialised
 * @param[out] report lines on rotations that were taken; initialised
 * @return as scad_parse, and GRAZE_EILLEGAL for a primitive that there is not
 */
graze_status scad_write(text *out, text *report, graze_context *context, const char *source,
                        const char *bytes, size_t length, const scad_choice *choice);

#endif
