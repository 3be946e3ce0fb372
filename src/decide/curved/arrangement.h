/* Directions about a point of a curved solid: arrangements of planes, circuits, apexes, series.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_DECIDE_CURVED_ARRANGEMENT_H
#define GRAZE_DECIDE_CURVED_ARRANGEMENT_H

#include "decide/curved/walker.h"

/* Expansions of polynomials that vanish at a point of the trajectory, over the field of a moment.
 *
 * With c = X / W and x = c + v / W, W^degree f(x) is a polynomial in v with coefficients in Z[u]:
 * the factor W^degree is positive and changes no sign. */

/** Bound of an expansion's degree, reached by a minor of the gradients of two surfaces; and the
 * number of terms of at most this degree in three variables. */
enum { TAYLOR_DEGREE = 2 * CSG_DEGREE - 2, TAYLOR_TERMS = 84 };

/** The sum of coefficient[k] v^power[k]; powers are distinct and coefficients not zero. */
typedef struct taylor {
    int dimension, degree; /* degree: a bound */
    size_t count;
    value *coefficient; /* TAYLOR_TERMS */
    unsigned char power[TAYLOR_TERMS][3];
} taylor;

/** Begin with 0; if memory runs out the field fails. */
void taylor_init(taylor *t, moment_field *f, int dimension);
void taylor_clear(taylor *t);

/** The powers of a trajectory's polynomials X_i and W as elements, up to a degree. */
typedef struct taylor_point {
    value *power; /* (degree + 1) of each X_i, then of W */
    int dimension, degree;
} taylor_point;

void taylor_point_init(taylor_point *p, moment_field *f, const trajectory *c, int degree);
void taylor_point_clear(taylor_point *p);
/** The k-th power of X_i, or of W for i = d. */
const value *taylor_power(const taylor_point *p, int i, int k);

/** The expansion of a surface, which vanishes at the point. */
void taylor_of_surface(taylor *out, moment_field *f, const taylor_point *p,
                       const csg_surface *surface);

/** Component i of the gradient at the point, a borrowed element. */
const value *taylor_gradient(const taylor *t, int i);

/** The least degree among an expansion's terms; 0 if it has none. */
int taylor_order(const taylor *t);

/** out = da/di db/dj - da/dj db/di, which vanishes at the point too. */
void taylor_minor(taylor *out, moment_field *f, const taylor *a, const taylor *b, int i, int j);

/** out = factor a - other b */
void taylor_combine(taylor *out, moment_field *f, const value *factor, const taylor *a,
                    const value *other, const taylor *b);

/* The germ of a solid at a point of the trajectory: the surfaces through the point, and the
 * patterns of signs that they have arbitrarily near it.
 *
 * The point is in the interior, outside or on the boundary iff the expression is true, false or
 * both over the patterns that occur (proofs/curved.md C95). */
void pattern_add(pattern_set *set, unsigned pattern);

typedef struct sign_germ {
    moment_field *f;
    int dimension, count;
    const trajectory *c;
    const csg_surface *surface[CSG_FREE_MOST];
    taylor member[CSG_FREE_MOST]; /* their expansions */
    pattern_set truth;            /* patterns for which the expression is true */
    pattern_set seen;             /* patterns that are known to occur near the point */
    pattern_set never;            /* patterns that are known not to occur there */
    int near_in, near_out;        /* the solid's interior, its exterior, come arbitrarily near */
} sign_germ;

/** Begin a germ: its members are the expansions of surfaces at the point; no pattern is known. */
void germ_init(sign_germ *g, moment_field *f, const trajectory *c, const csg *solid,
               const size_t *surface, int count);
void germ_clear(sign_germ *g);

/** The number of patterns of the members, 2^count. */
unsigned germ_patterns(const sign_germ *g);

/** The state I, B or O, if the known patterns decide it, else ABSENT. */
graze_state germ_settled(const sign_germ *g);

/** Is the gradient of a member not zero? */
int germ_is_smooth(const sign_germ *g, int k);

/** Note as never occurring all patterns whose bits at the members of `mask` are those of `want`. */
void germ_exclude(sign_germ *g, unsigned mask, unsigned want);

/* Patterns near a point at which some members are singular: the members are like cones with this
 * apex. */

/** Note the patterns of signs along one direction in each open cell of the members' lowest forms.
 * These patterns occur; if all members are homogeneous at the point, no others do (proofs/curved.md
 * C99, C129). */
void apex_ask(sign_germ *g);

/* The central arrangement of the tangent planes of some surfaces: its open cells and its rays. */

enum { ARRANGEMENT_RAYS = (CSG_FREE_MOST + 3) * (CSG_FREE_MOST + 2) };

/** The rays, in both directions, in which the planes of the members and of the coordinates meet. */
typedef struct arrangement {
    int dimension, count, ray_count;
    value *ray;                          /* `dimension` elements each */
    uint32_t positive[ARRANGEMENT_RAYS]; /* members whose gradient is positive along the ray */
    uint32_t negative[ARRANGEMENT_RAYS];
} arrangement;

/** Make the arrangement of the members in `mask`; their gradients are not zero. */
void arrangement_init(arrangement *a, moment_field *f, const taylor *member, int count,
                      uint32_t mask);
void arrangement_clear(arrangement *a);

/** Does a ray lie in the closed cell of a pattern of the members in `mask`? */
int arrangement_in_cell(const arrangement *a, int ray, uint32_t mask, unsigned pattern);

/** Has the pattern an open cell, in which each member's gradient has the pattern's sign? The sum of
 * the rays in the closed cell shows it. */
int arrangement_has(const arrangement *a, uint32_t mask, unsigned pattern);

/** out = a . b, of vectors of `dimension` elements; out = a x b, of vectors of three. */
void field_dot(value *out, moment_field *f, const value *a, const value *b, int dimension);
void field_cross(value *out, moment_field *f, const value *a, const value *b);

/* Circuits: minimal sets of surfaces with linearly dependent gradients. Their relation excludes
 * patterns of signs near the point. */

/** Note what the circuits of the members in `smooth`, whose gradients are not zero, say of the
 * patterns (proofs/curved.md C96 to C98). */
void circuits_ask(sign_germ *g, unsigned smooth);

/* Probes: power series v(s), s > 0, from a point of the trajectory, along none, one or two
 * surfaces. The first term of another polynomial along a probe gives its sign near the point. */

/** A probe in the common zeros of `base_count` polynomials with independent gradients. The open
 * coordinates are direction[i] s; the bound ones are power series in s that solve the equations. */
typedef struct probe {
    int dimension, base_count;
    const taylor *base[2];
    int bound_axis[2], open_axis[3]; /* the bound coordinates, and the open ones */
    value direction[3];              /* a number for each open coordinate */
    int order;                       /* the series are known up to s^order */
    value *series;                   /* dimension * (order + 1) coefficients */
} probe;

/** Prepare a probe; the base is borrowed. Returns 0 if the base's gradients are dependent. */
int probe_init(probe *p, moment_field *f, int dimension, const taylor *const *base, int base_count);
void probe_clear(probe *p);

/** Take another direction of the open coordinates. */
void probe_set_integers(probe *p, const slong *direction);

/** Find the first non-zero coefficient of a polynomial along the probe.
 * @param most a series without terms up to this order is the zero series
 * @return the coefficient's sign; 0, and *order = most + 1, for the zero series */
int probe_first(int *order, probe *p, moment_field *f, const taylor *of, int most);

/** Find the coefficient of s^2 of a polynomial without lower terms along the probe. */
void probe_second(value *out, probe *p, moment_field *f, const taylor *of);

/* First terms of polynomials along a curve that some surfaces may share. */

/** Find the first term as probe_first does. Before high orders are computed, a common curve of all
 * members of a set is sought: one through the point along which the rank of their gradients is
 * constant (proofs/flows.md C121). */
int flow_first(int *order, sign_germ *g, probe *p, unsigned members, const taylor *of, int most);

#endif
