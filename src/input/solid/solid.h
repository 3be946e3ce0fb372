/* A validated solid for tracing, pictures and reports: immutable arrays of exact numbers and a
 * search tree. SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The boundary is cut into simplices (validate.h). Each lies in a plane (E^2: a line) and is cut
 * out of it by its d side forms (forms.h). Large boundaries are asked about few of their simplices,
 * so forms are made when asked for and not kept here (known.h keeps a few for a thread).
 */
#ifndef GRAZE_SOLID_SOLID_H
#define GRAZE_SOLID_SOLID_H

#include "input/csg/csg.h"
#include "input/solid/corners.h"
#include "input/solid/slabs.h"
#include "input/solid/skin.h"
#include "input/solid/tree.h"
#include "input/soup/soup.h"
#include "input/validate/simplices.h"

struct graze_solid {
    unsigned long number; /* no other solid of the process has had it; not 0 */
    soup input;
    simplices cut;
    /* vertex_count * d bounds of the coordinates: low[i] <= coordinates[i] <= high[i]. They are
     * equal where a coordinate is a double, subnormal ones left out, and at most few ulps apart;
     * infinite past the range of doubles. */
    double *low, *high;
    tree boxes; /* of the simplices */
    corners corners;
    slabs slabs;
    char note[256]; /* note on an unusual input; "" if none */
    csg *curved;    /* a curved solid: then of the above only number, dimension and hash are set */
};

/** The boundary of a solid that is not curved, as searches take it; borrowed. */
static inline skin solid_skin(const graze_solid *solid) {
    return (skin){&solid->input, &solid->cut, solid->low, solid->high, &solid->boxes};
}

/** Whether a box that holds the solid is known: 1 unless it is curved. */
int solid_bounded(const graze_solid *solid);
/** That box: the least one, of a curved solid one that holds it. */
void solid_box(fmpq *low, fmpq *high, const graze_solid *solid);

/**
 * Plane form of a simplex: the first non-zero normal coordinate is positive, so that simplices of
 * one plane have one form.
 * @param[out] out d + 1 initialised integers
 * @return +1 if the form is positive on the simplex's outer side, -1 if on its inner one
 */
int solid_plane(fmpz *out, const graze_solid *solid, size_t simplex);

/**
 * Side form k < d of a simplex: not negative where the simplex is; the coordinate of the plane's
 * first non-zero normal coordinate does not occur in it.
 * @param plane the simplex's plane form
 */
void solid_side(fmpz *out, const graze_solid *solid, size_t simplex, const fmpz *plane, int k);

/** The boundary cell of a simplex at which just the side forms with their bit set in `zero` vanish,
 * as the simplex names it; the input's names are cut.names' (cell_names.h). */
graze_cell solid_cell(const graze_solid *solid, size_t simplex, unsigned zero);

#endif
