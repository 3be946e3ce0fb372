/* Milling tools, cylinders, balls and boxes as polyhedra inside and outside of them.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A body of revolution about the z axis is the points (x, y, z) with (hypot(x, y), z) in its
 * profile: a flat bottom of radius `flat` at z = 0, an arc of radius `corner` about (flat, corner),
 * tangent to the bottom, up to a normal (cos b, sin b), a straight side across that normal, and a
 * flat top at `height`. -b is the taper, the angle of the side with the axis, positive where the
 * tool is wider above; b = 90 degrees is a ball without a side. All such bodies are convex.
 *
 * The ring of corner k of profile point i is (r_i u_k, z_i), u_k the corners of a convex polygon
 * about the circle's centre, so that four corners of neighbouring rings lie in a plane.
 */
#ifndef GRAZE_CONVERT_TOOL_H
#define GRAZE_CONVERT_TOOL_H

#include <flint/fmpq.h>
#include "base/number/text.h"

/** A body of revolution. Of b only rational bounds are known: `low` and `high` are points (cos,
 * sin) of the circle, low's angle the greater one, so that the body with `low` lies in it and the
 * one with `high` around it. They are equal where b is exact. */
typedef struct tool {
    fmpq_t flat, corner, height;
    fmpq low[2], high[2];
    int ball;
} tool;

void tool_init(tool *s);
void tool_clear(tool *s);

/** The numbers of a tool: diameter where the corner is widest, corner radius, taper in degrees,
 * length. */
typedef struct tool_numbers {
    fmpq_t diameter, corner, taper, length;
} tool_numbers;

void tool_numbers_init(tool_numbers *n);
void tool_numbers_clear(tool_numbers *n);

/** The body of these numbers, its tip at the origin, its axis z; of a ball the diameter counts.
 * @return GRAZE_EUSE there is no such body */
graze_status tool_take(tool *s, graze_context *context, const tool_numbers *given, int ball);

/** A profile from the bottom to the top: `count` pairs r, z. */
typedef struct profile {
    size_t count;
    fmpq *point;
} profile;

/** Both polyhedra: `sides` corners u_k of an inscribed polygon; those outside have the corners
 * stretch u_k, and as many profile points, each near the other's. */
typedef struct tool_pair {
    profile in, out;
    size_t sides;
    fmpq *corner;
    fmpq_t stretch;
} tool_pair;

/** Make both with that many sides and pieces of the arc, coordinates of directions on a grid of
 * 2^-bits. tool_pair_clear in any case. */
void tool_pair_make(tool_pair *out, const tool *s, size_t sides, size_t pieces, slong bits);
void tool_pair_clear(tool_pair *p);

/**
 * Decide exactly whether the inner polyhedron is a convex part of the body, the body is a part of
 * the outer one, which is convex too, and no corner is further than `tolerance` from its partner:
 * then either is within `tolerance` of the body (proof in tool_check.c).
 * @param[out] square the largest square of the distance of partners
 */
int tool_pair_holds(fmpq_t square, const tool_pair *p, const tool *s, const fmpq_t tolerance);

/** Make both within a tolerance, which is positive.
 * @param[out] out    for tool_pair_clear, on success alone
 * @param[out] square as tool_pair_holds
 * @return GRAZE_EUSE it is too fine; GRAZE_ELIMIT, GRAZE_ECANCELED */
graze_status tool_fit(tool_pair *out, fmpq_t square, graze_context *context, const tool *s,
                      const fmpq_t tolerance);

/** What was made, and how near: a report. */
void tool_report(text *out, const tool_pair *p, const fmpq_t square);

/** Write one of both as OFF, moved by `at` (NULL: not): `factor` times the corners. */
void tool_write(text *out, const profile *p, const tool_pair *pair, const fmpq_t factor,
                const fmpq *at);
/** A box from the origin, of these sides. */
void tool_write_box(text *out, const fmpq *size, const fmpq *at);

#endif
