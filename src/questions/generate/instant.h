/* One rational time of a motion with what is needed to make contacts at it: where body points are,
 * and how fast they leave their facets. SPDX-License-Identifier: GPL-3.0-or-later
 *
 * For a point P and a facet's plane form n, F(u) = n . (X, W)(u) is the pullback along P's
 * trajectory. At a fixed u it and its derivatives are affine in P, so in the body point y with P =
 * M(u) y: F(u) = 0 for y on the facet, and F'(u) = 0 there says that the normal velocity of y
 * vanishes.
 */
#ifndef GRAZE_GENERATE_INSTANT_H
#define GRAZE_GENERATE_INSTANT_H

#include "decide/scene/scene.h"

/** Derivatives of pullbacks by u: of order 1 and 2. */
enum { INSTANT_DERIVATIVES = 2 };

typedef struct instant {
    int dimension;
    size_t piece;
    fmpq_t u, t;
    fmpq *map; /* M at u: d * (d + 1) */
    fmpz
        *inverse; /* a positive multiple of (N, W) at u: (d + 1) * (d + 1), the weight's row last */
    /* Its derivatives of order 1 and 2 times M at u, each by a positive number: body points in,
     * (d + 1) * (d + 1). */
    fmpz *carried[INSTANT_DERIVATIVES];
    int bounded; /* it is set: */
    double
        velocity[16]; /* the first of them times a positive number, each within 2^-52 of itself */
} instant;

void instant_init(instant *i, const graze_scene *scene, size_t piece, const fmpq_t u);
void instant_clear(instant *i);

/** P = M(u) y. */
void instant_move(fmpq *out, const instant *i, const fmpq *y);

/**
 * The derivative of order k of the pullback of a plane form along the trajectory of P = M(u) y, at
 * u, as a form in (y, 1) and times a positive number that depends on the instant and k alone.
 * @param[out] out d + 1 initialised integers
 * @param k 1 to INSTANT_DERIVATIVES
 */
void instant_pullback(fmpz *out, const instant *i, const fmpz *form, int k);

/** The gradient by P of the pullback of a plane form, times a positive number: an outward normal of
 * the moved facet if the form is positive outside. */
void instant_normal(fmpq *out, const instant *i, const fmpz *form);

#endif
