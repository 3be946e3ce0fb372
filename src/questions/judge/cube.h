/* A cube of space: its cells, its cover, its band, its gap to the mesh.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_QUESTIONS_JUDGE_CUBE_H
#define GRAZE_QUESTIONS_JUDGE_CUBE_H

#include <stdint.h>
#include "questions/judge/judge.h"

/* Cubes of space and what is certain of them. */

/** Kinds of a closed cube: all of its points are in the sweep, all are out, undecided, or flat,
 * where the mesh is the sweep's boundary. A cut cube has the flags of
 * all cubes below it. */
enum { CUBE_IN = 1, CUBE_OUT = 2, CUBE_BAND = 4, CUBE_FLAT = 8 };

/** Half the diagonal of a cube, rounded up. */
static inline double cube_radius(const cube *c) {
    return c->half * 0x1.bb67ae8584cabp+0; /* the root of 3, and a little more */
}

/** One of the eight parts of a cube, not classified. */
cube cube_part(const cube *whole, int k);

/* Space cut into cubes that are certainly inside the sweep or certainly outside it, and a band of
 * undecided cubes, which holds its boundary (proofs/judging.md C117). */

/** Bound of the level of a cube; the root has level 0. */
enum { CUBE_LEVELS = 48 };

/** Make the root, a cube around the scene's sweep. @return GRAZE_ELIMIT doubles do not hold it */
graze_status band_init(band *b, graze_context *context, const graze_scene *scene);
void band_clear(band *b);

/** Cut an uncut cube of the band, or a flat one, into eight, and classify these.
 * @param[out] done 0 if doubles do not hold smaller cubes: then nothing has changed
 * @return GRAZE_ELIMIT, GRAZE_ECANCELED, GRAZE_ESYSTEM */
graze_status band_cut(int *done, band *b, uint32_t index);

/** Do doubles hold the eight cubes of half the side exactly, and is there room for them? */
int band_can_cut(const band *b, const cube *c);

/** Classify the eight parts of a cube of the band that can be cut. The band is not changed.
 * @param ask of the thread
 * @return as band_cut */
graze_status band_parts(cube part[8], const band *b, cell_asker *ask, uint32_t index);

/** Cut a cube into parts that are classified. @return GRAZE_ESYSTEM */
graze_status band_take_parts(band *b, const cube part[8]);

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

/* The distance from a place to a mesh, in doubles with proved bounds. */

/** low <= distance <= high. */
typedef struct mesh_gap {
    double low, high;
    uint32_t
        simplex; /* a triangle at a distance of at most `high`; UINT32_MAX: the mesh has none */
} mesh_gap;

/** Bounds of the distance from a point to the nearest triangle (proofs/judging.md C118); infinite
 * for an empty mesh. */
mesh_gap mesh_gap_of(const judged_mesh *mesh, const double *point);

/** An upper bound of the distances from all points of a cube to one triangle. */
double mesh_gap_of_cube(const judged_mesh *mesh, uint32_t simplex, const double *centre,
                        double half);

/* Parts of a mesh in a recursive subdivision: nodes of its tree, then triangles and parts of them.
 */

enum { PART_OF_TRIANGLE = UINT32_MAX };

/** Make the part below a node of the mesh's tree. */
void mesh_part_of_node(mesh_part *out, const judged_mesh *mesh, uint32_t node);

/** Cut a part in two. */
void mesh_part_cut(mesh_part out[2], const judged_mesh *mesh, const mesh_part *whole);

/* A priority queue of numbers, the one with the greatest bound first. */

graze_status priority_add(priority *p, graze_context *context, double bound, uint32_t number);
/** Remove the first entry of a queue that is not empty. */
waiting_part priority_take(priority *p);
void priority_clear(priority *p);

/* The convex cells into which planes cut a cube, with exact volumes. */

/** Bounds of the numbers of planes, of cells, and of tetrahedra that the cells are made of. */
enum { CUBE_PLANES = 10, CUBE_CELLS = 64, CUBE_PARTS = 200 };

/** A cell of positive volume. */
typedef struct cube_cell {
    unsigned sides; /* bit k: the cell is where plane k is positive */
    fmpq at[4];     /* a point inside, and the volume */
} cube_cell;

/** Planes n x + d = 0, four numbers each, and their cells; `failed`: a bound is exceeded. */
typedef struct cube_cells {
    graze_context *context;
    int plane_count, failed;
    size_t count, capacity, parts;
    fmpq *plane;
    cube_cell *item;
} cube_cells;

/** Begin without planes. */
void cube_cells_init(cube_cells *c, graze_context *context);
void cube_cells_clear(cube_cells *c);
/** Add a plane, unless it is one of the planes, and drop the cells; n is not 0. */
void cube_cells_plane(cube_cells *c, const fmpq *plane);
/** Make the cells of a cube. @return GRAZE_ESYSTEM */
graze_status cube_cells_make(cube_cells *c, const cube *of);

/* Test whether a few positions of the solid together cover a cube. */

/** Try to cover a closed cube by positions of the solid (proofs/judging.md C124). At a seam several
 * positions are needed.
 * @param[out] done 1: all of the cube is in the sweep
 * @return GRAZE_ECANCELED, GRAZE_ESYSTEM */
graze_status cube_is_covered(int *done, cell_asker *ask, const cube *of);

/* Cubes in which the boundary of the sweep is the mesh, exactly. */

/** A cube as a box and as a span; chord_meets tests the span against triangles of a mesh. */
typedef struct cube_span {
    curve shape; /* dimension and corners alone */
    box space;
    span all;
} cube_span;

void cube_span_set(cube_span *out, const cube *c, const judged_mesh *mesh);

/** Test whether the mesh is the sweep's boundary in a cube of the band (proofs/judging.md C123):
 * the planes of the few triangles there cut it into cells, and each cell is inside both mesh and
 * sweep, or outside both. The cube becomes CUBE_FLAT; or CUBE_IN or CUBE_OUT with `beside`, if all
 * cells are alike.
 * @return as cell_certain */
graze_status flat_decide(cube *c, cell_asker *ask, const judged_mesh *mesh);

/** Classify a cube below a flat one: it is flat, or, if the mesh misses it, inside or outside; it
 * is of the band if it has too many cells. */
graze_status flat_child(cube *c, graze_context *context, const judged_mesh *mesh);

/** Add the volume of a flat cube's part inside the mesh. */
graze_status flat_volume(fmpq_t sum, graze_context *context, const cube *c,
                         const judged_mesh *mesh);

#endif
