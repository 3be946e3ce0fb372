/* Decision sites of the filter, numbered so that a test build can falsify one at a time.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_FILTER_FLIP_H
#define GRAZE_FILTER_FLIP_H

/** The places at which the filter says "certain" and an answer depends on it. Three of them have no
 * number, because an error there does not show: that a window holds the one root (the guess in its
 * middle is near the root all the same), that a simplex's normal is not zero (the signs of its
 * sides have errors of their own and ask), that a ray ends outside (no scene makes that doubtful).
 */
typedef enum flip_site {
    FLIP_BOX,          /* a span, or a block of bricks, misses a box */
    FLIP_CHORD_PLANE,  /* a thick chord is on one side of a simplex's plane */
    FLIP_CHORD_BESIDE, /* where it can be in the plane it is beside the simplex */
    FLIP_ONE_SIGN,     /* a plane's pullback has one sign on a span */
    FLIP_ONE_ROOT,     /* it has just one root there */
    FLIP_BESIDE,       /* the whole span is beside the simplex */
    FLIP_ROOT_OUTSIDE, /* the root's window is beside the simplex */
    FLIP_ROOT_INSIDE,  /* it is inside */
    FLIP_SIDE_INSIDE,  /* at a time of a plane it is inside one side */
    FLIP_DIRECTION,    /* a crossing enters */
    FLIP_APART,        /* two windows of time have no point in common */
    FLIP_FAR,          /* a place is outside the solid's box */
    FLIP_FIRST,        /* a crossing is the first of a ray, or the ray has none */
    FLIP_WEIGHT,       /* a span's weights are positive */
    FLIP_GROUP,        /* so are those of several pieces */
    FLIP_ALONE,        /* a crossing is the only contact at its time */
    FLIP_CELL,         /* a box of points misses a box, or a simplex */
    FLIP_JOIN,         /* nothing of the boundary is between a box of points and a place */
    FLIP_INTERIOR,     /* a place is in bricks of one state */
    FLIP_SLAB,         /* a span, or a box, misses a slab */
    FLIP_SURFACE_SIGN, /* a surface's pullback has one sign on a part of a span */
    FLIP_SURFACE_ROOT, /* it has just one root there */
    FLIP_SURFACE_BOX,  /* a span misses the boxes of surfaces */
    FLIP_SPEED,        /* a box of points enters by a simplex */
    FLIP_PIERCE,       /* a simplex goes through a whole box of points */
    FLIP_SEAM,         /* simplices have no place in common near a box of points */
    FLIP_SITE_COUNT
} flip_site;

#ifdef GRAZE_FLIP_SITES
/** Return the decision. At the site that GRAZE_FLIP_SITE names one in 10^4 of the calls with a
 * decision 0 returns 1, a false certainty; at FLIP_DIRECTION and FLIP_SPEED one in 10^4 of all
 * calls returns the contrary. */
int flip(flip_site site, int decision);
#else
static inline int flip(flip_site site, int decision) {
    (void)site;
    return decision;
}
#endif

#endif
