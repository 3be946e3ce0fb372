/* Vectors of placed solids, and pairs of features: their equation, feet and cells at a clearance.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_QUESTIONS_COLLIDE_FEATURES_H
#define GRAZE_QUESTIONS_COLLIDE_FEATURES_H

#include <stdlib.h>
#include "questions/collide/placing.h"

/* Vectors that are polynomials in u, in the fixed solid's space. */

void moving_vector_init(moving_vector *v);
void moving_vector_clear(moving_vector *v);
void moving_set(moving_vector *out, const moving_vector *v);
void moving_negate(moving_vector *v);
void dot_moving(fmpz_poly_t out, const moving_vector *a, const moving_vector *b);
/** out = a x b; `out` is neither. */
void cross_moving(moving_vector *out, const moving_vector *a, const moving_vector *b);

/** Set a vector to a positive multiple of that from corner a to corner b of a simplex. */
void edge_vector(moving_vector *out, placing *p, pair_side side, uint32_t simplex, int a, int b);

/* Pairs of features at a clearance (proofs/collision.md C131). */

/** Corners first, first + 1, ... of a simplex, in cyclic order: one of its closed faces. */
typedef struct corner_run {
    uint32_t simplex;
    int first, count;
} corner_run;

/** A face of a simplex of each solid, the moving one first; `key` names both. */
typedef struct feature_pair {
    corner_run of[2];
    uint32_t key[6];
} feature_pair;

typedef struct feature_list {
    size_t count, capacity;
    feature_pair *item;
} feature_list;

static inline void feature_list_clear(feature_list *list) {
    free(list->item);
}

/** Kinds of pairs of faces that have an equation are numbered from `first` to `end` - 1. Without a
 * clearance they are a vertex and a simplex, or two edges of E^3. Kinds from `end` on, d - 1 of
 * them, span all of space together and may pierce one another. */
int features_first(const placing *p);
int features_end(const placing *p);

/** Append the pairs of faces of one kind of two simplices.
 * @param all 1: sides that were made by cutting facets too */
void features_add(feature_list *out, placing *p, near_pair simplices, int kind, int all);

/** Replace a list by all pairs of faces of one kind, each once; with a clearance, without sides
 * made by cutting. */
void features_gather(feature_list *out, placing *p, const near_list *near, int kind);

/** The stationary points of the distance of the affine hulls of two faces; without a clearance, the
 * equation alone. */
typedef struct stationary {
    const feature_pair *features;
    int count;             /* of the vectors that span both faces, the moving one's first */
    moving_vector span[3]; /* zero past `count` */
    fmpz_poly_t gram;      /* 0 where the vectors are dependent and there is no such point */
    fmpz_poly_t equation;  /* where it is not: the sign of distance minus clearance */
} stationary;

void stationary_init(stationary *s, placing *p, const feature_pair *features);
void stationary_clear(stationary *s);

/** Set point + 0, 1, 2 and point + 3, 4, 5 to the stationary points of the moving and of the fixed
 * face in the fixed solid's space, at the placing's rational time. */
void stationary_points(fmpq *point, placing *p, const stationary *s);

/** Set form k, from 0 on, that vanishes where a vertex may change its cell in the plane of a
 * simplex in which it always lies; 0 if there is none. */
int stationary_turns(fmpz_poly_t out, placing *p, const stationary *s, int k);

/** At a root of the equation or of such a form, the placing's time: are points of both closed faces
 * at the clearance? Where edges are parallel then, their ends tell (proofs/collision.md C132). */
int stationary_touches(placing *p, const stationary *s);

/** The sign of distance minus clearance at the placing's time if the stationary points are in both
 * closed faces, else 1. */
int features_sign(unsigned zero[2], placing *p, const feature_pair *features);

/** The state at the placing's time without containment: I, B, or O (C131). */
graze_state features_look(placing *p, const near_list *near);

/* Solids of balls and capsules, and the clearance. */

/** Replace a solid of balls and capsules by its base, in which each is a simplex with fewer
 * corners. */
graze_status collide_set_round(graze_pair *pair, graze_context *context, int side);

/** The number of different corners of a simplex. */
int simplex_corners(const placing *p, pair_side side, uint32_t simplex);

/** Set out[0] / out[1] to the square of the clearance of two simplices. */
void clearance_square(fmpz_poly_struct out[2], const clearance *near, const solid_pair *pair,
                      near_pair simplices);

/** Set `out` to the least clearance of any two simplices; 0 where radii or distances grow. */
void clearance_least(fmpq_t out, const graze_pair *pair);

/** Set the bounds of the clearance during an interval of the placing's piece, or at its rational
 * time, whatever the interval. */
void clearance_enclose(control_maps *maps, const placing *p, const dyadic_interval *interval);

#endif
