/* Will the checker's tests succeed on an interval? The tests of proofs/certificate.md, section 4,
 * foreseen: what a certificate hints at must pass them.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CERTIFY_PROVE_H
#define GRAZE_CERTIFY_PROVE_H

#include "base/number/bernstein.h"
#include "decide/trace/trajectory.h"
#include "input/solid/known.h"
#include "input/solid/solid.h"
#include "questions/certify/control.h"

/** An interval of a trajectory's parameter u, and the simplices near it. */
typedef struct enclosure {
    const graze_solid *solid;
    const trajectory *c;
    dyadic_interval at;
    fmpz *coefficients; /* d + 1 times degree + 1 */
    fmpz *value;        /* degree + 1 */
    control points;
    int with_cells;         /* the cells met are to be known, and those that are not */
    form_memory *forms;     /* borrowed, or NULL */
    fmpz plane[4], side[4]; /* room for those at hand */
    size_t count, capacity;
    uint32_t *near;
    uint32_t suspect; /* the simplex at which the last proof failed, which comes first */
    int out_of_memory;
} enclosure;

/** Claim about the interval around a root: the letters beside it, 0 for a side that is not there
 * (the root is that end). */
typedef struct root_claim {
    char left, right;
    const fmpz_poly_struct *q;
} root_claim;

/** @param forms memory of forms, or NULL */
void enclosure_init(enclosure *e, const graze_solid *solid, const trajectory *c, int with_cells,
                    form_memory *forms);
void enclosure_clear(enclosure *e);

/** The trajectory is off the boundary on the closed interval. */
int prove_clear(enclosure *e, const dyadic_interval *at);
/** One simplex holds it on the closed interval. */
int prove_slide(enclosure *e, const dyadic_interval *at);
/** The claim about the root of q in the interval. */
int prove_root(enclosure *e, const dyadic_interval *at, root_claim claim);
/** q has just one root in the open interval, a simple one, and none at its ends. */
int prove_isolated(const fmpz_poly_t q, const dyadic_interval *at);

#endif
