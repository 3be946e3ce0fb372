/* Finding about a point and the closed sweep.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_FINDING_H
#define GRAZE_TOPO_FINDING_H

#include <flint/fmpq.h>
#include "graze/topo.h"

/** Kinds of witnesses, by the level that decided a point of the boundary. A path has the places
 * P + s^order open + s^(order + 1) lift across. */
typedef enum topo_witness { WITNESS_RAY, WITNESS_PATH, WITNESS_SQUARE } topo_witness;

/** `reason` is set for an undecided point alone, `witness` and what belongs to it if `has_witness`,
 * `open` if `has_open`. */
typedef struct topo_finding {
    graze_topo position;
    graze_topo_level level;
    const char *reason; /* static */
    int has_witness;
    fmpq witness[3]; /* a point that is `out` */
    fmpq reach; /* first order, leading terms: parameter of the witness on its path; every earlier
                   point of the path is `out` */
    fmpz direction[3]; /* first order: of the path, a ray */
    fmpz along[2][3];  /* else half the side of the square on which the witness lies, in E^3 in the
                          plane along these, in their lengths */
    int has_open;
    fmpz open[3];   /* a direction that no contact looked at covers to first order */
    int has_across; /* all such lie in one plane, across `across`; then `open` is one that is not
                       covered by leading terms */
    fmpz across[3];
    slong order; /* of a path between the contacts, along `open`; 0: none is known */
    fmpq lift;
} topo_finding;

/** Nothing is found. */
void finding_init(topo_finding *f);
void finding_clear(topo_finding *f);
topo_witness finding_witness(const topo_finding *f);
void finding_set(topo_finding *f, graze_topo position, graze_topo_level level);
void finding_undecided(topo_finding *f, const char *reason);

#endif
