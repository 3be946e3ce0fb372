/* Expansions of polynomials that vanish at a point of the trajectory, over the field of a moment.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * With c = X / W and x = c + v / W, W^degree f(x) is a polynomial in v with coefficients in Z[u]:
 * the factors are positive and change no sign near the point.
 */
#ifndef GRAZE_CURVED_TAYLOR_H
#define GRAZE_CURVED_TAYLOR_H

#include "decide/curved/moment_field.h"
#include "decide/trace/trajectory.h"
#include "input/csg/csg.h"

/** Bound of the degree: that of a minor of the gradients of two surfaces. */
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

/** The powers of a trajectory's polynomials as elements, up to a degree. */
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

/** The lowest degree of a term; 0 without terms. */
int taylor_order(const taylor *t);

/** out = da/di db/dj - da/dj db/di, which vanishes at the point too. */
void taylor_minor(taylor *out, moment_field *f, const taylor *a, const taylor *b, int i, int j);

/** out = factor a - other b */
void taylor_combine(taylor *out, moment_field *f, const value *factor, const taylor *a,
                    const value *other, const taylor *b);

#endif
