/* A validated solid as the rest of Graze sees it: immutable arrays of exact numbers and a search
 * tree. SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The boundary is cut into simplices (validate.h). Each lies in a plane (E^2: a line), kept once
 * for all simplices in it, and is cut out of it by its d side forms. A form is d + 1 coprime
 * integers c; its value at the homogeneous point (X, W), W > 0, is c[0] X_0 + ... + c[d-1] X_(d-1)
 * + c[d] W.
 */
#ifndef GRAZE_SOLID_SOLID_H
#define GRAZE_SOLID_SOLID_H

#include "solid/corners.h"
#include "solid/soup.h"
#include "solid/tree.h"
#include "solid/validate.h"

struct graze_solid {
    soup input;
    simplices cut;
    size_t plane_count;
    fmpz *plane; /* plane_count * (d + 1); the first non-zero normal coordinate is positive */
    uint32_t *plane_of;  /* simplex -> plane */
    signed char *facing; /* simplex -> +1 if its plane form is positive outside, -1 if inside */
    fmpz *side;          /* cut.count * d * (d + 1): side form k of a simplex, >= 0 on its side; the
                            coordinate of the first non-zero normal coordinate does not occur in it */
    tree boxes;
    corners corners;
};

/** Make a solid of a soup, which it takes over (also on failure): validation, planes, tree, side
 * tests. */
graze_status solid_create(graze_solid **out, graze_context *context, soup *input, unsigned flags);

/** Plane form of a simplex, and its side form k < d. */
const fmpz *solid_plane(const graze_solid *solid, size_t simplex);
const fmpz *solid_side(const graze_solid *solid, size_t simplex, int k);

/** Sign of a form at a homogeneous point. */
int form_sign(const fmpz *form, const fmpz *x, int dimension);

/**
 * Where a point lies: I, B or O. Counts the signed crossings of one ray, made generic by an
 * infinitesimal displacement (proofs/claims.md). `x` are d + 1 homogeneous integers, x[d] > 0.
 * @return GRAZE_STATE_ABSENT if the crossings add up to neither, which only a fault of ours can
 * bring about
 */
graze_state solid_locate(const graze_solid *solid, const fmpz *x);

/** The boundary cell of a simplex at which just the side forms with their bit set in `zero` vanish.
 */
graze_cell solid_cell(const graze_solid *solid, size_t simplex, unsigned zero);

/**
 * One side test per component of the boundary: the winding number must be 1 on the inner side and 0
 * on the outer side of one facet of it; then it is so for all (proofs/claims.md).
 */
graze_status solid_check_sides(const graze_solid *solid, graze_context *context);

#endif
