/* graze/outline.h - the exact boundary of a planar sweep or unsweep: arcs, rings, area.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The outline of a sweep is the boundary of the closed sweep; that of an unsweep is the boundary of
 * the closure of the unsweep's interior. It consists of arcs of finitely many algebraic curves:
 * paths of vertices, edges at a time, envelopes of edges. formats.md (Outlines) and
 * proofs/outline.md define the words.
 */
#ifndef GRAZE_OUTLINE_H
#define GRAZE_OUTLINE_H

#include <graze/core.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct graze_outline graze_outline;

/** Options of an outline (rule 6). */
typedef struct graze_outline_options {
    size_t size;  /**< sizeof(graze_outline_options) */
    double width; /**< greatest width of an enclosed area or length, relative to its size: 1e-300 to
                     0.1; 0: the default, 1e-12 */
} graze_outline_options;

/** Numbers of an outline. */
typedef struct graze_outline_facts {
    size_t vertices, arcs, rings;
    size_t components;               /**< of the closed set */
    size_t interior_components;      /**< of its interior */
    size_t holes;                    /**< bounded components of its complement */
    size_t lower_arcs, lower_points; /**< seams of a sweep, dangling parts of an unsweep */
    size_t undecided;                /**< arcs and points that may be lower parts */
    double area_low, area_high;      /**< bounds of the area */
    double length_low, length_high;  /**< bounds of the boundary's length */
    int euler;                       /**< components - holes */
    int area_is_rational;            /**< 1: graze_outline_area gives the area */
} graze_outline_facts;

/**
 * Find the outline of a scene of a polygon. The scene is borrowed and must outlive the outline. One
 * thread uses an outline at a time.
 * @param options NULL: the defaults
 * @return GRAZE_EUSE a NULL or a bad option; GRAZE_EINPUT a curved solid; GRAZE_EILLEGAL a
 * polyhedron; GRAZE_ELIMIT limits `curve`, `arcs`, `bits`; GRAZE_ECANCELED; GRAZE_ESYSTEM;
 * GRAZE_EINTERNAL
 */
GRAZE_API GRAZE_CHECKED graze_status graze_outline_create(graze_outline **out,
                                                          graze_context *context,
                                                          const graze_scene *scene,
                                                          const graze_outline_options *options);
/** Free an outline. NULL is allowed. */
GRAZE_API void graze_outline_destroy(graze_outline *outline);
/** Numbers of an outline; zeros for NULL. */
GRAZE_API graze_outline_facts graze_outline_get(const graze_outline *outline);
/** The area, if it is known as a rational: 1, and `out`, initialised, is set; else 0. */
GRAZE_API int graze_outline_area(mpq_t out, const graze_outline *outline);
/** Lines of text, as graze outline prints them. @param[out] out text for graze_free
 * @return GRAZE_EUSE, GRAZE_ELIMIT, GRAZE_ECANCELED, GRAZE_ESYSTEM */
GRAZE_API GRAZE_CHECKED graze_status graze_outline_text(char **out, graze_context *context,
                                                        const graze_outline *outline);
/** One object of JSON (formats.md, Outlines). @param[out] out text for graze_free
 * @return GRAZE_EUSE, GRAZE_ELIMIT, GRAZE_ECANCELED, GRAZE_ESYSTEM */
GRAZE_API GRAZE_CHECKED graze_status graze_outline_json(char **out, graze_context *context,
                                                        const graze_outline *outline);
/** A table of arcs, one row each, CSV. @param[out] out text for graze_free
 * @return GRAZE_EUSE, GRAZE_ELIMIT, GRAZE_ECANCELED, GRAZE_ESYSTEM */
GRAZE_API GRAZE_CHECKED graze_status graze_outline_csv(char **out, graze_context *context,
                                                       const graze_outline *outline);
/** Rational points that show each piece of the outline, as CSV: x, y, arc, lower, side. A piece of
 * an arc has two rows, `in` and `out`, with the arc's number: the ends of a segment that crosses it
 * and no other candidate. A lower arc has three, of one such segment, the middle one `on`, with its
 * number in the JSON's list. @param[out] out text for graze_free
 * @return GRAZE_EUSE, GRAZE_ECANCELED, GRAZE_ESYSTEM */
GRAZE_API GRAZE_CHECKED graze_status graze_outline_samples(char **out, graze_context *context,
                                                           const graze_outline *outline);

/** Forms of a polygon as text: well-known text, GeoJSON, SVG, legacy VTK. */
typedef enum graze_polygon_format {
    GRAZE_POLYGON_WKT = 0,
    GRAZE_POLYGON_GEOJSON = 1,
    GRAZE_POLYGON_SVG = 2,
    GRAZE_POLYGON_VTK = 3
} graze_polygon_format;

/** Sides of an outline on which a polygon is. */
typedef enum graze_polygon_side {
    GRAZE_POLYGON_NEAR = 0,   /**< on both sides */
    GRAZE_POLYGON_INSIDE = 1, /**< the polygon is a subset of the set */
    GRAZE_POLYGON_OUTSIDE = 2 /**< the set is a subset of the polygon */
} graze_polygon_side;

/**
 * The outline as valid polygons of doubles. Near it: one for each component of the interior, with
 * its holes; each point of the outline is within a distance of their edges, and each point of an
 * edge within it of the outline; edges meet at points of the outline at which arcs do, alone.
 * Inside or outside: no edge meets the outline or another one's inner points, each point of an edge
 * is within the distance of the outline, and all points that are farther from it belong to the set
 * and the polygons alike; what is thinner may be missing (outside: filled), so there may be none.
 * @param[out] out    text for graze_free
 * @param[out] rings  the number of rings; NULL: not asked for
 * @param      within the distance, above 0
 * @return GRAZE_EUSE; GRAZE_ELIMIT limit `arcs`, or doubles are too far apart for such polygons;
 * GRAZE_ECANCELED, GRAZE_ESYSTEM
 */
GRAZE_API GRAZE_CHECKED graze_status graze_outline_polygon(char **out, size_t *rings,
                                                           graze_context *context,
                                                           const graze_outline *outline,
                                                           double within, graze_polygon_side side,
                                                           graze_polygon_format format);

#ifdef __cplusplus
}
#endif
#endif
