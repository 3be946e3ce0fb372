/* A trajectory in doubles, over all pieces of a motion, cut into spans on demand, each with its
 * errors and a bound in space.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_FILTER_CURVE_H
#define GRAZE_FILTER_CURVE_H

#include <float.h>
#include <stddef.h>
#include <stdint.h>
#include "decide/filter/course.h"
#include "input/solid/corners.h"
#include "input/solid/tree.h"

_Static_assert(FLT_EVAL_METHOD == 0, "the filter's bounds are those of arithmetic in double alone");

/** Windows of time are counted in units of 2^-WINDOW_LEVELS of a piece. */
enum { WINDOW_LEVELS = 24, WINDOW_WHOLE = 1 << WINDOW_LEVELS };

/** The part [start, start + 2^(WINDOW_LEVELS - level)] of a piece, local parameter s in [0, 1].
 * Its Bernstein coefficients are the curve's at index * stride, X_0 ... X_(d-1) and W one after the
 * other. Or, of degree 0, several pieces: then there are no coefficients, nor their errors. Where
 * `bounded`, the piece lies in the set { from + s along + r : 0 <= s <= 1, |r_i| <= thick_i }, and
 * `inverse` is 1 / along, coordinate by coordinate (proofs/filter.md C34). */
typedef struct span {
    uint32_t piece; /* the first, for several */
    uint32_t group; /* of degree 0: the course's */
    uint32_t start;
    int level, degree;
    int lost;       /* a piece that is beyond the filter */
    uint32_t child; /* the halves stand at child and child + 1; 0: not cut yet */
    int bounded;
    double from[3], along[3], inverse[3], thick[3];
    double end[3];  /* from + along, rounded */
    double wide[3]; /* `thick` and all errors of a place of the chord against a corner */
    double
        far; /* bound of the distances of the set's places from corners, coordinate by coordinate */
    double bend; /* bound of its distance from the chord; 0 if rounding dominates it: cutting would
                    not make the span thinner */
    double size[4];  /* greatest absolute coefficient of X_0 ... X_(d-1), W on the whole piece */
    double error[4]; /* of the coefficients of X_0 ... X_(d-1), W */
} span;

/** On a span, of D = X - v W for any corner v, coefficient by coordinate (proofs/filter.md C35). */
typedef struct shift_bound {
    double error; /* of a computed D */
    double size;  /* |D| is at most this */
    double speed; /* |dD/ds| is at most this */
} shift_bound;

/** A query point in doubles; the relative error of each coordinate is at most 2^-50. */
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

/** Set the curve that a course gives a point.
 * @param course, corners of the motion and of the solid, kept
 * @return 0 if the numbers are beyond the filter, or without memory */
int curve_set(curve *c, const course *course, const filter_point *point, const corners *corners);

/** Set the segment from a point to a point + direction, as a curve of degree 1.
 * @param at   d + 1 homogeneous coordinates, at[d] > 0, each within error[i] of the exact one */
int curve_set_segment(curve *c, int dimension, const double *at, const double *error,
                      const double *direction, const corners *corners);

/** Add a span for one whole piece; NULL if there are too many spans, or if memory runs out. */
const span *curve_piece(curve *c, size_t piece);

/** Cut a span, unless it is cut, into halves or into two groups of pieces; 0 if there are too many
 * spans, or if memory runs out. Pointers to spans become invalid. */
int curve_cut(curve *c, uint32_t index);

/** The blossom of a polynomial of degree n, at most CARRIER_DEGREE, of Bernstein coefficients: k
 * arguments are `to`, the others `from`. It is coefficient k on [from, to], and the value at `to`
 * where k is n. */
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

/** The coefficients of coordinate i of a span. */
const double *curve_coefficients(const curve *c, const span *piece, int i);

/** 0 if it is certain that the span does not meet the box. */
int span_meets(const span *piece, const box *b);

/** Test as span_meets does, and find the part of the span's chord that can be in the box. */
int span_window(double *from, double *to, const span *piece, const box *b);

/** Is a span so thick that it meets many boxes that its curve misses? It is if the box, enlarged by
 * the thickness, has a much larger surface (in E^2: perimeter): the chance that a chord meets it is
 * proportional to that. 0 if a cut would not make the span thinner. */
static inline int span_is_thick(const curve *c, const span *piece, const box *b) {
    const double most = 1.2; /* measured: less cuts in vain, more tests long triangles in vain */
    double x = b->high[0] - b->low[0], y = b->high[1] - b->low[1], z = b->high[2] - b->low[2];
    double wx = x + 2 * piece->thick[0], wy = y + 2 * piece->thick[1], wz = z + 2 * piece->thick[2];
    if (piece->bend <= 0)
        return 0;
    if (c->dimension == 2)
        return wx + wy > most * (x + y);
    return wx * (wy + wz) + wy * wz > most * (x * (y + z) + y * z);
}

#endif
