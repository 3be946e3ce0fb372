/* judge: how far a mesh is from the sweep's boundary: its facts, its memberships, certified
 * distances and volumes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_QUESTIONS_JUDGE_H
#define GRAZE_QUESTIONS_JUDGE_H

#include <stdint.h>
#include "base/context/context.h"
#include "decide/lattice/lattice.h"
#include "decide/scene/scene.h"
#include "graze/judge.h"
#include "input/solid/solid.h"
#include "input/soup/soup.h"
#include "input/validate/validate.h"

/** A cube with exact centre and half side. */
typedef struct cube {
    double centre[3], half;
    uint32_t parent, child; /* the first of 8; 0: not cut */
    unsigned char kind, level;
    unsigned char beside; /* the sweep's boundary may meet its surface, and is the mesh there */
    uint32_t slab;        /* 1 + the number of its slab in suprema; 0: none */
} cube;

/** A cube of the band and a slab of it: all points above the slab have one membership, all those
 * below it too. */
typedef struct cube_slab {
    double centre[3], half;
    double normal[3], low, high; /* as in cell_slab */
    graze_pmc side[2];           /* below and above; IN, OUT, or another: open */
} cube_slab;

/* A mesh that is judged: any triangles, and the defects that keep them from bounding a solid. */

/** The mesh, immutable once made. Vertices at equal positions are one vertex. */
typedef struct judged_mesh {
    const soup *input; /* borrowed; E^3 */
    simplices cut;     /* its triangles but those without area */
    size_t flat_count; /* of triangles without area */
    loose_edges open;  /* the edges that forbid the next better rule */
    graze_mesh_rule rule;
    long least, most; /* of 0 and the winding numbers found beside triangles; GRAZE_MESH_WINDING */
    fmpq_t volume;    /* the integral of the winding number; set for GRAZE_MESH_WINDING, else 0 */
    double *low, *high; /* bounds of the coordinates, as in a solid */
    corners corners;    /* of the triangles, in doubles; `at` is NULL past their range */
    tree boxes;         /* empty if there are no triangles */
} judged_mesh;

/** Make a mesh from a soup, which may be empty. Facets with more than three corners are cut into
 * triangles as those of a solid are.
 * @param input of E^3, borrowed as long as the mesh lives
 * @param flags GRAZE_SOLID_TRIANGULATE: facets that are not planar are cut into fans
 * @return GRAZE_EILLEGAL a facet that is not planar or not simple; GRAZE_ELIMIT;
 * GRAZE_ECANCELED; GRAZE_ESYSTEM; GRAZE_EINTERNAL; judged_mesh_clear in any case */
graze_status judged_mesh_make(judged_mesh *out, graze_context *context, const soup *input,
                              unsigned flags);
void judged_mesh_clear(judged_mesh *m);

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

/** A part of the mesh with its reference point x, which is near a point of the part. */
typedef struct mesh_part {
    uint32_t node;    /* of the tree, or PART_OF_TRIANGLE */
    uint32_t simplex; /* a triangle at x */
    double corner[9]; /* of a triangle: its corners, each within `error` of the exact one */
    double error;     /* x too is within `error` of a point of the mesh */
    double x[3];
    double radius; /* bound of the distance of x to points of the exact part */
} mesh_part;

typedef struct waiting_part {
    double bound;
    uint32_t number;
} waiting_part;

/** A queue; zeros are an empty one. Of equal bounds the lower number is first, so that the order is
 * always the same. */
typedef struct priority {
    size_t count, capacity;
    waiting_part *item;
} priority;

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
    double out; /* upper bound of the distance of x to a point that is outside; or infinite */
    int is_cut, is_probed;
    int steps; /* points off the part that have been asked */
} asked_part;

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
    size_t slab_count, slab_capacity;
    cube_slab *slab;               /* for the volumes */
    fmpq volume[2 * VOLUME_COUNT]; /* a lower and an upper bound of each */
    int has_difference;            /* the bounds of MISSING and EXCESS are set */
} suprema;

/* Enclosures of the greatest distances between a mesh and the boundary of a sweep, each way. */

/** Enclose three greatest distances (proofs/judging.md C119): of the mesh's points outside the
 * sweep to the sweep, of its points inside to the complement, and of the sweep's boundary to the
 * mesh. Enclose the volumes too.
 * @param within the width wanted, positive
 * @param budget bound of the number of cubes and points asked
 * @param threads for the volumes; their number changes nothing but the time
 * @return GRAZE_ELIMIT, GRAZE_ECANCELED, GRAZE_ESYSTEM; suprema_clear in any case */
graze_status suprema_find(suprema *out, graze_context *context, const graze_scene *scene,
                          const judged_mesh *mesh, double within, size_t budget, int threads);
void suprema_clear(suprema *s);

/* The handles of graze/judge.h: a mesh, and what its comparison with a sweep has found. */

struct graze_mesh {
    soup input;
    judged_mesh judged;
};

struct graze_judgement {
    const graze_mesh *mesh; /* borrowed */
    suprema searched;
};

/* The place of a point relative to a mesh, and its winding number. */

/** The place of a point: it is inside if the winding number is not 0, or is odd, by the mesh's rule
 * (proofs/mesh.md C114). */
typedef enum mesh_place {
    MESH_IN,
    MESH_ON, /* on a triangle with area, whatever the rule */
    MESH_OUT,
    MESH_UNTOLD /* off a mesh that has no inside (GRAZE_MESH_NONE) */
} mesh_place;

/** Locate a point exactly. Threads may use the same mesh at the same time.
 * @param[out] winding the winding number for GRAZE_MESH_WINDING at points off the mesh, else 0
 * @param point 3 canonical rationals */
mesh_place judged_place(long *winding, const judged_mesh *m, const fmpq *point);

/** Set `least` and `most` from the exact winding numbers on both sides of some of the triangles;
 * elsewhere there may be other ones. */
void judged_windings(judged_mesh *m);

#endif
