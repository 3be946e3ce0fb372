/* Rational points that polynomials have in common: flats, and quadrics in flats.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_GENERATE_CHARTS_H
#define GRAZE_GENERATE_CHARTS_H

#include "base/context/context.h"
#include "base/number/random.h"
#include "questions/generate/flat.h"
#include "questions/generate/quadratic.h"

/** Points of a flat; if `bent`, all but the start are second points of lines through it. */
typedef struct chart {
    flat place;
    int bent;
    int isolated;    /* a singular point of the zeros */
    quadratic curve; /* in the parameters of the flat; only if bent */
    size_t mark;     /* what it was made of, as its maker counts */
} chart;

typedef struct charts {
    graze_context *context;
    const fmpq_mpoly_ctx_struct *ring; /* of the coordinates */
    int dimension;
    size_t count, capacity, mark; /* mark: of those that are appended */
    chart *item;
} charts;

void charts_clear(charts *list);

/** Append what is found of the zeros of a polynomial of the coordinates in a flat. */
graze_status charts_add_section(charts *list, const flat *place, const fmpq_mpoly_t p);

/** Append what is found of the common zeros of two, p irreducible: where one, or a factor of q, or
 * of what the division of one by the other leaves, is linear. */
graze_status charts_add_common(charts *list, const fmpq_mpoly_t p, const fmpq_mpoly_t q);

/** Append the singular point of the zeros of a polynomial of degree 2, if there is one. */
graze_status charts_add_singular(charts *list, const fmpq_mpoly_t p);

/**
 * Draw a point.
 * @param low, high the box that flats are to be met in
 * @return 0 if this try made none
 */
int chart_draw(fmpq *point, const chart *from, random_stream *r, const fmpq *low, const fmpq *high);

#endif
