/* collide: finds when a moving solid and a fixed one are apart, touch or overlap, with exact times
 * and cells.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_QUESTIONS_COLLIDE_H
#define GRAZE_QUESTIONS_COLLIDE_H

#include "decide/trace/trace.h"
#include "graze/pair.h"
#include "input/motion/motion.h"
#include "input/solid/solid.h"

/** A ratio of lengths on a piece as quotients, positive on [0, 1]: its square, and itself where it
 * is a rational function. */
typedef struct length_ratio {
    fmpz_poly_struct square[2], root[2];
} length_ratio;

/** The clearance of two simplices is the distance that was asked for, the moving radius and the
 * fixed radius, times these ratios. */
typedef struct clearance {
    const fmpq *distance; /* borrowed */
    length_ratio ratio[3];
} clearance;

/** Two solids and the motion of `moving`, all borrowed, of one dimension; `fixed` does not move. */
typedef struct solid_pair {
    const graze_solid *moving, *fixed;
    const graze_motion *motion;
    int complement; /* 1: the closure of the complement of `fixed` stands for it; 2: of `moving` */
    const clearance *near; /* of each piece: distances below it count as I, at it as B; NULL: 0 */
    const csg_round *round[2]; /* of each simplex of a solid of balls and capsules; else NULL */
    form_memory *forms[2];     /* of either solid, for all placings; or NULL */
} solid_pair;

/* Pairs of boundary cells, one of each solid, that meet at a time. */

typedef struct cell_pairs {
    size_t count, capacity;
    graze_cell_pair *item; /* sorted, without duplicates */
} cell_pairs;

/** A contact from `from` to `to`, which is NULL until it is known; `left` and `right` are the
 * states beside it. */
typedef struct pair_contact {
    graze_state left, right;
    const graze_time *from, *to;
    cell_pairs cells;
} pair_contact;

typedef struct pair_walk {
    const solid_pair *pair;
    graze_context *context;
    size_t contact_count, contact_capacity;
    pair_contact *contact;
    size_t length, word_capacity;
    char *word; /* ends in NUL unless it is empty */
    size_t time_count, time_capacity;
    graze_time **time; /* all times that were kept, in order; contacts borrow them */
    graze_time *last;  /* the last time reached; NULL: none */
    graze_state gap;   /* state after the last time, or from t0 on; ABSENT: unknown */
    int open;          /* the last contact has not ended */
    int first; /* 1: only the first contact, and the state just after it begins, are asked for */
    graze_state until; /* with `first`: up to where this state begins, at `last` or t0, instead */
    const algebraic *limit; /* times of the last piece that may be left out are later; or NULL */
    int done;               /* 1: nothing more is to be found */
    size_t looked_piece;    /* the rational time at which a gap was looked into last */
    fmpq_t looked;
} pair_walk;

/* The answer to a pair of a moving and a fixed solid: the word and the contacts
 * (proofs/collision.md). */

struct graze_pair {
    solid_pair pair;
    form_memory forms[2];
    pair_walk walk;
    const graze_motion *frame; /* the motion of the fixed solid, or NULL */
    graze_motion *own;         /* the relative motion if both solids move, else NULL */
    graze_time *start;         /* t0 if the word begins with I, else NULL */
    graze_pair_options options;
    fmpq_t distance;      /* options.clearance and, for a while, options.motion_error */
    clearance *clearance; /* of each piece of the motion, or NULL */
    graze_solid *base[2]; /* the points and segments of balls and capsules, or NULL */
    graze_closest closest;
    graze_time *closest_time; /* closest.time, or NULL */
    int is_bounded;           /* 1: the first contact of motions within `error` is asked for */
    fmpq_t error;
    graze_first_contact bounds;
    graze_time *begun, *high; /* the interiors begin to meet, or NULL; bounds.high */
};

/** Replace balls and capsules by their points and segments, and set the clearance of a pair with
 * its motion, whose `distance` is not negative.
 * @return GRAZE_EINPUT another curved solid; GRAZE_EILLEGAL the frame, or a round solid's motion,
 * changes the ratios of distances */
graze_status collide_set_clearance(graze_pair *pair, graze_context *context);

/** Answer a pair with its solids, motion, options and clearance set. The caller calls collide_clear
 * in any case. Times of contacts become canonical. */
graze_status collide_answer(graze_pair *pair, graze_context *context);
void collide_clear(graze_pair *pair);

/** Walk through a pair with its clearance set, and `first`, `until` and `limit` of its walk. */
graze_status collide_walk(graze_pair *pair, graze_context *context);

/** Enclose the least distance of a pair with its options and clearance set (proofs/collision.md
 * C144).
 * @return as collide_set_clearance, and GRAZE_ELIMIT */
graze_status collide_closest(graze_pair *pair, graze_context *context);

/** Set the bounds of a pair that is answered with its `error` in its distance, and take that away
 * again (proofs/collision.md C147). */
graze_status collide_bound_first(graze_pair *pair, graze_context *context);

/** Find the ball or capsule of a cell of a `base` with several, and number the cell's vertices
 * within it. @return 0 where there are not several, or `base` is NULL */
int collide_in_body(size_t *body, graze_cell *cell, const graze_solid *base);

/** The verdict that the word gives; GRAZE_PAIR_CONTACT if only the first contact was asked for, and
 * one was found.
 */
graze_pair_verdict collide_verdict(const graze_pair *pair);

/** The state just after the first contact begins, if only that was asked for; else ABSENT. */
graze_state collide_next(const graze_pair *pair);

/** The time at which the interiors begin to meet, or NULL. */
const graze_time *collide_overlap_time(const graze_pair *pair);

#endif
