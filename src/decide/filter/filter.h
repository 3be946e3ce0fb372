/* filter: certain crossings of a trajectory in doubles with proved bounds, and the windows in
 * which the exact path is asked.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_DECIDE_FILTER_H
#define GRAZE_DECIDE_FILTER_H

#include <flint/fmpq.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include "decide/bounds/bounds.h"
#include "decide/surfaces/surfaces.h"
#include "input/motion/motion.h"
#include "input/solid/solid.h"
#include "input/validate/validate.h"

/* Results of the filter's search: certain crossings, and candidates for the exact path. */

/** The trajectory may meet the simplex within the closed window, in units of 2^-WINDOW_LEVELS. */
typedef struct candidate {
    uint32_t piece, simplex;
    uint32_t from, to;
} candidate;

typedef struct candidates {
    size_t count, capacity;
    candidate *item;
} candidates;

static inline void candidates_clear(candidates *list) {
    free(list->item);
}

/** Append a candidate; 0 if memory runs out. */
int candidates_append(candidates *list, candidate item);

/** Sort by piece, simplex and time, and join windows of one simplex that touch. */
void candidates_join(candidates *list);

/** A certain crossing: at just one time of [from, to] the curve goes through the relative interior
 * of the simplex. Both are parameters of the piece, beyond [0, 1] by rounding at most. `enters`:
 * the curve goes from outside to inside. */
typedef struct crossing {
    double from, to;
    uint32_t piece, simplex;
    int enters;
} crossing;

/** Candidates `first` ... `first + count - 1`, whose windows overlap: the exact path answers for
 * all of [from, to], in units of 2^-WINDOW_LEVELS, at once. */
typedef struct exact_window {
    uint32_t piece, from, to;
    size_t first, count;
} exact_window;

/** The crossings and the windows in order of time, disjoint within each piece; `lost` are the
 * pieces, in order, for which the filter cannot be used. At times in none of these the trajectory
 * is off the boundary. */
typedef struct findings {
    size_t crossing_count, crossing_capacity;
    crossing *crossing;
    candidates asked;
    size_t window_count, window_capacity;
    exact_window *window;
    size_t lost_count, lost_capacity;
    uint32_t *lost;
} findings;

/* The certified floating-point filter of a scene: it finds the certain crossings of the boundary,
 * and the windows of time for which the exact path must be asked.
 *
 * For a simplex it reports no contact, one certain crossing, or a question; it never decides a
 * tangency, an edge, a vertex or an end (proofs/filter.md C36, C37). */

/** A grid of equal bricks over the solid's box; `state` is NULL if there is none. */
typedef struct interior {
    int dimension;
    size_t count[3];
    double low[3], step[3];
    unsigned char *state; /* a graze_state for each brick; ABSENT: not certain */
} interior;

/** The bricks of a solid, laid under the lock when memberships alone are first asked for. */
typedef struct brick_memo {
    pthread_mutex_t lock;
    interior all;
    atomic_int laid; /* once set, `all` does not change */
} brick_memo;

/** Data of a scene for the filter; immutable but for the memo, shared by threads. */
typedef struct filter {
    const graze_solid *solid; /* borrowed */
    course course;
    brick_memo *bricks;
    graze_state proves; /* the state that decides a membership if the point is in it at one time */
} filter;

/** Make the filter of a solid and a motion.
 * @param operation chooses the motion's point maps that carry the query points */
graze_status filter_make(filter *out, graze_context *context, const graze_solid *solid,
                         const graze_motion *motion, graze_operation operation);
void filter_clear(filter *f);
/** The bricks, or NULL if none are laid. */
const interior *filter_bricks(const filter *f);

/** Lay the bricks unless they are laid: they spare searches where memberships alone are asked for.
 */
graze_status filter_lay_bricks(const filter *f, graze_context *context);

/** Memory of one thread, reused from query to query. */
typedef struct filter_workspace {
    int set; /* 1 if `curve` is the trajectory of the current point */
    curve curve, ray;
    findings found, ray_found;
    form_memory forms; /* forms of the solid that was asked about last */
    /* For a curved solid: products along the curve, and truths at the start of the motion. */
    surface_curve along;
    truths truths;
} filter_workspace;

/** The context's workspace, made at the first call and owned by the context; NULL if memory runs
 * out. */
filter_workspace *filter_workspace_of(graze_context *context);

/** Forget the last point. */
void filter_begin(filter_workspace *w);

/** Set the workspace's curve, unless it is set; 0 if the filter cannot be used for it. */
int filter_set(filter_workspace *w, const filter *f, const filter_point *point);

/** Search all pieces. The findings stand in the workspace until the next search.
 * @param[out] settled NULL, or set to 1 if the point is at some time in the state that decides its
 * membership, and then there are no findings; else set to 0
 * @param bricks used with `settled`: their states may settle the membership; NULL: crossings alone
 * @return 0 if the filter cannot be used for this point, or if memory runs out: the exact search is
 * asked */
int filter_search(filter_workspace *w, int *settled, const interior *bricks, const filter *f,
                  const filter_point *point);

/* The search of a curve for the surfaces of a curved solid that it meets. */

/**
 * Find all surfaces that a point's trajectory meets (proofs/surfaces.md C106). Until the next
 * search the workspace holds the findings, in which `simplex` is the number of a surface, and in
 * `truths` the signs at the start of the motion.
 * @param exactly leave all times of a surface's findings to the exact path: windows of whole pieces
 * @return 0 if the filter cannot be used for this point, or if memory runs out
 */
int surfaces_search(filter_workspace *w, const surface_filter *f, const filter_point *point,
                    int exactly);

/* Where a trajectory is at one time, by a ray in doubles (proofs/filter.md C38). */

/**
 * The state of a point at the parameter u of a piece.
 * @return GRAZE_STATE_I or GRAZE_STATE_O, or GRAZE_STATE_ABSENT: ask the exact location
 */
graze_state filter_locate(filter_workspace *w, const filter *f, size_t piece,
                          const filter_point *point, double u);

/* Times between certain crossings, at which the state of a trajectory is certain too. */

/** A time: the motion's piece and the piece's parameter, in [0, 1]. */
typedef struct piece_time {
    uint32_t piece;
    double at;
} piece_time;

/** certain_times_find finds at most this number of times. */
enum { CERTAIN_TIMES_MOST = 2 };

/** Find the middles of the longest stretches of time in which the point of a search is certainly
 * inside or, if `outside` is set, certainly outside (proofs/cells.md C76).
 * @param found the findings of filter_search
 * @return the number of times found; 0 also if a finding is not certain, or there is no crossing */
int certain_times_find(piece_time out[CERTAIN_TIMES_MOST], const findings *found,
                       size_t piece_count, int outside);

/* Tests of the trajectories of all points of a box at once against the boundary. */

/** A box of query points: coordinate i of each differs from the centre's by at most half[i]. */
typedef struct point_box {
    double centre[3]; /* exact */
    double half[3];
} point_box;

/** A time and a box of places; at that time some place of the box is in the state that decides a
 * membership (proofs/bricks.md C87). */
typedef struct anchor {
    piece_time when;
    box around;
} anchor;

/** Set a thread's memory to the trajectory of a cell's centre. The functions below take a memory
 * that was set for the cell they are asked about.
 * @return 0 if the filter cannot be used for it, or if memory runs out */
int point_box_begin(curve *memory, const filter *f, const point_box *points);

/** Is it certain that no point of the cell meets the boundary at any time (proofs/cells.md C76)?
 * @return 0 if that is not certain */
int point_box_is_clear(curve *memory, const filter *f, const point_box *points);

/** Is it certain that at the anchor's time the boundary does not separate the anchor from any point
 * of the cell? Then all points of the cell have the anchor's state (proofs/bricks.md C87).
 * @return 0 if that is not certain */
int point_box_joins(curve *memory, const filter *f, const point_box *points, const anchor *to);

/** Is it certain that at some time all points of the cell are in the state that decides their
 * membership (proofs/bricks.md C86)?
 * @param[in,out] hint number of the time that is tried first, 0 for the first cell; set to the time
 * that settled the cell
 * @return 0 if that is not certain */
int point_box_is_settled(curve *memory, const filter *f, const point_box *points, size_t *hint);

/** Find a box around the places of the cell's points at a time or, if `half` is NULL, around the
 * place of the centre. 0 if none is found. */
int point_box_places(box *out, curve *memory, const filter *f, const piece_time *when,
                     const double *half);

/* Tests whether every contact of the trajectories of a box's points is a crossing of the boundary.
 */

/** Results about the trajectories of a cell's points (proofs/judging.md C116). */
typedef enum cell_passage {
    CELL_DOUBTFUL, /* nothing is certain */
    CELL_PASSES,   /* no point of the cell is `on`, so all have one membership */
    CELL_PIERCED /* a facet crosses the whole cell: all points are `in` a sweep, `out` of an unsweep
                  */
} cell_passage;

/** The points x of a cube for which normal·(x - centre) / half is in [low, high], exactly. The walk
 * of cell_passes makes it grow: it leaves out of account all contacts of these points
 * (proofs/judging.md C130). */
typedef struct cell_slab {
    const course *placing; /* from the space of the standing solid to that of the query points */
    double centre[3], half;
    double normal[3]; /* the greatest coordinate is 1 in absolute value; or a sum in the making */
    double reach; /* bound of the form's absolute values in the cube; 0: there is no normal yet, and
                     the walk adds up those of the contacts that are not certain */
    double low, high; /* low > high: it is empty */
    double most;      /* a thicker slab is not wanted */
} cell_slab;

/** Begin with an empty slab without a normal. */
void cell_slab_begin(cell_slab *out, const course *placing, const double *centre, double half,
                     double most);

/** Scale the sum of normals to be the slab's normal; 0 if the sum is 0. */
int cell_slab_turn(cell_slab *s);

/** Find a point of the cube above the slab or below it; 0 if there is none for certain. */
int cell_slab_beside(double at[3], const cell_slab *s, int above);

/** The points of a cell that are strictly on one side of each plane n x + d = 0; or those beside a
 * slab, which is sought. */
typedef struct cell_walls {
    int count;
    const fmpq *plane; /* four numbers each */
    unsigned sides;    /* bit k: the form of plane k is positive in the part, else negative */
    cell_slab *slab;   /* or NULL; else there are no planes */
} cell_walls;

/**
 * Find what is certain of the trajectories of all points of a cell.
 * @param memory set to the cell (point_box_begin)
 * @param walls  NULL, or the part of the cell that is asked about (proofs/judging.md C123)
 * @param motion of the sweep; used with walls */
cell_passage cell_passes(curve *memory, const filter *f, const point_box *points,
                         const cell_walls *walls, const graze_motion *motion);

/* The sides of one simplex, for the exact path. */

/** The sides of a simplex at the times of a window at which the curve is in its plane
 * (proofs/doubles.md C65).
 * @param[out] inside bit k: the curve is certainly on the inner side of side k
 * @return 0 if the curve is certainly beyond a side, and so off the simplex */
int sides_meet(unsigned *inside, const curve *c, const span *piece, const double *corner,
               double corner_error, const meet_window *at);

#endif
