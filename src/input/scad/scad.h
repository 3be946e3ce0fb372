/* scad: makes the text of a `.csg.json` file from OpenSCAD's `.csg`.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_INPUT_SCAD_H
#define GRAZE_INPUT_SCAD_H

#include "base/number/json.h"

/** Changes to a file that the caller allows. */
typedef struct scad_choice {
    int smooth; /* from this number of sides on, $fn stands for a round surface, and a smaller one
                 * for as many sides; 1: always; 0: a number of sides is refused */
    /* A linear part whose entries, divided by a scale, differ from those of a rotation or
     * reflection by at most this is replaced by the rotation or reflection times the scale; NULL:
     * none is. */
    const fmpq *near_rotation;
} scad_choice;

/* A `.csg.json` file of OpenSCAD's `.csg` file. */

/**
 * Write the solid of a text. Each node stands in the line in which the text has it, so messages on
 * what is written name lines of the text.
 * @param[out] out initialised
 * @param[out] report lines on rotations that were taken; initialised
 * @param[out] note a line on parts that are empty, initialised; stays empty if none is
 * @return GRAZE_EINPUT the text is not as OpenSCAD writes it, or has a node that is not taken;
 * GRAZE_EILLEGAL nothing is left of the solid, or a primitive has no interior, as a sphere of
 * radius 0; GRAZE_ELIMIT `depth`, `cells`; GRAZE_ECANCELED; GRAZE_ESYSTEM
 */
graze_status scad_write(text *out, text *report, text *note, graze_context *context,
                        const char *source, const char *bytes, size_t length,
                        const scad_choice *choice);

#endif
