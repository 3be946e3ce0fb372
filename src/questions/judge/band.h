/* Space cut into cubes that are certainly inside the sweep or certainly outside it, and a band of
 * undecided cubes, which holds its boundary (proofs/judging.md C117).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_JUDGE_BAND_H
#define GRAZE_JUDGE_BAND_H

#include "decide/lattice/cell_asker.h"
#include "questions/judge/cube.h"
#include "questions/judge/judged_mesh.h"

/** Bound of the level of a cube; the root has level 0. */
enum { CUBE_LEVELS = 48 };

/** An octree of cubes. Cube 0 is the root; it contains the sweep. */
typedef struct band {
    cell_asker ask;
    const judged_mesh *mesh; /* cubes may be flat relative to it; NULL: none is */
    size_t count, capacity;
    cube *item;
    size_t flat, rough; /* counts of cubes found flat, and of the band */
    int gave_up;        /* no further cube is tested for being flat */
    size_t decided;     /* cubes that were classified */
    size_t seen;        /* cubes visited by band_nearest and by volumes_find */
} band;

/** Make the root, a cube around the scene's sweep. @return GRAZE_ELIMIT doubles do not hold it */
graze_status band_init(band *b, graze_context *context, const graze_scene *scene);
void band_clear(band *b);

/** Cut an uncut cube of the band, or a flat one, into eight, and classify these.
 * @param[out] done 0 if doubles do not hold smaller cubes: then nothing has changed
 * @return GRAZE_ELIMIT, GRAZE_ECANCELED, GRAZE_ESYSTEM */
graze_status band_cut(int *done, band *b, uint32_t index);

/** Cut the uncut cubes of the band, from number `next` on, whose radius exceeds `radius`. The
 * number of threads changes nothing but the time.
 * @param[in,out] next the first cube to look at; then the cube to go on with
 * @param most bound of the number of cubes that are cut
 * @return as band_cut */
graze_status band_cut_large(size_t *next, band *b, double radius, size_t most, int threads);

/** Set the kind of a cube of the band that the caller has proved. */
void band_settle(band *b, uint32_t index, unsigned char kind);

/** The membership of a point of doubles if its cube is inside or outside the sweep, else NONE. */
graze_pmc band_membership(const band *b, const double *point);

/** Find the uncut cube of some kinds that is nearest to a point. The space outside the root counts
 * as CUBE_OUT. If `kinds` has CUBE_FLAT without CUBE_BAND, the distance to a flat cube is that to
 * its farthest point.
 * @param kinds CUBE_ flags
 * @param least cubes with a half side less than this are left out
 * @param[out] low, high bounds of the distance
 * @return the cube's number; UINT32_MAX for the space outside the root, or if there is no cube:
 * then `high` is infinite */
uint32_t band_nearest(double *low, double *high, band *b, const double *point, int kinds,
                      double least);

#endif
