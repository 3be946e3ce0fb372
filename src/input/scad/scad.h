/* scad: the text of a `.csg.json` file of OpenSCAD's `.csg`.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_INPUT_SCAD_H
#define GRAZE_INPUT_SCAD_H

#include "base/number/json.h"

/** Changes to a file that the caller allows. */
typedef struct scad_choice {
    int smooth; /* a number of sides, $fn, stands for a round surface */
    const fmpq
        *near_rotation; /* an exact rotation, times a scale, is taken instead of a linear part
                   whose entries over the scale are as near to it as this; NULL: none is */
} scad_choice;

/* A `.csg.json` file of OpenSCAD's `.csg` file. */

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
