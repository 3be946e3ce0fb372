/* Sampling of the boundary, refined where it bends.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_QUESTIONS_BOUNDARY_SAMPLING_H
#define GRAZE_QUESTIONS_BOUNDARY_SAMPLING_H

#include <stdint.h>
#include "base/context/slots.h"
#include "questions/boundary/boundary.h"

/* Numbers in the order in which they came, found again by hashing. */

void number_index_clear(number_index *t);
/** Add a key that is not there; 0 when memory is short. */
int number_index_add(number_index *t, uint64_t key, unsigned char value);

/** Classify a point and count it among those of the vertices. */
graze_status asker_pmc(graze_pmc *out, asker *a, const fmpq *point);
/** The key of a lattice point. */
uint64_t lattice_key(const uint32_t at[3]);
uint32_t key_coordinate(uint64_t key, int axis);
/** The pmc of a lattice point that is known, else GRAZE_PMC_NONE. */
graze_pmc lattice_known(const struct graze_boundary *b, uint64_t key);
/**
 * Classify a lattice point unless it is known. `out` stays NONE where the budget is spent; then
 * b->complete is 0.
 */
graze_status lattice_classify(graze_pmc *out, graze_context *context, struct graze_boundary *b,
                              uint64_t key);
/** 1 if, of the corners whose number has these bits in the mask, one is out and another is not. A
 * mask of 0 has all corners, that of one axis the corners of one side. */
int sample_cell_mixed(const struct graze_boundary *b, const sample_cell *c, unsigned mask,
                      unsigned bits);

/* The longest edge is a cell's diagonal, so both points are within 2^-20 of a cell's longest side.
 */
enum { BISECT_BITS = 21 };

/** Set the places of all vertices. */
graze_status boundary_bisect(graze_context *context, struct graze_boundary *b);

/* Contact points of a boundary. */

/** Make contact points and keep the places of those that are `on`. */
graze_status boundary_contacts(graze_context *context, struct graze_boundary *b,
                               unsigned long count, unsigned long long seed);

/* Tangent planes (E^2: lines) of a boundary at vertices of its surface. */

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

/* Points of a boundary at its edges and corners. */

void feature_init(feature *f);
void feature_clear(feature *f);

/** 1 if two tangent planes are known and more than about 18 degrees apart. */
int feature_between(const tangent *a, const tangent *b);

/**
 * Look for a corner or a point of an edge of the boundary strictly inside a cell: where two or
 * three of the tangent planes meet, nearest to a point of reference. It is taken only if it is
 * between two exactly classified points of the cell.
 * @param[out] out   initialised
 * @param reference  d rationals
 */
graze_status feature_find(feature *out, int *found, asker *a, const sample_cell *c,
                          const tangent *const *list, size_t count, const fmpq *reference);

/* Normals of a boundary from points of it that lie near one another. */

/** 1 if a point lies strictly inside a cell of the level reached. */
int probe_in_cell(const struct graze_boundary *b, const sample_cell *c, const fmpq *point);

/** Look on the line base + s way for the boundary by bisection, between s = low, where the answer
 * must be in or on, and s = high, where it must be out.
 * @param[in,out] low, high values of s; afterwards at most 2^-`bits` apart
 * @param[out] pmc at `low`; GRAZE_PMC_NONE if the answers at the ends are not as they must be
 */
graze_status probe_line(fmpq_t low, fmpq_t high, graze_pmc *pmc, asker *a, const fmpq *base,
                        const fmpq *way, unsigned bits);

/**
 * Guess the normal at a point from boundary points 2^-7 of a cell beside it.
 * @param[out] out   d rationals
 * @param[out] found 0 where there is no such point
 * @param outside, inside two points near one another, one of them out and the other not
 */
graze_status probe_normal(fmpq *out, int *found, asker *a, const fmpq *outside, const fmpq *inside);

/* The cells of a boundary, level by level. */

/** Points that are asked at least: `contacts` points and the corners of the coarse level. */
unsigned long long boundary_least_points(const struct graze_boundary *b, unsigned long contacts);

/** Refuse a budget that does not suffice for `contacts` points and all cells of the coarse level.
 */
graze_status boundary_refuse_budget(graze_context *context, const struct graze_boundary *b,
                                    unsigned long contacts);
/** Cut the box, level by level. */
graze_status boundary_refine(graze_context *context, struct graze_boundary *b);

/* The rims of patches: where the surface leaves a cell. */

/* A patch has at most two faces a simplex. */
enum { RIM_MOST = 36 };

/** Vertices in the order of the faces' sides: a closed polygon on the sides of the cell; in E^2 the
 * way from one side to another. */
typedef struct rim {
    size_t count, vertex[RIM_MOST];
} rim;

/** A run of edges of a rim that lies in one side of the cell. */
typedef struct rim_run {
    size_t first, edges; /* from vertex `first` on */
} rim_run;

/** 1 if the patch has one rim, which passes each of its vertices once. */
int rim_find(rim *out, const struct graze_boundary *b, size_t patch);

/** 1 if just one run of a closed rim lies in the lower or upper side of its cell along an axis. */
int rim_run_at(rim_run *out, const struct graze_boundary *b, const sample_cell *c,
               const size_t *vertex, size_t count, int axis, int upper);

/* The sharp edges and corners of a boundary, put into its surface. */

/**
 * Give each cell with a feature a vertex there. The surface stays a manifold without
 * degenerate faces and without self-intersections, closed where it was; vertices that no face has
 * any more are gone.
 */
graze_status boundary_sharpen(graze_context *context, struct graze_boundary *b);

/* The surface of a boundary. */

/** The surface between `out` and the rest at the level reached. */
graze_status boundary_surface(graze_context *context, struct graze_boundary *b);

#endif
