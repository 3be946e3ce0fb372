/* lattice: memberships of the points of a grid, whole cells at once where that is certain.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_DECIDE_LATTICE_H
#define GRAZE_DECIDE_LATTICE_H

#include <flint/fmpq.h>
#include <pthread.h>
#include <stddef.h>
#include "base/number/text.h"
#include "decide/bounds/bounds.h"
#include "decide/filter/filter.h"
#include "decide/scene/scene.h"

/* The points of a grid: along each axis equal steps from one rational to another. */

/** Coordinate i of axis k is (start + i step) / unit. Immutable once made. */
typedef struct lattice {
    int dimension;
    size_t size[3], count; /* sizes past the dimension are 1 */
    fmpz start[3], step[3], unit[3];
} lattice;

/** @param size at least 2, with a product that a size_t holds
 * @param low, high of each axis, low < high */
void lattice_make(lattice *out, int dimension, const size_t *size, const fmpq *low,
                  const fmpq *high);
void lattice_clear(lattice *l);

/** Coordinate i of axis k. */
void lattice_coordinate(fmpq_t out, const lattice *l, int k, size_t i);

/** Set the place of point `index` along each axis; the first axis runs fastest. */
void lattice_place(size_t place[3], const lattice *l, size_t index);

/* Memberships of a brick of grid points, decided for whole cells of points where possible. */

/** Points along an axis of a brick, in E^2 and in E^3; a brick has at most BRICK_POINTS. */
enum { BRICK_SIDE_PLANE = 64, BRICK_SIDE_SPACE = 16, BRICK_POINTS = 4096 };

/** A brick: the points from `first` to before `end` along each axis. */
typedef struct brick {
    size_t first[3], end[3];
} brick;

/**
 * Decide the points of a brick, x running fastest.
 * @param[out] pmc a graze_pmc for each point; 0 for a point that met a limit or a fault, and meets
 * it again if asked alone
 * @return GRAZE_ECANCELED, GRAZE_ESYSTEM, GRAZE_EINTERNAL
 */
graze_status brick_decide(unsigned char pmc[BRICK_POINTS], graze_context *context,
                          const graze_scene *scene, const lattice *l, const brick *points);

/* The bricks of a grid; each is decided once, when one of its points is first asked for. */

/** A brick; once decided it has one membership for all points, or one for each point. */
typedef struct brick_state {
    int busy;             /* a thread is deciding it */
    unsigned char common; /* 0: see pmc */
    unsigned char *pmc;   /* NULL: not decided, or `common` */
} brick_state;

/** All bricks, shared by threads. Bricks far before the last one asked for are freed. */
typedef struct bricks {
    const graze_scene *scene; /* borrowed */
    const lattice *lattice;
    size_t side, count[3];
    pthread_mutex_t lock;
    pthread_cond_t changed;
    size_t kept; /* the first layer along the last axis that is kept; earlier ones are freed */
    brick_state *state;
} bricks;

/** @return 0 if memory runs out. The caller calls bricks_clear, also on failure */
int bricks_make(bricks *out, const graze_scene *scene, const lattice *l);
void bricks_clear(bricks *b);

/**
 * Give the memberships of a point and of the points after it in its row of a brick, at most `most`.
 * @param[out] pmc   as of brick_decide
 * @param[out] count the number of points
 * @return as brick_decide
 */
graze_status bricks_row(unsigned char *pmc, size_t *count, graze_context *context, bricks *b,
                        size_t index, size_t most);

/* Rows of grid points as text; most texts of coordinates are made once. */

/** The texts of the first axis's coordinates, unless they are too many; shared by threads. */
typedef struct axis_texts {
    pthread_mutex_t lock;
    int made;
    text all;
    size_t *end; /* the end of each text; NULL: texts are made when needed */
} axis_texts;

void axis_texts_init(axis_texts *a);
void axis_texts_clear(axis_texts *a);

/**
 * Add rows of points first, first + step, ...: coordinates and membership, separated by commas.
 * @param pmc a graze_pmc for each
 */
void rows_put(text *out, axis_texts *a, const lattice *l, const unsigned char *pmc, size_t first,
              size_t step, size_t count);

/* The membership of all points of a cell at once, where that is certain. */

/** The state of one thread that asks for cells. */
typedef struct cell_asker {
    graze_context *context;   /* borrowed */
    const graze_scene *scene; /* borrowed; of a polygon or polyhedron */
    curve tube;
    size_t time; /* number of the time at which a cell was settled last (point_box_is_settled) */
    int corners; /* 1: corners of cells are doubles, and cell_certain asks about them */
} cell_asker;

/** Anchors with which the points of a cell may be joined. */
typedef struct anchors {
    anchor item[CERTAIN_TIMES_MOST];
    int count;
} anchors;

void cell_asker_init(cell_asker *out, graze_context *context, const graze_scene *scene);
void cell_asker_clear(cell_asker *a);

/** Are the points of a cell certainly joined with one of the anchors? Then they have the membership
 * that an anchor proves. The caller has set the asker's tube to the cell. */
int cell_joins(cell_asker *a, const point_box *points, const anchors *near);

/** Find up to CERTAIN_TIMES_MOST times at which the centre of a cell is in the state that decides a
 * membership (proofs/cells.md C76 (b)); returns their number. */
int cell_certain_times(piece_time when[CERTAIN_TIMES_MOST], const cell_asker *a,
                       const point_box *points);

/** The membership of a point that is in the deciding state at some time. */
graze_pmc cell_membership_proved(const cell_asker *a);

/** The common membership of all points of a cell; NONE if it is not certain that there is one
 * (proofs/cells.md C76).
 * @param[in,out] near anchors of a cell around this one; replaced by the cell's own, if it has some
 * @param smallest 1 if the points of an undecided cell are asked one by one next: then no anchors
 * are sought, since a search costs as much as a few points
 */
graze_pmc cell_decide(cell_asker *a, const point_box *points, anchors *near, int smallest);

/**
 * Ask as cell_decide does, with all tests, also of the parts of the boundary that pass through the
 * cell (proofs/judging.md C116).
 * @return GRAZE_ELIMIT, GRAZE_ECANCELED; GRAZE_ESYSTEM also if memory is too short for a test
 */
graze_status cell_certain(graze_pmc *out, cell_asker *a, const point_box *points, anchors *near);

/** Have all points of a cell within walls certainly the membership `pmc`, in a sweep of E^3
 * (proofs/judging.md C123)?
 * @param inside one of them, three rationals
 * @return as cell_certain
 */
graze_status cell_part_has(int *out, cell_asker *a, const point_box *points,
                           const cell_walls *walls, const fmpq *inside, graze_pmc pmc);

/**
 * Seek a slab of a cube beside which memberships are certain, in a sweep of E^3
 * (proofs/judging.md C130).
 * @param[in,out] slab begun
 * @param[out] side the memberships below the slab and above it; NONE: not certain, or nothing there
 * @return as cell_certain
 */
graze_status cell_slab_find(graze_pmc side[2], cell_slab *slab, cell_asker *a);

#endif
