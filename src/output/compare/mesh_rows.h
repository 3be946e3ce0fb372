/* A mesh as a candidate: its memberships beside golden ones, with no table of either.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_COMPARE_MESH_ROWS_H
#define GRAZE_COMPARE_MESH_ROWS_H

#include "output/compare/comparison.h"
#include "questions/generate/generate.h"
#include "questions/judge/winding.h"

/** Points that a mesh is asked about. */
typedef struct mesh_points {
    const struct graze_generator *generator; /* those of its rows from 0 on; or NULL: */
    const fmpq *point;                       /* these, 3 canonical rationals each */
    size_t count;
    const char *explain_options; /* for `graze explain`, with a blank before each; NULL: none */
} mesh_points;

/**
 * Compare what a mesh says of points with exact answers, as graze_compare does with tables; the
 * report is the same, with the rows that disagree in it.
 *
 * A point on the mesh has no membership: with GRAZE_ON_AS_ANY it is undecided and counted as
 * `apart` unless the golden answer is `on`, and in the matrix in any case; with the other
 * conventions its answer is `on`.
 *
 * @param[out] out zeroed by the caller, and cleared by comparison_clear in either case
 * @param scene in space; shared by threads
 * @param mesh not of GRAZE_MESH_NONE
 * @param options on_as, show, solid, motion and scene (to measure wrong points in; NULL: none)
 * alone
 * @param threads at most TEAM_MOST
 * @return GRAZE_ELIMIT, GRAZE_ECANCELED, GRAZE_ESYSTEM, GRAZE_EINTERNAL
 */
graze_status comparison_of_mesh(graze_comparison *out, graze_context *context,
                                const graze_scene *scene, const judged_mesh *mesh,
                                const mesh_points *points, int threads,
                                const graze_compare_options *options);

#endif
