/* graze/boundary.h - the boundary of a sweep by adaptive sampling.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_BOUNDARY_H
#define GRAZE_BOUNDARY_H

#include <graze/core.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct graze_boundary graze_boundary;

/** Options of a sampling (rule 6). Pointers are borrowed. */
typedef struct graze_boundary_options {
    size_t size;     /**< sizeof(graze_boundary_options) */
    unsigned coarse; /**< every cell is cut at least to this level, which has 2^coarse cells along
                        each axis */
    unsigned depth;  /**< no cell is cut further than this level, 0 to 19 */
    unsigned long budget;      /**< points that may be classified, contact points included */
    unsigned long contacts;    /**< contact points to make; cells with one that is `on` are cut */
    unsigned long long seed;   /**< of the contact points */
    graze_rationals low, high; /**< corners of a box, d canonical rationals each; NULL: a little
                                    more than graze_scene_box */
    int middles;               /**< 1: each vertex stays in the middle of its edge between two
                                    points of the sample */
    int sharp;                 /**< 1: cells get a vertex at an edge or corner of the sweep inside
                                    them, where one is found; not with `middles` */
    int threads;               /**< number of threads that place vertices, up to 1024; 0 and 1: the
                                    caller's own alone. Any number gives the same boundary */
} graze_boundary_options;

/** Counts of a sampling. */
typedef struct graze_boundary_summary {
    size_t points, cells, vertices, faces;
    unsigned long in, on, out; /**< points by pmc */
    unsigned long contacts;    /**< contact points made */
    unsigned long contacts_on; /**< contact points that are `on` and in the box */
    unsigned long missed;      /**< cells at the surface's level that hold a contact point that is
                                    `on`, but no part of the surface */
    unsigned level;            /**< level of the cells that the surface intersects */
    int complete;              /**< 0: the budget ended before the depth was reached */
    int closed;                /**< 0: the surface ends at the border of the box */
    unsigned long bisected;    /**< points classified to place the vertices, besides the budget */
    size_t exact;              /**< vertices that are `on` */
    size_t features;           /**< number of vertices at edges and corners of the sweep; they are
                                    the last vertices */
} graze_boundary_summary;

/** A cell that was not cut: a box whose corners are points of the sample. */
typedef struct graze_boundary_cell {
    unsigned level;
    graze_pmc pmc;     /**< of all corners; GRAZE_PMC_NONE if they differ */
    int contact;       /**< 1 if it holds a contact point that is `on` */
    size_t corners[8]; /**< 2^d points; bit k of the index is the side along axis k */
} graze_boundary_cell;

/**
 * Sample the sweep (unsweep) of a scene ([EI] section 5, [IS] section 4.2). A cell is cut while its
 * corners and centre differ in pmc, or while it holds a contact point that is `on`; every point is
 * classified exactly. The surface separates the points that are `out` from the others at one level:
 * each of its vertices is on the boundary, or between two exactly classified points, one of them
 * `out` and the other not, that are at most 2^-20 of a cell apart. It is a manifold without
 * degenerate faces. With `sharp` a cell has one more vertex where the tangent planes of its
 * vertices meet inside it, if that place too is on the boundary or between such points; the tangent
 * planes are guesses, most of them exact, and only the place of that vertex depends on them. Parts,
 * holes and gaps without a point of the sample, and details smaller than a cell, can be missed.
 * @param scene borrowed; it must outlive the boundary
 * @return GRAZE_EUSE a NULL, a depth out of range, an empty box, a budget too small for the
 * coarse level, or `middles` with `sharp`; GRAZE_ECANCELED, GRAZE_ELIMIT, GRAZE_EINTERNAL
 */
GRAZE_API GRAZE_CHECKED graze_status graze_boundary_create(graze_boundary **out,
                                                           graze_context *context,
                                                           const graze_scene *scene,
                                                           const graze_boundary_options *options);
/** Free a boundary; the scene stays. NULL is allowed. */
GRAZE_API void graze_boundary_destroy(graze_boundary *boundary);
/** Counts of a boundary; zeros for NULL. */
GRAZE_API graze_boundary_summary graze_boundary_summarize(const graze_boundary *boundary);
/** Point `index` and its pmc; GRAZE_PMC_NONE past the end, `point` unchanged.
 * @param[out] point d initialised rationals
 */
GRAZE_API graze_pmc graze_boundary_point(mpq_t *point, const graze_boundary *boundary,
                                         size_t index);
/** Cell `index` of those that were not cut; zero past the end. */
GRAZE_API graze_boundary_cell graze_boundary_cell_at(const graze_boundary *boundary, size_t index);
/** Vertex `index` of the surface; unchanged past the end.
 * @param[out] point d initialised rationals
 */
GRAZE_API void graze_boundary_vertex(mpq_t *point, const graze_boundary *boundary, size_t index);
/** The two classified points between which vertex `index` lies: `outside` is `out`, `inside` is
 * `in` or `on`; unchanged past the end. They are ends of an edge between points of the sample where
 * `middles` was asked for.
 * @param[out] outside, inside d initialised rationals each
 */
GRAZE_API void graze_boundary_vertex_between(mpq_t *outside, mpq_t *inside,
                                             const graze_boundary *boundary, size_t index);
/** Face `index`: d vertices, with `out` on the side of the normal (E^2: on the right). Borrowed;
 * NULL past the end. */
GRAZE_API const size_t *graze_boundary_face(const graze_boundary *boundary, size_t index);

#ifdef __cplusplus
}
#endif
#endif
