/* Probes: power series v(s) that lead from a point of the trajectory, s > 0, into none, one or two
 * surfaces; the first term of another polynomial along them is its sign near the point.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CURVED_SERIES_H
#define GRAZE_CURVED_SERIES_H

#include "decide/curved/taylor.h"

/**
 * A probe in `base_count` polynomials with independent gradients. The other coordinates, `open`
 * ones in order, run along a direction.
 */
typedef struct probe {
    int dimension, base_count;
    const taylor *base[2];
    int bound_axis[2], open_axis[3]; /* coordinates solved for, and the others */
    value direction[3];              /* of the open ones */
    int order;                       /* of the series that are known */
    value *series;                   /* dimension * (order + 1) */
} probe;

/** Prepare a probe; 0 if the gradients of the base are dependent. The base is borrowed. */
int probe_init(probe *p, moment_field *f, int dimension, const taylor *const *base, int base_count);
void probe_clear(probe *p);

/** Take another direction of the open coordinates. */
void probe_set_integers(probe *p, const slong *direction);

/** The first non-zero coefficient of a polynomial along the probe: its order and sign.
 * @param most an order past which no other than the zero series begins
 * @return its sign; 0, and *order = most + 1, for the zero series */
int probe_first(int *order, probe *p, moment_field *f, const taylor *of, int most);

/** The coefficient of s^2 of a polynomial that begins no earlier. */
void probe_second(value *out, probe *p, moment_field *f, const taylor *of);

#endif
