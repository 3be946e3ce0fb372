/* What is found out about a point and the closed sweep.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_FINDING_H
#define GRAZE_TOPO_FINDING_H

#include <flint/fmpq.h>
#include "graze/topo.h"

/** `reason` is set for an undecided point alone, `witness` and what belongs to it if `has_witness`,
 * `open` if `has_open`. */
typedef struct topo_finding {
    graze_topo position;
    graze_topo_level level;
    const char *reason; /* static */
    int has_witness;
    fmpq witness[3];   /* a point that is `out` */
    fmpq reach;        /* L1: all points up to the witness are, which is that far in `direction` */
    fmpz direction[3]; /* else: half the side of the square on which the witness lies, in E^3 in */
    fmpz along[2][3];  /* the plane along these, in their lengths */
    int has_open;
    fmpz open[3];   /* a direction that no contact looked at covers to first order */
    int has_across; /* all such lie in one plane, across `across`; then `open` is one that is not
                       covered by leading terms */
    fmpz across[3];
} topo_finding;

/** Nothing is found. */
void finding_init(topo_finding *f);
void finding_clear(topo_finding *f);
void finding_set(topo_finding *f, graze_topo position, graze_topo_level level);
void finding_undecided(topo_finding *f, const char *reason);

#endif
