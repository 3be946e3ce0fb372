/* gcode: the words of one line of a G-code program, and arcs as rational pieces.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_INPUT_CONVERT_GCODE_H
#define GRAZE_INPUT_CONVERT_GCODE_H

#include <mpfr.h>
#include "base/context/context.h"
#include "base/number/json.h"
#include "input/delimited/delimited.h"

/* The words of a line. */

enum { GCODE_CODES = 32, GCODE_LETTERS = 26 };

/** One line of a program. */
typedef struct gcode_block {
    graze_context *context;
    const char *source; /* borrowed */
    unsigned long line;
    unsigned present;            /* bit k: the line has the letter 'A' + k */
    fmpq *value;                 /* the numbers of these letters, of G and M the last one */
    int g[GCODE_CODES], g_count; /* codes of the G words in tenths: 911 is G91.1 */
    int m[GCODE_CODES], m_count; /* likewise of M words */
    char first;                  /* letter of the first word that is not N, or 0 */
    int percent;                 /* the line is a percent sign */
} gcode_block;

/** Read a line, as LinuxCNC and GRBL do: blanks mean nothing, capitals and small letters are alike,
 * comments stand in parentheses or behind a semicolon.
 * @return GRAZE_EINPUT with file and line: a comment that does not end, a macro, an unknown letter,
 * a letter twice or without a number; GRAZE_ELIMIT, GRAZE_ESYSTEM */
graze_status gcode_block_read(gcode_block *b, field line);

/** 1 if the line has a word with this letter. */
int gcode_has(const gcode_block *b, char letter);

/** Fail at the line with a message. */
graze_status gcode_refuse(const gcode_block *b, const char *reason);

/* Arcs, in coordinates in which the first axis turns counter-clockwise to the second, and the third
 * is the axis of the helix. For a clockwise arc the second one is mirrored. */

/** An arc of less than a turn, a full circle, or a helix. All numbers are borrowed. */
typedef struct gcode_arc {
    const fmpq *from, *to; /* three coordinates each */
    const fmpq *radius; /* negative: the arc is longer than half a turn; NULL: `centre` is given */
    fmpq *centre;       /* from the start; two coordinates */
    fmpq *start;        /* from the centre; set by gcode_arc_fit as all below */
    fmpq *quotient;     /* complex, (end - centre) / (start - centre) */
    fmpq *spiral;       /* complex, how far the way from the centre grows; 0: an exact arc */
    fmpq *turn;         /* the angle over 4 pi, within 2^-64 */
    slong bits;         /* corners between pieces are within 2^-bits of the circle of radius 1 */
    unsigned long pieces;
    mpfr_ptr
        error; /* upper bound, of ANGLE_BITS bits; 0: an exact arc. gcode_arc.c has the claim */
} gcode_arc;

/** Find the pieces of an arc.
 * @return GRAZE_EINPUT it has no radius, or its error is greater than the tolerance; GRAZE_ELIMIT;
 * GRAZE_ECANCELED */
graze_status gcode_arc_fit(gcode_arc *a, graze_context *context, const fmpq_t tolerance);

/** Write the two coordinates in the plane of piece k, in s; `mirrored`, the second one negated. The
 * coordinate `which` is 0 or 1. */
void gcode_arc_put(json_writer *w, const gcode_arc *a, unsigned long k, int which, int mirrored);

#endif
