/* The common state of the searches for greatest distances, and their questions about points and
 * cubes. SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_JUDGE_OPEN_SEARCH_H
#define GRAZE_JUDGE_OPEN_SEARCH_H

#include "questions/judge/band.h"
#include "questions/judge/mesh_gap.h"
#include "questions/judge/mesh_part.h"
#include "questions/judge/priority.h"

/** A greatest distance is in [low, high]. */
typedef struct supremum {
    double low, high;
    double at[3]; /* set if `low` > 0: a place with a distance of at least `low`: of the mesh,
                     within rounding; for the sweep's boundary a point close to it */
    double time;  /* a time at which the solid is nearest to that point, or has it deepest inside */
    double open[3]; /* a point near which the distance may be `high` */
    int reached;    /* high - low is at most the width asked for */
    int stuck; /* the search cannot refine near `open`: a seam of the sweep, or coordinates beyond
                  double precision */
} supremum;

/** A part of the mesh, with the membership and the distance of its reference point. */
typedef struct asked_part {
    mesh_part part;
    struct known_point {
        graze_pmc pmc;
        double low, high; /* bounds of the signed distance (C66); 0 if it was not asked for */
    } known;
    double outside, inside; /* upper bounds of the part's distances outside and inside the sweep */
    int is_cut, is_probed;
} asked_part;

typedef struct known_point known_point;

/** Volumes: of the sweep, of the sweep outside the mesh, of the mesh outside the sweep. */
enum { IN_SWEEP, MISSING, EXCESS, VOLUME_COUNT };

/** The state of all searches. Their sequence of steps does not depend on the budget, which only
 * ends it: a larger budget gives narrower bounds or the same. */
typedef struct suprema {
    graze_context *context;
    const graze_scene *scene;
    const judged_mesh *mesh;
    double within;
    size_t budget, asked;   /* cubes and points that may be asked; points that were asked */
    int threads, uncovered; /* cubes that cube_is_covered was asked about in vain */
    band space;
    priority cubes; /* cubes of the band, by bounds of the boundary's distance to the mesh */
    size_t part_count, part_capacity;
    asked_part *part;
    priority outer, inner; /* parts, by bounds of their distances outside and inside the sweep */
    supremum found[GRAZE_JUDGED_COUNT];
    fmpq volume[2 * VOLUME_COUNT]; /* a lower and an upper bound of each */
    int has_difference;            /* the bounds of MISSING and EXCESS are set */
} suprema;

/** For which points the distance is asked: none, `out` ones, `in` ones. */
typedef enum ask_distance { ASK_NO_DISTANCE, ASK_OUT, ASK_IN } ask_distance;

/** Ask for the membership of a point, and for its distance, to a share of the width wanted, if the
 * membership is the one that `distance` names. */
graze_status suprema_ask(known_point *out, suprema *s, const double *point, ask_distance distance);

/** Find a time at which the solid is nearest to a point, or has it deepest inside, to a share of
 * the width wanted. */
graze_status suprema_time(double *out, suprema *s, const double *point);

/** Try to prove that a cube of the band is in the sweep: by the ball about its centre that is in
 * one position of the solid (C66 (c)), or by several positions (cube_cover.h).
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

#endif
