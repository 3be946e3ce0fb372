/* graze/draw.h - pictures of a scene.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_DRAW_H
#define GRAZE_DRAW_H

#include <graze/core.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Meaning of the colours of cells. */
typedef enum graze_draw_by {
    GRAZE_DRAW_BY_CLASS = 0,   /**< the class of the centre; for an unsweep pmc */
    GRAZE_DRAW_BY_DISTANCE = 1 /**< bands of the centre's signed distance, with level lines */
} graze_draw_by;

/** Options of a picture (rule 6). All pointers are borrowed. */
typedef struct graze_draw_options {
    size_t size;               /**< sizeof(graze_draw_options) */
    const char *title;         /**< a line above the picture, UTF-8, at most 512 bytes, or NULL */
    unsigned long grid;        /**< cells along the longer side; 0: 240, or 360 for a wide box */
    unsigned long times;       /**< number of positions of S, 2 to 64, evenly spaced; 0: 5 */
    graze_rationals low, high; /**< corners of the box, d rationals each; NULL: around the scene */
    int plane_axis;            /**< E^3: number, 0 to 2, of the coordinate that is constant in the
                                    plane of the cells */
    graze_rationals plane;    /**< value of this coordinate; NULL: the plane is that of the z in the
                                   middle of the box */
    double view[3];           /**< E^3: direction to the viewer; all 0: (2, -3, 2) */
    graze_rationals points;   /**< point_count points, d canonical rationals each */
    size_t point_count;       /**< number of points whose trajectories are drawn */
    const char *const *names; /**< a name for each point, UTF-8 */
    const char *const *strata;  /**< .html: for each point NULL or a group to filter by; the array
                                   may be NULL */
    const char *const *answers; /**< .html: for each point a candidate's answer where it is wrong,
                                   else NULL; the array may be NULL */
    int surface;                /**< .html: level of the sweep's surface (graze_boundary_options,
                                     depth), 1 to 19; 0: 5, in E^2 8; -1: none */
    graze_draw_by by;           /**< pictures: meaning of colours; by distance, grid 0 gives 120
                                     cells, or 180 for a wide box */
    graze_rationals normal;     /**< E^3: three rationals, not all 0: the plane of the cells is
                                     normal . x = *plane, or with plane NULL through the middle of
                                     the box, and plane_axis has no effect; NULL: plane_axis */
    const char *const *proof;   /**< .html: names of four files: the scene's solid and motion, the
                                   certificate of the points, in their order, and the page of
                                   graze-check or NULL. The page has their content, and proves its
                                   points by it; NULL: it does not */
} graze_draw_options;

/** The colour 0xRRGGBB of a class in every picture; 0 for GRAZE_CLASS_NONE. Never fails. */
GRAZE_API unsigned graze_class_colour(graze_class class_);
/**
 * Draw a scene. Square cells have the colour of the class of their centres, which are rationals and
 * classified exactly; outlines of S at some times of the motion lie over them. In E^3 the centres
 * are in a plane; contours between regions of classes are found by exact bisection to 1/32 of a
 * pixel, and a view of the positions of S is beside the plane. In an oblique plane the cells are
 * square to within 2^-49, and their centres are rational points of the plane. Points are drawn
 * with their inverted trajectories through the standing S; contacts are marked by kind and cell.
 * For an unsweep, colours show pmc and positions are those of the inverse motion. By distance, the
 * sign at each centre is exact, and the contour of E^3 is that between the set and `out`; distances
 * are within 1/64 of a cell's side, and level lines are interpolated between centres.
 *
 * A page of HTML shows the same scene in a browser, without a network: S at a time that a slider
 * chooses, the surface of the sweep as graze_boundary_create samples it, the points by class, the
 * trajectory of the one that is clicked on, and the sentences of `graze explain` for that point.
 * The page opens with the first point that has an entry in `answers`. `grid`, `plane`, `normal` and
 * `view` have no effect. With `proof` the page given to that of graze-check, or with the latter in
 * it a button of the page itself, proves its points.
 * @param file    the picture to write: .svg, .html, or .png and .pdf, which need libgraze-png;
 * `-.svg`, and so on, is standard output
 * @param options may be NULL for the defaults
 * @return GRAZE_EUSE an option out of range, a normal's plane outside the box, or another
 * extension; GRAZE_EINPUT a file of `proof` that is not of this scene, or no page of graze-check;
 * GRAZE_ELIMIT more cells than the limit `grid`, by distance also as in graze_distances;
 * GRAZE_ESYSTEM the file cannot be written, or no libgraze-png; GRAZE_ECANCELED; GRAZE_EINTERNAL.
 * On failure no file is created or changed, except by an error in writing it
 */
GRAZE_API GRAZE_CHECKED graze_status graze_draw(graze_context *context, const graze_scene *scene,
                                                const char *file,
                                                const graze_draw_options *options);

/**
 * Draw what the contacts of an `on` point of a sweep of E^2 cover of the directions about it to
 * first order (proofs/topology.md C46): a ring of sectors for each contact at rest and for each of
 * its sides, one for what all leave open, and the direction of the witness. Sectors of a solid that
 * turns about the point end at a border of another contact or at one of 128 more directions.
 * @param file  the picture to write: .svg, or .png and .pdf, which need libgraze-png; `-.svg`, and
 * so on, are standard output
 * @param point d canonical rationals
 * @param trace trace of the point
 * @return GRAZE_EUSE a NULL, a scene of E^3, a point that is not `on` a sweep, or another
 * extension; else what graze_trace_topo and graze_draw return. On failure no file is created or
 * changed, except by an error in writing it
 */
GRAZE_API GRAZE_CHECKED graze_status graze_draw_cones(graze_context *context,
                                                      const graze_scene *scene, const char *file,
                                                      graze_rationals point,
                                                      const graze_trace *trace);

#ifdef __cplusplus
}
#endif
#endif
