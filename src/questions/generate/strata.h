/* Query points of one stratum.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_GENERATE_STRATA_H
#define GRAZE_GENERATE_STRATA_H

#include "questions/generate/generator.h"

/** The stream that the search for levels draws from: no row of a table has it. */
#define LEVEL_STREAM (UINT64_C(5) << 61)

/** Try once for a contact of a stratum.
 * @param[out] made 0 if this try made none
 * @param[out] normal d rationals, an outward normal of the moved facet; may be NULL
 * @return of a polyhedron GRAZE_OK; else GRAZE_ELIMIT, GRAZE_ECANCELED, GRAZE_ESYSTEM */
graze_status stratum_contact(int *made, sample *out, fmpq *normal, graze_context *context,
                             const struct graze_generator *g, graze_stratum stratum,
                             random_stream *r);

/** Try once for a point of a stratum but `level` and `rounded`; as stratum_contact. */
graze_status stratum_try(int *made, sample *out, graze_context *context,
                         const struct graze_generator *g, graze_stratum stratum, random_stream *r);

#endif
