/* A validated solid as the rest of Graze sees it: immutable arrays of exact numbers and a search
 * tree. SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The boundary is cut into simplices (validate.h). Each lies in a plane (E^2: a line), kept once
 * for all simplices in it, and is cut out of it by its d side forms. A form is d + 1 coprime
 * integers c; its value at the homogeneous point (X, W) is c[0] X_0 + ... + c[d-1] X_(d-1) + c[d]
 * W.
 */
#ifndef GRAZE_SOLID_SOLID_H
#define GRAZE_SOLID_SOLID_H

#include "solid/soup.h"
#include "solid/tree.h"
#include "solid/validate.h"

struct graze_solid {
    soup input;
    simplices cut;
    size_t plane_count;
    fmpz *plane;        /* plane_count * (d + 1); first non-zero normal coordinate positive */
    uint32_t *plane_of; /* simplex -> plane */
    signed char
        *facing; /* simplex -> +1 if the plane's positive side is outside, -1 if it is inside */
    fmpz *side;  /* cut.count * d * (d + 1): side form k of a simplex, >= 0 on the simplex's side */
    tree boxes;
};

/** Make a solid of a soup, which it takes over (also on failure): validation, side tests, planes,
 * tree. */
graze_status solid_create(graze_solid **out, graze_context *context, soup *input, unsigned flags);

/**
 * Where a point off the boundary lies, by the signed crossings of one ray, made generic by an
 * infinitesimal displacement. `x` are d + 1 homogeneous integers, x[d] > 0.
 * @return I or O; GRAZE_STATE_ABSENT if the crossings add up to neither, which only a fault of ours
 * can bring about
 */
graze_state solid_locate(const graze_solid *solid, const fmpz *x);

/** The boundary cell of simplex s at which the side forms with bit set in `zero` vanish. */
graze_cell solid_cell(const graze_solid *solid, size_t s, unsigned zero);

#endif
