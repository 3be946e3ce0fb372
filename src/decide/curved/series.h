/* Probes: power series v(s), s > 0, from a point of the trajectory, along none, one or two
 * surfaces. The first term of another polynomial along a probe gives its sign near the point.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CURVED_SERIES_H
#define GRAZE_CURVED_SERIES_H

#include "decide/curved/taylor.h"

/** A probe in the common zeros of `base_count` polynomials with independent gradients. The open
 * coordinates run along a direction, the others are solved for. */
typedef struct probe {
    int dimension, base_count;
    const taylor *base[2];
    int bound_axis[2], open_axis[3]; /* coordinates solved for, and open ones */
    value direction[3];              /* of the open coordinates */
    int order;                       /* up to which the series are known */
    value *series;                   /* dimension * (order + 1) coefficients */
} probe;

/** Prepare a probe; the base is borrowed. Returns 0 if the base's gradients are dependent. */
int probe_init(probe *p, moment_field *f, int dimension, const taylor *const *base, int base_count);
void probe_clear(probe *p);

/** Take another direction of the open coordinates. */
void probe_set_integers(probe *p, const slong *direction);

/** Find the first non-zero coefficient of a polynomial along the probe.
 * @param most a series without terms up to this order is the zero series
 * @return the coefficient's sign; 0, and *order = most + 1, for the zero series */
int probe_first(int *order, probe *p, moment_field *f, const taylor *of, int most);

/** Find the coefficient of s^2 of a polynomial without lower terms along the probe. */
void probe_second(value *out, probe *p, moment_field *f, const taylor *of);

#endif
