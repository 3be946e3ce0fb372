/* What the searches for greatest distances have in common: how they ask, and what is open.
 * SPDX-License-Identifier: GPL-3.0-or-later
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
    double at[3]; /* of the mesh a point that is at least `low` away, within rounding; a point from
                     which the nearest place of the boundary is; set if `low` > 0 */
    double time;  /* when the solid is nearest to that point, or it is deepest in it */
    double open[3]; /* a point near which the distance is perhaps `high` */
    int reached;    /* high - low is at most what was asked for */
    int stuck;      /* no cut makes it less: near `open` the boundary is perhaps a seam */
} supremum;

/** A part of the mesh and what is known at its point. */
typedef struct asked_part {
    mesh_part part;
    struct known_point {
        graze_pmc pmc;
        double low, high; /* the signed distance (C66) is between them; 0 where it was not asked */
    } known;
    double outside, inside; /* bounds of the distances in the part */
    int is_cut, is_probed;
} asked_part;

typedef struct known_point known_point;

/** Volumes that are enclosed: of the sweep, of its part outside the mesh, of the mesh's outside it.
 */
enum { IN_SWEEP, MISSING, EXCESS, VOLUME_COUNT };

/** One sequence of steps, which the budget alone ends: so a larger one tells no less. */
typedef struct suprema {
    graze_context *context;
    const graze_scene *scene;
    const judged_mesh *mesh;
    double within;
    size_t budget, asked;   /* cubes and points that may be asked, and the points that were */
    int threads, uncovered; /* cubes that were not covered by positions */
    band space;
    priority cubes; /* those of the band in which the boundary may be far from the mesh */
    size_t part_count, part_capacity;
    asked_part *part;
    priority outer, inner; /* parts that may be far outside, and inside */
    supremum found[GRAZE_JUDGED_COUNT];
    fmpq volume[2 * VOLUME_COUNT]; /* below and above */
    int has_difference;            /* to the mesh: all volumes are known */
} suprema;

/** When a point's distance is asked for, to a share of the width that is wanted. */
typedef enum ask_distance { ASK_NO_DISTANCE, ASK_OUT, ASK_IN } ask_distance;

/** The membership; and with `distance` that of an `out` (`in`) point. */
graze_status suprema_ask(known_point *out, suprema *s, const double *point, ask_distance distance);

/** When the solid is nearest to a point, or the point deepest in it, to a share of the width. */
graze_status suprema_time(double *out, suprema *s, const double *point);

/** Try to settle a cube of the band of which the centre is inside: by the ball about it that is in
 * one position of the solid (C66 (c)).
 * @param[out] done whether that is so */
graze_status suprema_settle(int *done, suprema *s, uint32_t cube);
/** A point of W and one outside, of a cube's centre and the eight places around it. */
typedef struct cube_sample {
    int has_in, has_out;
    double in[3], out[3];
} cube_sample;

/** Ask around a cube, until both are found. */
graze_status suprema_sample(cube_sample *out, suprema *s, uint32_t cube);

/**
 * Cut a cube of the band, and of those below it the one nearest to a place again, until it shows
 * what is there: a point around one is outside, or none is left of the band.
 * @param[out] stuck neither, down to a small share of the width: perhaps a seam */
graze_status suprema_probe(int *stuck, suprema *s, uint32_t cube, const double *toward);

/** Cubes of at most this share of the width that is wanted are probed; larger ones are cut. */
#define PROBED_SHARE 0.125

/** A cube that is measured counts as so many that are looked at. */
enum { MEASURED = 256 };

/** What of the budget is spent. */
size_t suprema_spent(const suprema *s);
int suprema_is_over(const suprema *s);
/** Set `high` and what follows from it, by the first that waits at `open`. */
void supremum_finish(supremum *found, const suprema *s, const priority *wait, const double *open);

#endif
