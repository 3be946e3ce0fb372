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
#include "base/context/context.h"

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

#endif
