/* bounds: trajectories in doubles with proved bounds of errors, tested against simplices and boxes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_DECIDE_BOUNDS_H
#define GRAZE_DECIDE_BOUNDS_H

#include <float.h>
#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include "base/number/doubles.h"
#include "base/number/dyadic.h"
#include "input/motion/motion.h"
#include "input/solid/solid.h"

/* Point maps of a motion in doubles, which carry query points in the filter. */

/** Polynomials of higher degree are left to the exact path. */
enum { CARRIER_DEGREE = 32 };

/** Larger numbers are left to the exact path, so that no product leaves the range of doubles. */
#define CARRIER_REACH 0x1p200

/** A point map on [0, 1], all its polynomials scaled by one positive number so that the largest
 * Bernstein coefficient of the weight lies in [1/2, 1). Each number differs from the exact one by
 * at most 2^-52 of itself. */
typedef struct carrier {
    int usable;            /* 0: nothing below is set; degree or size is beyond the filter */
    int dimension, degree; /* degree >= 1 */
    double *entry;         /* coefficient k of entry (i, j) at (i (d + 1) + j)(degree + 1) + k */
    double *weight;        /* degree + 1 coefficients; behind the entries, freed with them */
    struct carrier *half;  /* the two halves of the map, if a weight is too small to divide by,
                            * recursively to some level; else NULL; freed with the carrier */
} carrier;

/** The filter divides by a coefficient of the weight only if it is greater than this. */
#define CARRIER_LEAST_WEIGHT 0x1p-40

/** Convert a map, with halves; 0 if memory runs out, else 1. */
int carrier_make(carrier *out, const point_map *map);
/** Convert a map on a dyadic part of [0, 1], on which the parameter runs from 0 to 1, without
 * halves. */
int carrier_make_on(carrier *out, const point_map *map, const dyadic_interval *part);
void carrier_clear(carrier *c);

/* All pieces of a motion in doubles, under a tree in time, which carry query points in the filter.
 */

/** Successive pieces of a motion. If `bounded`, the matrix of each of their maps P -> A P + b, at
 * any
 * time, is a mean of matrices first + s (last - first) + R with s in [0, 1] and |R| <= off, entry
 * by entry (proofs/filter.md C34); entry (i, j) is at i (d + 1) + j, the translation at j = d. */
typedef struct piece_group {
    uint32_t child; /* groups at child and child + 1; 0: one piece, and only `piece` is set besides
                     */
    uint32_t piece; /* the first one */
    int bounded;
    double first[POINT_MAP_ENTRIES], last[POINT_MAP_ENTRIES], off[POINT_MAP_ENTRIES];
} piece_group;

typedef struct course {
    int dimension, degree; /* degree: the largest of any piece */
    size_t piece_count, group_count;
    carrier *piece;
    piece_group *group; /* group 0 is the whole motion */
} course;

/** Convert the point maps that carry query points; 0 if memory runs out. */
int course_make(course *out, const graze_motion *motion, graze_operation operation);
void course_clear(course *c);

/* A trajectory in doubles, over all pieces of a motion, cut into spans on demand, each with its
 * errors and a bound in space. */

_Static_assert(FLT_EVAL_METHOD == 0, "the filter's bounds are those of arithmetic in double alone");

/** Windows of time are counted in units of 2^-WINDOW_LEVELS of a piece. */
enum { WINDOW_LEVELS = 24, WINDOW_WHOLE = 1 << WINDOW_LEVELS };

/** The part [start, start + 2^(WINDOW_LEVELS - level)] of a piece, local parameter s in [0, 1]. Its
 * Bernstein coefficients are the curve's at index * stride, X_0 ... X_(d-1) and W one after the
 * other. A span of degree 0 is several whole pieces and has no coefficients and no errors. If
 * `bounded`, the curve on the span lies in the set { from + s along + r : 0 <= s <= 1, |r_i| <=
 * thick_i }, and `inverse` is 1 / along, coordinate by coordinate (proofs/filter.md C34). */
typedef struct span {
    uint32_t piece; /* the piece, or the first of several */
    uint32_t group; /* for degree 0: the span's group of the course */
    uint32_t start;
    int level, degree;
    int lost;       /* the piece is beyond the filter; nothing below is set */
    uint32_t child; /* the halves stand at child and child + 1; 0: not cut yet */
    int bounded;
    double from[3], along[3], inverse[3], thick[3];
    double end[3];  /* from + along, rounded */
    double wide[3]; /* `thick` plus all errors of the difference of a place on the chord and a
                     * corner */
    double
        far; /* bound of the distances of the set's places from corners, coordinate by coordinate */
    double bend;     /* bound of the curve's distance from the chord; 0 if rounding dominates it:
                      * cutting would not make the span thinner */
    double size[4];  /* greatest absolute coefficient of X_0 ... X_(d-1), W on the whole piece */
    double error[4]; /* errors of the coefficients of X_0 ... X_(d-1), W */
} span;

/** Bounds on a span for each coordinate of D = X - v W, for any corner v (proofs/filter.md C35). */
typedef struct shift_bound {
    double error; /* error of each coefficient of D as it is computed */
    double size;  /* |D| is at most this */
    double speed; /* |dD/ds| is at most this */
} shift_bound;

/** A query point in doubles; the relative error of each coordinate is at most 2^-50, but for those
 * below about 2^-1000, which are 0 (proofs/filter.md). */
typedef struct filter_point {
    double at[3];
} filter_point;

/** A curve with its spans; span 0 is all of it. One thread reuses it from query to query. */
typedef struct curve {
    int dimension;
    filter_point point;
    const course *course;   /* borrowed; NULL for a segment */
    const corners *corners; /* borrowed */
    size_t stride, count, capacity, room;
    span *spans;
    double *coefficients;
    int out_of_memory;
} curve;

void curve_init(curve *c);
void curve_clear(curve *c);

/** Set the curve on which a course carries a point.
 * @param course, corners of the motion and of the solid, borrowed
 * @return 0 if the numbers are beyond the filter, or if memory runs out */
int curve_set(curve *c, const course *course, const filter_point *point, const corners *corners);

/** Set the segment from a point to a point + direction, as a curve of degree 1.
 * @param at   d + 1 homogeneous coordinates, at[d] > 0, each within error[i] of the exact one */
int curve_set_segment(curve *c, int dimension, const double *at, const double *error,
                      const double *direction, const corners *corners);

/** Find the span of one whole piece, cutting groups as needed; NULL if there are too many spans, or
 * if memory runs out. Other pointers to spans become invalid. */
const span *curve_piece(curve *c, size_t piece);

/** Cut a span, unless it is cut, into halves or into two groups of pieces; 0 if there are too many
 * spans, or if memory runs out. Pointers to spans become invalid. */
int curve_cut(curve *c, uint32_t index);

/** The blossom of the polynomial with Bernstein coefficients c[0 ... n], n at most CARRIER_DEGREE:
 * k of its n arguments are `to`, the others `from`. That is Bernstein coefficient k on [from, to];
 * for k = n it is the value at `to`. */
double curve_blossom(const double *c, int n, int k, double from, double to);

/** The homogeneous point at s of a span, by de Casteljau's scheme.
 * @param[out] error of each of the d + 1 coordinates */
void curve_at(double *at, double *error, const curve *c, const span *piece, double s);

/** Find a box around all places whose homogeneous coordinates differ from the given ones by at most
 * `off`; 0 if the weight's sign is not certain. */
int place_bound(box *out, const double *place, const double *off, int dimension);

/** Make a span of a box; its chord is the box's middle.
 * @param shape only its dimension and its corners are used */
void span_of_box(span *out, const curve *shape, const box *b);

shift_bound curve_shift(const curve *c, const span *piece);

/** The Bernstein coefficients of coordinate i of a span, of its weight for i = d. */
const double *curve_coefficients(const curve *c, const span *piece, int i);

/** 0 if it is certain that the span does not meet the box. */
int span_meets(const span *piece, const box *b);

/** Test as span_meets does, and find the part [from, to] of the chord, parameters in [0, 1], whose
 * places, enlarged by the thickness, can be in the box. */
int span_window(double *from, double *to, const span *piece, const box *b);

/** Is a span so thick that it meets many boxes that its curve misses? It is if the box, enlarged by
 * the thickness, has a much larger surface (in E^2: perimeter): the chance that a chord meets it is
 * proportional to that. 0 if a cut would not make the span thinner. */
static inline int span_is_thick(const curve *c, const span *piece, const box *b) {
    const double most = 1.2; /* measured: a smaller value cuts in vain, a larger one tests long
                              * triangles in vain */
    double x = b->high[0] - b->low[0], y = b->high[1] - b->low[1], z = b->high[2] - b->low[2];
    double wx = x + 2 * piece->thick[0], wy = y + 2 * piece->thick[1], wz = z + 2 * piece->thick[2];
    if (piece->bend <= 0)
        return 0;
    if (c->dimension == 2)
        return wx + wy > most * (x + y);
    return wx * (wy + wz) + wy * wz > most * (x * (y + z) + y * z);
}

/* A polynomial on a span, in Bernstein form and in doubles: its signs, and its one root. */

/** Polynomials of higher degree are left to the exact path; up to this degree all binomials are
 * doubles.
 */
enum { PULLBACK_DEGREE = 56 };

/** Coefficients 0 to `degree`, with bounds of all their errors and of their absolute values. */
typedef struct pullback {
    int degree;
    double *at;
    double error, size;
} pullback;

/** A window [low, high] of a span's parameter, in [0, 1]; `enters`: the crossing is from outside to
 * inside. */
typedef struct meet_window {
    double low, high;
    int enters;
} meet_window;

/** Conclusions from the signs of a pullback's coefficients. */
typedef struct pullback_signs {
    int first, last; /* signs of the coefficients 0 and n; 0: not certain */
    int one;         /* all coefficients have the sign `first` */
    int single;      /* the signs change once, whatever that of a single uncertain coefficient */
} pullback_signs;

/** The sign of a value with an error; 0 where it is not certain. */
static inline int pullback_sign(double value, double error) {
    return value > error ? 1 : value < -error ? -1 : 0;
}

/** Set the size from the coefficients. */
void pullback_measure(pullback *p);

/** Subdivide coefficients of degree n into those of both halves. */
void pullback_halve(double *left, double *right, const double *x, int n);

pullback_signs pullback_read(const pullback *p);

/** Find a window with certain ends around the one root of a pullback whose signs are `single`; 0 if
 * none is found. `enters` is unchanged (proofs/filter.md C36). */
int pullback_window(meet_window *out, const pullback *p);

/* Decision sites of the filter, numbered so that a test build can falsify one at a time. */

/** The places at which the filter says "certain" and an answer depends on it. Three of them have no
 * number, because an error there does not show: that a window holds the one root (the guess in its
 * middle is near the root all the same), that a simplex's normal is not zero (the signs of its
 * sides have errors of their own and ask), that a ray ends outside (no scene makes that doubtful).
 */
typedef enum flip_site {
    FLIP_BOX,          /* a span, or a block of bricks, misses a box */
    FLIP_CHORD_PLANE,  /* a thick chord is on one side of a simplex's plane */
    FLIP_CHORD_BESIDE, /* where a thick chord can be in the plane, it is beside the simplex */
    FLIP_ONE_SIGN,     /* a plane's pullback has one sign on a span */
    FLIP_ONE_ROOT,     /* a plane's pullback has just one root on a span */
    FLIP_BESIDE,       /* the whole span is beside the simplex */
    FLIP_ROOT_OUTSIDE, /* the root's window is beside the simplex */
    FLIP_ROOT_INSIDE,  /* the root's window is inside the simplex */
    FLIP_SIDE_INSIDE,  /* at a time in a simplex's plane the curve is inside one of its sides */
    FLIP_DIRECTION,    /* a crossing enters */
    FLIP_APART,        /* two windows of time have no point in common */
    FLIP_FAR,          /* a place is outside the solid's box */
    FLIP_FIRST,        /* a crossing is the first of a ray, or the ray has none */
    FLIP_WEIGHT,       /* a span's weights are positive */
    FLIP_GROUP,        /* the weights of several pieces are positive */
    FLIP_ALONE,        /* a crossing is the only contact at its time */
    FLIP_CELL,         /* a box of points misses a box, or a simplex */
    FLIP_JOIN,         /* nothing of the boundary is between a box of points and a place */
    FLIP_INTERIOR,     /* a place is in bricks of one state */
    FLIP_SLAB,         /* a span, or a box, misses a slab */
    FLIP_SURFACE_SIGN, /* a surface's pullback has one sign on a part of a span */
    FLIP_SURFACE_ROOT, /* a surface's pullback has just one root on a part of a span */
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

/* The normal of a simplex in doubles. */

/** The normal of a simplex's plane, outward, and a bound for the error of each coordinate
 * (proofs/filter.md C35). */
typedef struct normal {
    double at[3], error;
} normal;

/** The normal of a segment in E^2. */
static inline void normal_plane(normal *out, const double *v, double corner_error) {
    out->at[0] = v[3] - v[1];
    out->at[1] = v[0] - v[2];
    out->at[2] = 0;
    out->error =
        FILTER_SLACK * (UNIT_ROUNDING * largest3(out->at) + 2 * corner_error) + FILTER_FLOOR;
}

/** The normal of a triangle in E^3. */
static inline void normal_space(normal *out, const double *v, double corner_error) {
    double a[3], b[3];
    for (int i = 0; i < 3; i++) {
        a[i] = v[3 + i] - v[i];
        b[i] = v[6 + i] - v[i];
    }
    cross3(out->at, a, b);
    double la = largest3(a), lb = largest3(b);
    out->error = FILTER_SLACK * (9 * UNIT_ROUNDING * la * lb + 4 * corner_error * (la + lb) +
                                 8 * corner_error * corner_error) +
                 FILTER_FLOOR;
}

static inline void normal_of(normal *out, const double *v, double corner_error, int dimension) {
    if (dimension == 2)
        normal_plane(out, v, corner_error);
    else
        normal_space(out, v, corner_error);
}

/** The coordinate along which a simplex is projected; -1 if it is not certain that the normal is
 * not zero. */
static inline int normal_axis(const normal *n, int dimension) {
    if (dimension == 2)
        return 0;
    double x = fabs(n->at[0]), y = fabs(n->at[1]), z = fabs(n->at[2]);
    int axis = y > x ? 1 : 0;
    double most = y > x ? y : x;
    axis = z > most ? 2 : axis;
    most = z > most ? z : most;
    return most > n->error ? axis : -1;
}

/* Tests whether a span's thick chord misses a simplex; for most pairs this spares the Bernstein
 * forms. */

/** Only CHORD_MISSES is proved; the other values suggest the next test. */
typedef enum chord_meeting {
    CHORD_MISSES,  /* at no time of the closed span is the curve on the closed simplex */
    CHORD_PIERCES, /* all of the thick chord seems to go through the interior */
    CHORD_NEAR     /* the chord is too thick to tell */
} chord_meeting;

/**
 * @param corner d corners of d coordinates, outward oriented (validate.h)
 * @param corner_error each coordinate of `corner` is within this of the exact one */
chord_meeting chord_meets(const curve *c, const span *piece, const double *corner,
                          double corner_error);

/**
 * 0 if it is certain that a bounded span meets no simplex of the slab (proofs/slabs.md C93).
 * @param wide the span's `wide`; with larger bounds the answer holds for every curve that lies
 * within them of the chord */
static inline int chord_meets_slab(const span *piece, const double wide[3], const slab *s) {
    double first = 0, last = 0, bound = 0;
    for (int i = 0; i < 3; i++) {
        first += s->normal[i] * piece->from[i];
        last += s->normal[i] * piece->end[i];
        bound += fabs(s->normal[i]) * wide[i];
    }
    bound = FILTER_SLACK * bound + FILTER_FLOOR;
    return !flip(FLIP_SLAB, (first - bound > s->high && last - bound > s->high) ||
                                (first + bound < s->low && last + bound < s->low));
}

/* Tests whether the common points of two simplices of the boundary can be on a thick chord. */

/**
 * @param wide a bounded span, widened by the cell (point_box_widen); its set is tested
 * @return 0 if it is certain that no place of the set is on both closed simplices
 * (proofs/judging.md C116) */
int common_place_is_near(const graze_solid *solid, const span *wide, uint32_t a, uint32_t b);

/** May simplex b have a point in the relative interior of simplex a? 0 if it is certain that it has
 * none (proofs/judging.md C116). */
int may_rest_inside(const graze_solid *solid, uint32_t a, uint32_t b);
/** Find the corners of b that are corners of a too, as a mask; 0 unless it is certain that the
 * common points of both closed simplices are in the convex hull of these corners. */
int common_corners(unsigned *of_b, const graze_solid *solid, uint32_t a, uint32_t b);

#endif
