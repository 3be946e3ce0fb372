/* Hints of a row: control points, events, cuts.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_QUESTIONS_CERTIFY_PROVE_H
#define GRAZE_QUESTIONS_CERTIFY_PROVE_H

#include "questions/certify/certify.h"

/* A piece of a trajectory in doubles, and the simplices that it certainly does not touch. */

/** The control points x_k / w_k of a piece in E^3, and a box around them. Each coordinate has a
 * relative error of at most 2^-48, or is 0 for one below 2^-900 in absolute value. */
typedef struct control {
    double *at;   /* 3 * count */
    size_t count; /* 0: nothing is known, in E^2 or past the range of doubles */
    box box;
} control;

/** Allocate room for trajectories of a degree, which control_clear frees; returns 0 if memory is
 * short. */
int control_init(control *out, slong degree);
void control_clear(control *c);

/** Set the control points from Bernstein coefficients; all coefficients of W must be positive. */
void control_set(control *out, const trajectory *c, const fmpz *bernstein);

/** Is it certain that the plane form of a simplex has one strict sign at all control points, or a
 * side form is negative at all of them? 0 says nothing. */
int control_clears(const control *c, const graze_solid *solid, size_t simplex);

/* Will the checker's tests succeed on an interval? Graze runs the tests of proofs/certificate.md,
 * section 4, beforehand, since each interval of a certificate must pass them. */

/** An interval of a trajectory's parameter u, and the simplices near it. */
typedef struct enclosure {
    const graze_solid *solid;
    const trajectory *c;
    dyadic_interval at;
    fmpz *coefficients; /* d + 1 times degree + 1 */
    fmpz *value;        /* degree + 1 */
    control points;
    int with_cells;         /* proofs must show for each near cell whether it is met */
    form_memory *forms;     /* borrowed, or NULL */
    fmpz plane[4], side[4]; /* room for the forms at hand */
    size_t count, capacity;
    uint32_t *near;
    uint32_t suspect; /* the simplex at which the last proof failed; it is tested first */
    int out_of_memory;
} enclosure;

/** Claim about the interval around a root of q: the state letters on the left and on the right of
 * the root. A letter is 0 if the root is the end of the interval on that side. */
typedef struct root_claim {
    char left, right;
    const fmpz_poly_struct *q;
} root_claim;

/** @param forms memory that keeps forms, borrowed; or NULL */
void enclosure_init(enclosure *e, const graze_solid *solid, const trajectory *c, int with_cells,
                    form_memory *forms);
void enclosure_clear(enclosure *e);

/* Each of these functions except prove_one_sign returns 1 if the checker's tests prove the claim,
 * else 0. */
/** The trajectory is off the boundary on the closed interval. */
int prove_clear(enclosure *e, const dyadic_interval *at);
/** One simplex contains the trajectory on the closed interval. */
int prove_slide(enclosure *e, const dyadic_interval *at);
/** The claim about the root of q in the interval. */
int prove_root(enclosure *e, const dyadic_interval *at, root_claim claim);
/** The strict sign of all Bernstein coefficients of p on the interval; 0 if they do not all have
 * the same one. */
int prove_one_sign(const fmpz_poly_t p, const dyadic_interval *at);
/** q has exactly one root in the open interval, a simple one, and none at the interval's ends. */
int prove_isolated(const fmpz_poly_t q, const dyadic_interval *at);

/* The lines of a certificate's row: intervals and, if the certificate has them, contacts
 * (proofs/certificate.md, section 1). */

/** Write the time t of the parameter u = numerator / 2^exponent of a piece. */
void line_number(text *out, const motion_piece *piece, const fmpz_t numerator, ulong exponent);

/** A row being written. */
typedef struct row_lines {
    text *out;
    const graze_trace *trace;  /* the trace whose contacts are written with their cells; NULL: no
                                  contacts are written */
    size_t said;               /* number of contacts written */
    const motion_piece *piece; /* the piece at hand */
    text start, finish; /* `start`: time at which the next interval begins; `finish`: the motion's
                           last time */
    text opened;        /* time at which the unfinished contact began; empty if there is none */
} row_lines;

/** Begin to write the intervals of a row. */
void row_lines_init(row_lines *l, text *out, const graze_trace *trace, const graze_motion *motion);
void row_lines_clear(row_lines *l);
/** Write an interval up to u = high / 2^exponent, and the contact that ends in it. `q` is the
 * polynomial in u whose root a kind of three letters claims; else NULL. */
void row_lines_put(row_lines *l, const char *kind, const fmpz_t high, ulong exponent,
                   const fmpz_poly_struct *q);

#endif
