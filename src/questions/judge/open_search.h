/* The search of cubes, deepest first.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_QUESTIONS_JUDGE_OPEN_SEARCH_H
#define GRAZE_QUESTIONS_JUDGE_OPEN_SEARCH_H

#include "questions/judge/judge.h"

/** The mesh's triangles as a skin, which borrows them. */
static inline skin judged_skin(const judged_mesh *m) {
    return (skin){m->input, &m->cut, m->low, m->high, &m->boxes};
}

/* The common state of the searches for greatest distances, and their questions about points and
 * cubes. */

typedef struct known_point known_point;

/** For which points the distance is asked: none, `out` ones, `in` ones. */
typedef enum ask_distance { ASK_NO_DISTANCE, ASK_OUT, ASK_IN } ask_distance;

/** Ask for the membership of a point, and for its distance, to a share of the width wanted, if the
 * membership is the one that `distance` names. */
graze_status suprema_ask(known_point *out, suprema *s, const double *point, ask_distance distance);

/** Find a time at which the solid is nearest to a point, or has it deepest inside, to a share of
 * the width wanted. */
graze_status suprema_time(double *out, suprema *s, const double *point);

/** Try to prove that a cube of the band is in the sweep: by the ball about its centre that is in
 * one position of the solid (C66 (c)), or by several positions (cube.h).
 * @param[out] done 1: proved, and the cube is CUBE_IN */
graze_status suprema_settle(int *done, suprema *s, uint32_t cube);
/** A point of the closed sweep and one outside, of a cube's centre and eight points around it. */
typedef struct cube_sample {
    int has_in, has_out;
    double in[3], out[3];
} cube_sample;

/** Ask these nine points about the sweep until both are found. */
graze_status suprema_sample(cube_sample *out, suprema *s, uint32_t cube);

/** Cut a cube of the band, then again the cube below that is nearest to a place, until a point
 * around a cube is outside, or no cube there is left in the band.
 * @param[out] stuck 1: cubes of a small share of the width show neither; there may be a seam */
graze_status suprema_probe(int *stuck, suprema *s, uint32_t cube, const double *toward);

/** Cubes with a radius up to this share of the width wanted are probed; larger ones are cut. */
#define PROBED_SHARE 0.125

/** A cube that volumes_find measures costs as much as MEASURED cubes that are visited. */
enum { MEASURED = 256 };

/** The spent part of the budget. */
size_t suprema_spent(const suprema *s);
int suprema_is_over(const suprema *s);
/** Set `high`, `reached` and, if a part waits, `open`, from the greatest bound that waits. */
void supremum_finish(supremum *found, const suprema *s, const priority *wait, const double *open);

/* The searches for the greatest distances of the mesh, outside the sweep and inside it. */

/** Begin with one part, the whole mesh; it has triangles. */
graze_status search_mesh_begin(suprema *s);
/** Do a step of one of the searches: process the part with the greatest bound. */
graze_status search_outside_step(suprema *s);
graze_status search_inside_step(suprema *s);

/* The search for the greatest distance of the sweep's boundary to the mesh. */

/** Begin with one cube, the root; the mesh has triangles. */
graze_status search_sweep_begin(suprema *s);
/** Do a step: process the cube with the greatest bound. */
graze_status search_sweep_step(suprema *s);

/* Slabs of the cubes of the band, beside which memberships are certain (proofs/judging.md C130). */

/** Give slabs to cubes of the band, and cut those that have none, until none is larger than the
 * width wanted, or the budget is spent: the volumes need it.
 * @return as band_cut */
graze_status slabs_find(suprema *s);

/** Bounds of the share of a cube that is in the sweep.
 * @param c the slab's cube or one in it of at least 2^-8 of its size */
void slab_shares(double inside[2], const cube_slab *s, const cube *c);

/* Enclosures of the volumes of the sweep and of its differences to a mesh. */

/** Enclose the volumes from the band's cubes (proofs/judging.md C117); IN_SWEEP alone if the mesh
 * has no inside, or is too far away.
 * @return GRAZE_ECANCELED */
graze_status volumes_find(suprema *s);

#endif
