/* Sampling of the boundary, refined where it bends.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_QUESTIONS_BOUNDARY_SAMPLING_H
#define GRAZE_QUESTIONS_BOUNDARY_SAMPLING_H

#include <stdint.h>
#include "questions/boundary/boundary.h"

/* Numbers in the order in which they were added, found again by hashing. */

void number_index_clear(number_index *t);
/** Add a key that is not in the index; returns 0 if memory is short. */
int number_index_add(number_index *t, uint64_t key, unsigned char value);

/** Classify a point off the lattice and count it in a->asked. */
graze_status asker_pmc(graze_pmc *out, asker *a, const fmpq *point);
/** The key of a lattice point. */
uint64_t lattice_key(const uint32_t at[3]);
uint32_t key_coordinate(uint64_t key, int axis);
/** The pmc of a lattice point; GRAZE_PMC_NONE if it was not classified yet. */
graze_pmc lattice_known(const struct graze_boundary *b, uint64_t key);
/**
 * Find the pmc of a lattice point, which is classified once. If the budget is spent, `out` becomes
 * GRAZE_PMC_NONE and b->complete 0.
 */
graze_status lattice_classify(graze_pmc *out, graze_context *context, struct graze_boundary *b,
                              uint64_t key);
/** Consider the corners k of a cell with (k & mask) == bits: 1 if one of them is out and another is
 * not. Mask 0 takes all corners, the mask 1 << axis those of one side. */
int sample_cell_mixed(const struct graze_boundary *b, const sample_cell *c, unsigned mask,
                      unsigned bits);

/* A vertex's two points are 2^-21 of its edge apart. The longest edge is a cell's diagonal, so the
 * distance of the two points is less than 2^-20 of the cell's longest side.
 */
enum { BISECT_BITS = 21 };

/** Find the shares of all vertices by bisection. */
graze_status boundary_bisect(graze_context *context, struct graze_boundary *b);

/* Contact points of a boundary. */

/** Make `count` contact points from a seed and keep the places of those that are on. */
graze_status boundary_contacts(graze_context *context, struct graze_boundary *b,
                               unsigned long count, unsigned long long seed);

/* Tangent planes (E^2: lines) of a boundary at vertices of its surface. */

/** If `known`, a form of d + 1 rationals that is zero on the plane and positive outside, and its
 * unit normal. A tangent of zeros is not known. */
typedef struct tangent {
    int known;
    fmpq form[4];
    double unit[3];
} tangent;

/**
 * Guess the tangent plane at a vertex. If its inner point is on, the first contact that gives a
 * plane is used, exactly if the contact's time is rational; else two points of the boundary beside
 * the vertex (E^2: one), found by bisection. Nothing is proved about a guess.
 */
graze_status tangent_find(tangent *out, asker *a, size_t vertex);

/* Points of a boundary at its edges and corners. */

void feature_init(feature *f);
void feature_clear(feature *f);

/** 1 if two tangent planes are known and more than about 18 degrees apart. */
int feature_between(const tangent *a, const tangent *b);

/**
 * Look for a corner of the boundary, or a point of an edge of it, strictly inside a cell: where
 * three tangent planes meet, or two at the point nearest to `reference`. The feature is taken only
 * if it lies between two exactly classified points of the cell, one out and one not.
 * @param[out] out   initialised
 * @param reference  d rationals
 */
graze_status feature_find(feature *out, int *found, asker *a, const sample_cell *c,
                          const tangent *const *list, size_t count, const fmpq *reference);

/* Normals of a boundary, guessed from nearby boundary points. */

/** 1 if a point lies strictly inside a cell of the level reached. */
int probe_in_cell(const struct graze_boundary *b, const sample_cell *c, const fmpq *point);

/** Look for the boundary on the line base + s way by bisection. The point at s = low must be in or
 * on, the point at s = high must be out.
 * @param[in,out] low, high values of s; afterwards at most 2^-`bits` apart, unless *pmc is
 * GRAZE_PMC_NONE
 * @param[out] pmc the answer at `low`; GRAZE_PMC_NONE if an end is not as it must be
 */
graze_status probe_line(fmpq_t low, fmpq_t high, graze_pmc *pmc, asker *a, const fmpq *base,
                        const fmpq *way, unsigned bits);

/**
 * Guess the normal of the boundary at `inside` from boundary points 2^-7 of a cell beside it.
 * @param[out] out   d rationals
 * @param[out] found 0 if a boundary point beside it is not found
 * @param outside, inside two points near one another, one of them out and the other not
 */
graze_status probe_normal(fmpq *out, int *found, asker *a, const fmpq *outside, const fmpq *inside);

/* The cells of a boundary, level by level. */

/** The least number of points that are classified: `contacts` points and the corners of the coarse
 * level. */
unsigned long long boundary_least_points(const struct graze_boundary *b, unsigned long contacts);

/** Fail if the budget does not suffice for `contacts` points and all cells of the coarse level. */
graze_status boundary_refuse_budget(graze_context *context, const struct graze_boundary *b,
                                    unsigned long contacts);
/** Cut the box into cells, level by level. */
graze_status boundary_refine(graze_context *context, struct graze_boundary *b);

/* The rims of patches: the polygons in which the surface leaves a cell. */

/* A patch has at most two triangles for each of a cell's 6 simplices: 36 directed sides. */
enum { RIM_MOST = 36 };

/** The vertices of a rim in the direction of the faces' sides: a closed polygon on the sides of the
 * cell; in E^2 the path from one side of the cell to another. */
typedef struct rim {
    size_t count, vertex[RIM_MOST];
} rim;

/** Consecutive edges of a rim that lie in one side of the cell. */
typedef struct rim_run {
    size_t first, edges; /* from vertex `first` on */
} rim_run;

/** Find the rim of a patch; returns 1 if there is just one, and it passes each of its vertices
 * once. */
int rim_find(rim *out, const struct graze_boundary *b, size_t patch);

/** Find the run of a closed rim in the lower or upper side of its cell along an axis; returns 1 if
 * there is just one. */
int rim_run_at(rim_run *out, const struct graze_boundary *b, const sample_cell *c,
               const size_t *vertex, size_t count, int axis, int upper);

/* The sharp edges and corners of a boundary, put into its surface. */

/**
 * Give each cell in which a feature is found a vertex at the feature. The surface stays a manifold
 * without degenerate faces and without self-intersections, closed where it was; vertices that
 * belong to no face any more are removed.
 */
graze_status boundary_sharpen(graze_context *context, struct graze_boundary *b);

/* The surface of a boundary. */

/** Make the surface between points that are out and points that are not, at the level reached. */
graze_status boundary_surface(graze_context *context, struct graze_boundary *b);

#endif
