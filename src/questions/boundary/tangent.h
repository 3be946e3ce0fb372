/* Tangent planes (E^2: lines) of a boundary at vertices of its surface.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_BOUNDARY_TANGENT_H
#define GRAZE_BOUNDARY_TANGENT_H

#include "questions/boundary/sampling.h"

/** Where `known`, a form of d + 1 rationals that is zero on the plane and positive outside, and its
 * unit normal. Zeroed: not known. */
typedef struct tangent {
    int known;
    fmpq form[4];
    double unit[3];
} tangent;

/**
 * Guess the tangent plane at a vertex: where it is on, from the cells of the first contact that
 * gives one, exactly where the contact's time is rational; else from two points of the boundary
 * beside it (E^2: one), placed by bisection. Nothing is proved about a guess.
 */
graze_status tangent_find(tangent *out, asker *a, size_t vertex);

#endif
