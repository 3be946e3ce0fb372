/* A plane of space that is not one of the axes', with coordinates u and v.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * All of it is rational, so that points of the plane are exact: its points are origin + u way[0] +
 * v way[1]. The origin is the plane's point nearest to that of space; way[0] is horizontal, and
 * way[1] is the cross product of the normal and way[0]: upwards where the normal is not. Both are
 * orthogonal to one another and of length 1 to within 2^-50, as a length is not rational.
 */
#ifndef GRAZE_DRAW_SECTION_H
#define GRAZE_DRAW_SECTION_H

#include <flint/fmpq.h>
#include "base/number/text.h"
#include "output/draw/panel.h"

typedef struct section {
    fmpq normal[3], place; /* normal . x = place */
    fmpq origin[3], way[2][3];
    projection look;             /* to u and v */
    double unit[3], unit_height; /* normal and place, the normal of length 1 */
} section;

/** @param out    uninitialised; section_clear in any case
 * @param normal three rationals, not all 0 */
void section_make(section *out, const fmpq *normal, const fmpq_t place);
void section_clear(section *s);

/** The point of u and v, three rationals. */
void section_point(fmpq *out, const section *s, const fmpq *uv);
/** 1 if a point lies in the plane. */
int section_holds(const section *s, const fmpq *point);
/** A rectangle of the plane that holds what it has of a box and little more; 0 if it does not pass
 * inside.
 * @param[out] low, high u and v each
 * @param box_low, box_high three rationals each */
int section_extent(fmpq *low, fmpq *high, const section *s, const fmpq *box_low,
                   const fmpq *box_high);

/** Its equation, as x + 2*y - 1/2*z = 3. */
void section_equation(text *out, const section *s);
/** Origin and ways in rounded decimals, and in exact numbers as attributes of SVG. */
void section_describe(text *out, const section *s);
void section_attributes(text *out, const section *s);

#endif
