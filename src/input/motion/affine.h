/* Affine maps whose entries are rational functions of a parameter.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_INPUT_MOTION_AFFINE_H
#define GRAZE_INPUT_MOTION_AFFINE_H

#include <flint/fmpq.h>
#include <flint/fmpz_poly.h>
#include <flint/fmpz_poly_q.h>
#include "input/motion/motion.h"

/* Rational functions of one variable over Q, with the limits acting at every step.
 *
 * Values are FLINT's fmpz_poly_q: numerator and denominator coprime in Z[u], leading coefficient of
 * the denominator positive. Two values within the limits make a result of at most about twice their
 * size, so it is enough to check every result.
 *
 * The cost of a motion in time and memory is the product of its pieces, their degree and the digits
 * of their coefficients, and no limit on one of the three bounds it. So each result counts as work
 * when it is made: w + w^2/64 for a coefficient of w words of 64 bits, and a constant for the
 * operation. A unit of work takes about 100 ns at most, for any number of pieces, degree and
 * digits. */

/** A calculation: after the first failure its operations do nothing and `status` keeps the cause.
 */
typedef struct calculation {
    graze_context *context;
    graze_status status;
} calculation;

void quotient_add(calculation *c, fmpz_poly_q_t out, const fmpz_poly_q_t a, const fmpz_poly_q_t b);
void quotient_sub(calculation *c, fmpz_poly_q_t out, const fmpz_poly_q_t a, const fmpz_poly_q_t b);
void quotient_mul(calculation *c, fmpz_poly_q_t out, const fmpz_poly_q_t a, const fmpz_poly_q_t b);
/** GRAZE_EINPUT when b is the zero function. */
void quotient_div(calculation *c, fmpz_poly_q_t out, const fmpz_poly_q_t a, const fmpz_poly_q_t b);
/** a^n for any integer n, a^0 = 1; GRAZE_EINPUT for a negative power of zero. */
void quotient_power(calculation *c, fmpz_poly_q_t out, const fmpz_poly_q_t a, const fmpz_t n);

/** Bring a quotient of polynomials into lowest terms, the denominator's leading coefficient
 * positive; most pairs are proved coprime modulo a prime (proofs/claims.md C29). */
void quotient_reduce(fmpz_poly_q_t a);
/** common = lcm(common, other), up to the sign; neither is zero. */
void polynomial_widen(fmpz_poly_t common, const fmpz_poly_t other);
/** g = gcd(g, p) in Z[u], up to the sign. */
void polynomial_narrow(fmpz_poly_t g, const fmpz_poly_t p);
/** out = p / divisor, which divides p, not zero. */
void polynomial_divide(fmpz_poly_t out, const fmpz_poly_t p, const fmpz_poly_t divisor);
/** Set `out` to the numerator of a over the denominator `common`, a multiple of a's own. */
void quotient_over(fmpz_poly_t out, const fmpz_poly_q_t a, const fmpz_poly_t common);

void quotient_set_rational(fmpz_poly_q_t out, const fmpq_t value);
/** low + (high - low) u. */
void quotient_set_line(fmpz_poly_q_t out, const fmpq_t low, const fmpq_t high);
/** Set `out` to the value of a at u, which is no pole of a. */
void quotient_at(fmpq_t out, const fmpz_poly_q_t a, const fmpq_t u);
/** out(u) = a(line(u)), where the denominator of `line` is a constant. `out` is not `a`. */
void quotient_substitute(calculation *c, fmpz_poly_q_t out, const fmpz_poly_q_t a,
                         const fmpz_poly_q_t line);
/** Four functions that are made and cleared together. */
typedef struct quotients {
    fmpz_poly_q_t at[4];
} quotients;

void quotients_init(quotients *q);
void quotients_clear(quotients *q);

/** If a is a square in Q(u), set `out` to one of its two roots and return 1; else return 0. */
int quotient_square_root(fmpz_poly_q_t out, const fmpz_poly_q_t a);

/** Count the work of making a. Set GRAZE_ELIMIT in the calculation if a's degree or digits, or all
 * the work done for the motion, exceed the limits. */
void quotient_check(calculation *c, const fmpz_poly_q_t a);

/** quotient_check for a polynomial. */
void polynomial_check(calculation *c, const fmpz_poly_t p);

/** Count work; GRAZE_ELIMIT past the limit `work`. */
void calculation_spend(calculation *c, unsigned long work);

/**
 * Has p, not zero, a root in [0, 1]? If so *found is 1, and low <= r <= high for the least such
 * root r; low = high if r is found to be rational.
 * @return GRAZE_ELIMIT, GRAZE_ECANCELED
 */
graze_status polynomial_root(int *found, fmpq_t low, fmpq_t high, graze_context *context,
                             const fmpz_poly_t p);

/* Affine maps of E^d whose entries are rational functions of one parameter u. */

enum { AFFINE_ENTRIES = POINT_MAP_ENTRIES };

/** P -> A P + b: d rows of d + 1 entries, b last in each row. */
typedef struct affine {
    int dimension;
    fmpz_poly_q_t entry[AFFINE_ENTRIES]; /* all initialised, dimension*(dimension+1) in use */
} affine;

/** The identity of E^d. */
void affine_init(affine *a, int dimension);
void affine_clear(affine *a);
void affine_identity(affine *a);
void affine_set(affine *a, const affine *b);
int affine_equal(const affine *a, const affine *b);

/** The entry of row i and column j, both from 0. */
fmpz_poly_q_struct *affine_at(affine *a, int i, int j);
const fmpz_poly_q_struct *affine_get(const affine *a, int i, int j);

/** out = a after b, that is, the matrix a b. `out` may be a or b. */
void affine_multiply(calculation *c, affine *out, const affine *a, const affine *b);
/** Change a map about the origin to one about `center` (d functions): b += center - A center. */
void affine_about(calculation *c, affine *a, fmpz_poly_q_t *center);
/** out(u) = a(low + (high - low) u). `out` is not `a`. */
void affine_substitute(calculation *c, affine *out, const affine *a, const fmpq_t low,
                       const fmpq_t high);
/** Set `out` to the constant map that a is at u, which is no pole of a. */
void affine_at_time(affine *out, const affine *a, const fmpq_t u);

/* Determinants and inverses of affine maps. */

/** The determinant of the linear part. */
void affine_determinant(calculation *c, fmpz_poly_q_t out, const affine *a);
/** Set `out` to the inverse of a, whose determinant is not the zero function. `orthogonal` is 1 if
 * a's linear part is known to be orthogonal. `out` is not `a`. */
void affine_inverse(calculation *c, affine *out, const affine *a, int orthogonal);

/* Affine maps over two common denominators, and the point maps of such a map and of its inverse. */

/**
 * P -> (N P) / w + B / v with polynomials of u. Invariant: w and the entries of N have no common
 * factor in Z[u], nor have v and the entries of B; w and v are positive at u = 0.
 */
typedef struct common_map {
    int dimension;
    fmpz_poly_struct linear[9]; /* N, dimension * dimension in use, row by row */
    fmpz_poly_struct shift[3];  /* B */
    fmpz_poly_t w, v;
} common_map;

/** Set all polynomials to zero; the caller sets the dimension and the polynomials. */
void common_map_init(common_map *m);
void common_map_clear(common_map *m);

/** The entry of N in row i and column j. */
fmpz_poly_struct *common_map_linear(common_map *m, int i, int j);

/** Set w and v to the least common multiples of the entries' denominators, N and B to the entries
 * times these. The entries are in lowest terms. */
void common_map_from_affine(calculation *c, common_map *out, const affine *a);
void common_map_to_affine(calculation *c, affine *out, const common_map *m);
/** 1 if the linear part is orthogonal, that is, N^T N is w^2 times the identity; else 0, as after a
 * failure. */
int common_map_is_orthogonal(calculation *c, const common_map *m);

/** The point map of m, which has no pole on [0, 1]. @param[out] out initialised */
void common_map_forward(calculation *c, point_map *out, const common_map *m);
/** The point map of the inverse of m, whose linear part is orthogonal.
 * @param[out] out initialised */
void common_map_backward(calculation *c, point_map *out, const common_map *m);

/* The entries of a motion file: JSON values to functions, numbers and integers. */

/** A fault of a motion: when it is found on a stretch, the stretch is read again to refuse the
 * entry that causes the fault.
 */
typedef enum entry_fault { FAULT_NONE, FAULT_POLE, FAULT_SINGULAR } entry_fault;

/** The place part / of in s, which runs from 0 to 1 along the piece as written. */
typedef struct cut_place {
    size_t part, of;
} cut_place;

/** A part of a piece that is being made; u runs from 0 to 1 along the part. */
typedef struct stretch {
    int dimension;
    fmpq *from, *to;    /* ends in s */
    fmpq *lo, *hi;      /* ends in t */
    fmpz_poly_q_t t, s; /* t and s as functions of u */
    entry_fault fault;  /* an entry with this fault on the stretch is refused */
} stretch;

void stretch_init(stretch *part, int dimension);
void stretch_clear(stretch *part);
/** Set the stretch to the part between two places of the piece from t = lo to t = hi. */
void stretch_set(stretch *part, const fmpq_t lo, const fmpq_t hi, const cut_place *ends);

/** Read an expression or a JSON number as a function of u. */
graze_status entry_function(fmpz_poly_q_t out, graze_context *context, const json *value,
                            const stretch *part);
/** As entry_function, but refuse a pole if the stretch's fault is FAULT_POLE. */
graze_status entry_finite(fmpz_poly_q_t out, graze_context *context, const json *value,
                          const stretch *part);
/** Read an array of `count` functions, each as by entry_finite. */
graze_status entry_vector(fmpz_poly_q_t *out, graze_context *context, const json *value,
                          size_t count, const stretch *part);

/** Return GRAZE_EILLEGAL, "... `what` at t = ...", if p, a polynomial in u, is zero or has a root
 * on the stretch from t = lo to t = hi.
 */
graze_status entry_no_root(graze_context *context, const json *where, const fmpz_poly_t p,
                           const fmpq_t lo, const fmpq_t hi, const char *what);

/* The rotation of a quaternion whose numbers are polynomials. */

/**
 * Set the linear part and its denominator to the rotation of a quaternion w, x, y, z, of any
 * length; in E^2 x and y are zero. The four polynomials q are divided by their common factors.
 * @param[in,out] out its dimension is set
 * @return GRAZE_EILLEGAL at `where` if the four vanish together at a t of the stretch [lo, hi]
 */
graze_status quaternion_rotation(common_map *out, graze_context *context, const json *where,
                                 fmpz_poly_struct q[4], const fmpq_t lo, const fmpq_t hi);

/* Rotations of a motion file as affine maps, in rotation.c. `out` is initialised; `value` is the
 * value of the transform's key. */

/** {"tan_half": e, "times": n, "center": [...], "axis": [...]} */
graze_status rotation_by_tangent(affine *out, graze_context *context, const json *value,
                                 const stretch *part);
/** {"quarters": n, "center": [...], "axis": [...]} */
graze_status rotation_by_quarters(affine *out, graze_context *context, const json *value,
                                  const stretch *part);
/** The integer of "quarters" in the value of a turn. */
graze_status rotation_quarters(fmpz_t out, graze_context *context, const json *value);
/** [w, x, y, z], about the origin. */
graze_status rotation_by_quaternion(affine *out, graze_context *context, const json *value,
                                    const stretch *part);

/** Change a rotation or scaling about the origin to one about `center`, an array of functions. */
graze_status about_center(affine *out, graze_context *context, const json *center,
                          const stretch *part);

/**
 * The rotation of a quaternion w, x, y, z, of any length; in E^2 x and y are zero and w + iz is the
 * half angle as a complex number. Only the ratios of the four numbers count, so poles are harmless.
 * @return GRAZE_EILLEGAL at `where` if the four vanish together at a t of the stretch [lo, hi]
 */
graze_status rotation_of(affine *out, graze_context *context, const json *where, fmpz_poly_q_t q[4],
                         const fmpq_t lo, const fmpq_t hi);

/* Transforms of a motion file: JSON to affine maps over a stretch of a piece
 * (src/program/cli/formats.md, Motions). */

/** Places at which the turns of a transform cut the piece, ascending, each once, from 0 to 1; a
 * zeroed structure is an empty list. */
typedef struct cut_list {
    size_t count, capacity;
    cut_place *place;
} cut_list;

void cut_list_clear(cut_list *cuts);
/** @return GRAZE_ELIMIT there are more parts than the limit `pieces`; and as transform_map */
graze_status transform_cuts(cut_list *cuts, graze_context *context, const json *transform);

/**
 * The map of a transform over one stretch between two of its cuts.
 * @param[out] out initialised, of the stretch's dimension
 * @return GRAZE_EINPUT keys, types, expressions; GRAZE_EILLEGAL an axis whose length is not a
 * rational function, vanishes or has a pole, a quaternion that vanishes, or, if the stretch's fault
 * asks for it, an entry with a pole, or a singular scale or matrix; GRAZE_ELIMIT
 */
graze_status transform_map(affine *out, graze_context *context, const json *transform,
                           const stretch *part);

#endif
