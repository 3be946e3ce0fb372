/* The result about a point's position relative to the closed sweep.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_FINDING_H
#define GRAZE_TOPO_FINDING_H

#include <flint/fmpq.h>
#include "graze/topo.h"

/** Kinds of witnesses: a point on a ray, on the path P + s^order open + s^(order + 1) lift across,
 * or on a square about P. */
typedef enum topo_witness { WITNESS_RAY, WITNESS_PATH, WITNESS_SQUARE } topo_witness;

/** A result. `reason` is set only for an undecided point; `witness`, `reach`, `direction` and
 * `along` only if `has_witness`; `open` only if `has_open`. */
typedef struct topo_finding {
    graze_topo position;
    graze_topo_level level;
    const char *reason; /* static */
    int has_witness;
    fmpq witness[3];   /* a point that is `out` */
    fmpq reach;        /* for a ray or path: the parameter of the witness; every point of a smaller
                          positive one is `out` too */
    fmpz direction[3]; /* of the ray */
    fmpz along[2][3];  /* for a square: `reach` is half its side; in E^3 it lies in the plane along
                          these, whose lengths are the units */
    int has_open;
    fmpz open[3];   /* a direction that no contact covers to first order */
    int has_across; /* all such directions lie in the plane across `across`; then `open` is one that
                       leading terms do not cover */
    fmpz across[3];
    slong order; /* of a path along `open` between the contacts; 0: none is known */
    fmpq lift;
} topo_finding;

/** Begin without a result. */
void finding_init(topo_finding *f);
void finding_clear(topo_finding *f);
topo_witness finding_witness(const topo_finding *f);
void finding_set(topo_finding *f, graze_topo position, graze_topo_level level);
void finding_undecided(topo_finding *f, const char *reason);

#endif
