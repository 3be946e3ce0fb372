/* graze/judge.h - how far a mesh is from the boundary of a sweep, with proof.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * W is the closed sweep, the union of all M(t) S. The input is a mesh of triangles that should be
 * its boundary; nothing is assumed of it (proofs/judging.md).
 */
#ifndef GRAZE_JUDGE_H
#define GRAZE_JUDGE_H

#include <graze/compare.h>
#include <graze/distance.h>

#ifdef __cplusplus
extern "C" {
#endif

/** A mesh of facets in E^3; it may be open, cross itself, have no orientation, or be empty. */
typedef struct graze_mesh graze_mesh;
typedef struct graze_judgement graze_judgement;

/** How a mesh tells its inside. */
typedef enum graze_mesh_rule {
    GRAZE_MESH_NONE = 0,   /**< it does not: some edge has an odd number of triangles */
    GRAZE_MESH_PARITY = 1, /**< inside by parity: all edges have an even number of triangles, but
                              orientations do not cancel */
    GRAZE_MESH_WINDING = 2 /**< inside is where the winding number is not 0; the rule holds if
                              every edge is run through as often one way as the other */
} graze_mesh_rule;

/** Facts of a mesh. Vertices at one position count as one. */
typedef struct graze_mesh_facts {
    size_t vertices, facets; /**< as given */
    size_t triangles;        /**< into which facets are cut, without those of area 0 */
    size_t flat;             /**< triangles of area 0, left out */
    size_t components;       /**< joined by edges */
    size_t odd_edges;        /**< with an odd number of triangles: 0 if the mesh is closed */
    size_t unbalanced_edges; /**< run through more often one way: 0 if closed and oriented */
    graze_mesh_rule rule;
} graze_mesh_facts;

/**
 * Read a mesh from a file of any format of solids in E^3. A mesh that is not closed or not oriented
 * is no error.
 * @param flags 0 or GRAZE_SOLID_TRIANGULATE: facets that are not planar are cut into fans
 * @return GRAZE_ESYSTEM the file cannot be read; GRAZE_EINPUT it does not follow its format;
 * GRAZE_EILLEGAL a facet is not planar or not simple; GRAZE_ELIMIT; GRAZE_ECANCELED
 */
GRAZE_API GRAZE_CHECKED graze_status graze_mesh_read(graze_mesh **out, graze_context *context,
                                                     const char *path, unsigned flags);
/**
 * Make a mesh of triangles from arrays, which are copied.
 * @param vertices 3 vertex_count finite doubles, which mean exactly what they are
 * @param triangles 3 triangle_count numbers of vertices, from 0
 * @return GRAZE_EINPUT a number that is not finite, or of no vertex; GRAZE_EUSE; GRAZE_ELIMIT
 */
GRAZE_API GRAZE_CHECKED graze_status graze_mesh_create(graze_mesh **out, graze_context *context,
                                                       const double *vertices, size_t vertex_count,
                                                       const size_t *triangles,
                                                       size_t triangle_count);
/** Free a mesh, after all judgements of it. NULL is allowed. */
GRAZE_API void graze_mesh_destroy(graze_mesh *mesh);
/** Facts of a mesh; zeros for NULL. */
GRAZE_API graze_mesh_facts graze_mesh_get_facts(const graze_mesh *mesh);
/** The volume of a mesh, the integral of its winding number. @return 0, and sets nothing, where the
 * rule is not GRAZE_MESH_WINDING, and for NULL */
GRAZE_API int graze_mesh_volume(mpq_t out, const graze_mesh *mesh);
/**
 * Least and greatest of 0 and the exact winding numbers on both sides of up to 128 triangles;
 * elsewhere there may be others. A mesh that bounds a solid has 0 and 1; one that faces inward has
 * -1, one given twice 2.
 * @return 0, and sets nothing, where the rule is not GRAZE_MESH_WINDING, and for NULL
 */
GRAZE_API int graze_mesh_windings(int *least, int *most, const graze_mesh *mesh);
/** Coordinates of vertex `index`; unchanged past the end and for NULL.
 * @param[out] point 3 initialised rationals */
GRAZE_API void graze_mesh_vertex(mpq_t *point, const graze_mesh *mesh, size_t index);

/** The vertices of triangle `index`, by the input's numbers; unchanged past the end and for NULL.
 * @param[out] vertex 3 of them */
GRAZE_API void graze_mesh_triangle(size_t *vertex, const graze_mesh *mesh, size_t index);

/** Options of a judgement (rule 6). */
typedef struct graze_judge_options {
    size_t size;          /**< sizeof(graze_judge_options) */
    double within;        /**< greatest width of the distances' enclosures; positive, finite */
    unsigned long budget; /**< cubes and points that may be examined; a few more can be; 0: 10^7 */
    int threads; /**< up to 1024, for the volume: they change nothing but the time; 0 is 1 */
} graze_judge_options;

/** Distance that is judged. */
typedef enum graze_judged {
    GRAZE_JUDGED_OUTSIDE = 0, /**< greatest distance of a point of the mesh from W */
    GRAZE_JUDGED_INSIDE = 1,  /**< greatest distance of a point of the mesh from W's complement */
    GRAZE_JUDGED_SWEEP = 2,   /**< greatest distance of a boundary point of W from the mesh */
    GRAZE_JUDGED_COUNT = 3
} graze_judged;

/** Bounds, low and high, of the greatest distance that a graze_judged names. The distance from an
 * empty mesh is infinite. */
typedef struct graze_judged_distance {
    double low, high;
    double at[3];   /**< a point of the mesh, within rounding, at least `low` away from W or from
                       its complement; for GRAZE_JUDGED_SWEEP a point near the boundary of W: the
                       boundary point nearest to it is at least `low` away from the mesh; zeros
                       where low is 0 */
    double time;    /**< double nearest to a time at which the solid is nearest to `at`, or `at` is
                       deepest in it, to a 16th of the width; 0 where low is 0 */
    double open[3]; /**< a point at which the distance is perhaps `high` */
    int reached;    /**< 1: high - low is at most what was asked for */
    int stuck; /**< 1: the search cannot refine near `open`: a seam of the sweep is perhaps there,
                  where its copies touch and cover a neighbourhood together, or coordinates are
                  beyond double precision */
} graze_judged_distance;

/**
 * Judge a mesh against the sweep of a polyhedron in E^3. Scene and mesh are borrowed and must
 * outlive the judgement. Bounds are proved (proofs/judging.md C117 to C119), so bounds for another
 * width or budget never contradict them.
 * @return GRAZE_EUSE; GRAZE_EINPUT a curved solid; GRAZE_EILLEGAL a scene in E^2, or an unsweep;
 * GRAZE_ELIMIT numbers beyond those of graze_distances; GRAZE_ECANCELED; GRAZE_ESYSTEM
 */
GRAZE_API GRAZE_CHECKED graze_status graze_judge(graze_judgement **out, graze_context *context,
                                                 const graze_scene *scene, const graze_mesh *mesh,
                                                 const graze_judge_options *options);
/** Free a judgement. NULL is allowed. */
GRAZE_API void graze_judgement_destroy(graze_judgement *judgement);
/** A distance; zeros for NULL. */
GRAZE_API graze_judged_distance graze_judgement_distance(const graze_judgement *judgement,
                                                         graze_judged which);
/** Exact lower and upper bounds of the volume of W. Unchanged for NULL.
 * @param[out] low, high initialised */
GRAZE_API void graze_judgement_volume(mpq_t low, mpq_t high, const graze_judgement *judgement);
/**
 * Volumes of the symmetric difference of W and the inside of the mesh, by its rule: `missing`, in W
 * and not inside the mesh, and `excess`, inside the mesh and not in W, each between two bounds.
 * Meshes of equal volume and other shape differ in them.
 * @param[out] missing_low, missing_high, excess_low, excess_high initialised
 * @return 0, and sets nothing, where the mesh has no inside or is 2^60 times as far away as the
 * sweep is large, and for NULL
 */
GRAZE_API int graze_judgement_difference(mpq_t missing_low, mpq_t missing_high, mpq_t excess_low,
                                         mpq_t excess_high, const graze_judgement *judgement);
/** Cubes and points that were asked about; 0 for NULL. */
GRAZE_API unsigned long graze_judgement_cost(const graze_judgement *judgement);

/** Form of a report. */
typedef enum graze_judgement_format {
    GRAZE_JUDGEMENT_TEXT = 0,
    GRAZE_JUDGEMENT_MARKDOWN = 1,
    GRAZE_JUDGEMENT_JSON = 2
} graze_judgement_format;

/** Report of a judgement, text for graze_free.
 * @param points of graze_compare_mesh, or NULL
 * @return GRAZE_EUSE, GRAZE_ESYSTEM */
GRAZE_API GRAZE_CHECKED graze_status graze_judgement_report(char **out, graze_context *context,
                                                            const graze_judgement *judgement,
                                                            const graze_comparison *points,
                                                            graze_judgement_format format);

/**
 * Enclose the signed distances of all vertices of a mesh (graze_distances), in threads.
 * @param[out] out  an enclosure for each vertex, in its order
 * @param tolerance greatest width wanted, positive and finite
 * @param threads   up to 1024; 0 is 1: the caller's own
 * @return as graze_distances; GRAZE_EILLEGAL a scene in E^2
 */
GRAZE_API GRAZE_CHECKED graze_status graze_mesh_distances(graze_enclosure *out,
                                                          graze_context *context,
                                                          const graze_scene *scene,
                                                          const graze_mesh *mesh, double tolerance,
                                                          int threads);

/**
 * Classify points by a mesh, in threads: in where its winding number is not 0 (by parity, where
 * that is its rule, odd), `on` where a triangle holds the point, else out.
 * @param[out] out an answer for each point
 * @param points   3n canonical rationals; may be NULL if n is 0
 * @param threads  up to 1024; 0 is 1: the caller's own
 * @return GRAZE_EUSE; GRAZE_EINPUT the mesh's rule is GRAZE_MESH_NONE; GRAZE_ELIMIT,
 * GRAZE_ECANCELED, GRAZE_ESYSTEM
 */
GRAZE_API GRAZE_CHECKED graze_status graze_mesh_answers(graze_pmc *out, graze_context *context,
                                                        const graze_mesh *mesh,
                                                        graze_rationals points, size_t n,
                                                        int threads);

/**
 * Write a page of HTML (graze/draw.h) with the scene, the mesh in the colours of its vertices'
 * distances, the places of the greatest distances as points named `outside`, `inside` and `sweep`,
 * and the place where a search is stuck, named such as `outside seam?`.
 * @param file  a name in .html; `-.html` is standard output
 * @param found enclosures of all vertices (graze_mesh_distances)
 * @param title UTF-8, at most 512 bytes, or NULL
 * @return GRAZE_EUSE; GRAZE_ELIMIT a coordinate is beyond pictures; GRAZE_ECANCELED; GRAZE_ESYSTEM
 */
GRAZE_API GRAZE_CHECKED graze_status graze_judgement_draw(
    graze_context *context, const graze_scene *scene, const graze_judgement *judgement,
    const char *file, const graze_enclosure *found, const char *title);

/** Points at which a mesh is judged as a classifier (rule 6). Pointers are borrowed. */
typedef struct graze_mesh_points {
    size_t size;             /**< sizeof(graze_mesh_points) */
    size_t count;            /**< how many points; up to 10^9 */
    unsigned long long seed; /**< of generated points, which are of all strata (graze/generate.h) */
    graze_rationals points;  /**< 3 count canonical rationals; NULL: points are generated */
    graze_on_as on_as;       /**< how the mesh's `on`, the answer on its triangles, is judged */
    size_t show;             /**< disagreements to keep (graze/compare.h) */
    int threads;             /**< up to 1024; 0 is 1: the caller's own */
    const char *solid, *motion; /**< file names for commands in the report, or NULL */
} graze_mesh_points;

/**
 * Compare what a mesh says of points with the exact answers: in where its winding number is not 0
 * (by parity, where that is its rule, odd), `on` where a triangle holds the point, else out. The
 * comparison is freed by graze_comparison_destroy.
 * @param scene in E^3; a sweep or an unsweep
 * @return GRAZE_EUSE; GRAZE_EINPUT the mesh's rule is GRAZE_MESH_NONE; GRAZE_EILLEGAL a scene in
 * E^2; GRAZE_ELIMIT, GRAZE_ECANCELED, GRAZE_ESYSTEM, GRAZE_EINTERNAL
 */
GRAZE_API GRAZE_CHECKED graze_status graze_compare_mesh(graze_comparison **out,
                                                        graze_context *context,
                                                        const graze_scene *scene,
                                                        const graze_mesh *mesh,
                                                        const graze_mesh_points *points);

#ifdef __cplusplus
}
#endif
#endif
