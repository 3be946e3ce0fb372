/* Space cut into cubes of which it is certain that they are inside the sweep, or outside; what is
 * left is a band that holds its boundary (proofs/judging.md C117).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_JUDGE_BAND_H
#define GRAZE_JUDGE_BAND_H

#include "decide/lattice/cell_asker.h"
#include "questions/judge/cube.h"
#include "questions/judge/judged_mesh.h"

/** Levels of cubes, at most. */
enum { CUBE_LEVELS = 48 };

/** Cube 0 is the root, outside of which all is outside the sweep. */
typedef struct band {
    cell_asker ask;
    const judged_mesh *mesh; /* of which cubes may be flat, or NULL */
    size_t count, capacity;
    cube *item;
    size_t flat, rough; /* cubes found flat, or of the band */
    int gave_up;        /* no more are tried */
    size_t decided;     /* cubes asked about */
    size_t seen;        /* cubes looked at for the nearest one, or for volumes */
} band;

/** The root of a scene's sweep. @return GRAZE_ELIMIT it is beyond doubles */
graze_status band_init(band *b, graze_context *context, const graze_scene *scene);
void band_clear(band *b);

/** Cut an uncut cube of the band, or a flat one; those below it are decided.
 * @param[out] done 0 if doubles hold no smaller one: then nothing has changed
 * @return GRAZE_ELIMIT, GRAZE_ECANCELED, GRAZE_ESYSTEM */
graze_status band_cut(int *done, band *b, uint32_t index);

/** Cut those cubes of the band from the number `next` on, of them that there are, that have more
 * than a radius, at most so many; in threads, which change nothing but the time.
 * @param[in,out] next where to go on
 * @return as band_cut */
graze_status band_cut_large(size_t *next, band *b, double radius, size_t most, int threads);

/** Say what is certain of a cube of the band, as was found otherwise. */
void band_settle(band *b, uint32_t index, unsigned char kind);

/** The membership of a point of doubles where its cube tells, else NONE. */
graze_pmc band_membership(const band *b, const double *point);

/**
 * The uncut cube of one of some kinds that is nearest to a point; outside the root is CUBE_OUT. Of
 * those that are flat, without the band, the one of which all points are nearest.
 * @param least half a side, at least
 * @param[out] low, high of its distance, or of that of all its points
 * @return its number; UINT32_MAX where it is the outside of the root, or none: then high is
 * infinite
 */
uint32_t band_nearest(double *low, double *high, band *b, const double *point, int kinds,
                      double least);

#endif
