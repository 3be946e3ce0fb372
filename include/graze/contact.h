/* graze/contact.h - contact points of the moving boundary with the envelope of a sweep.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A site is a point y of the boundary of the solid, in its own frame, at a rational time t; it is
 * at P = M(t) y. Envelope methods keep the sites that can touch the boundary of the sweep, [AMS]
 * Adsul, Machchhar & Sohoni 2013 and 2014, and trim those that some other position of the solid
 * covers. formats.md (Contact points) and proofs/envelope.md define the words.
 */
#ifndef GRAZE_CONTACT_H
#define GRAZE_CONTACT_H

#include <graze/report.h>

#ifdef __cplusplus
extern "C" {
#endif

/** First-order role of a site. Zero is never an answer. */
typedef enum graze_role {
    GRAZE_ROLE_NONE = 0,
    GRAZE_ROLE_CONTACT = 1, /**< the solid, at times next to t, leaves some direction about P
                                   uncovered */
    GRAZE_ROLE_EGRESS = 2,  /**< no contact, all facets move outward */
    GRAZE_ROLE_INGRESS = 3, /**< no contact, all facets move inward */
    GRAZE_ROLE_HIDDEN = 4   /**< no contact, neither egress nor ingress */
} graze_role;
/** Where the trajectory of P is at times other than t: in the solid's interior, or in contact with
 * its boundary. Zero is never an answer. */
typedef enum graze_trim {
    GRAZE_TRIM_NONE = 0,
    GRAZE_TRIM_SLIDES = 1, /**< never in the interior; the contact at t is an interval */
    GRAZE_TRIM_SIMPLE = 2, /**< never in the interior; no other contact */
    GRAZE_TRIM_MEETS = 3,  /**< never in the interior; other contacts */
    GRAZE_TRIM_NEAR = 4,   /**< in the interior next to t */
    GRAZE_TRIM_FAR = 5     /**< in the interior, but not next to t */
} graze_trim;
/** Orientation of the map from the contact set to the envelope. Zero: there is none. */
typedef enum graze_orientation {
    GRAZE_ORIENTATION_NONE = 0,
    GRAZE_ORIENTATION_PRESERVING = 1,
    GRAZE_ORIENTATION_REVERSING = 2,
    GRAZE_ORIENTATION_DEGENERATE = 3
} graze_orientation;

/** Order of a contact whose pullback vanishes. */
#define GRAZE_ORDER_VANISHES (-1)

/** Facts about a site. */
typedef struct graze_site_facts {
    graze_cell cell; /**< lowest cell that contains y */
    graze_role role;
    int on_slice; /**< 1: y is in one facet's interior, g = 0 and t is no break. Only then do theta,
                     order and orientation mean something */
    int theta;    /**< sign of theta: -1, 0, 1 */
    int order;    /**< order of the contact with the facet's plane, or GRAZE_ORDER_VANISHES */
    graze_orientation orientation;
    graze_state left, right; /**< states next to t: I, B, O, or absent beyond an end */
    graze_trim trim;         /**< P is trimmed for GRAZE_TRIM_NEAR and GRAZE_TRIM_FAR */
} graze_site_facts;

/** A facet through y, on one side of t. */
typedef struct graze_site_germ {
    graze_cell facet; /**< face; in E^2 edge */
    int side;         /**< -1 before t, +1 after it */
    int order;        /**< of the pullback's zero at t, or GRAZE_ORDER_VANISHES */
    int sign;         /**< of the pullback next to t: +1 outside the facet's plane; 0 on it */
} graze_site_germ;

typedef struct graze_site graze_site;

/** "contact", "egress", "ingress" or "hidden", else "none". Static. */
GRAZE_API const char *graze_role_name(graze_role role);
/** "slides", "simple", "meets", "trimmed_near" or "trimmed_far", else "none". Static. */
GRAZE_API const char *graze_trim_name(graze_trim trim);
/** "preserving", "reversing" or "degenerate", else "none". Static. */
GRAZE_API const char *graze_orientation_name(graze_orientation orientation);

/**
 * Examine a site of a scene whose operation is sweep. The scene is borrowed and must outlive it.
 * One thread uses a site at a time.
 * @param time canonical
 * @param point y: d canonical rationals, in the solid's frame
 * @return GRAZE_EUSE a NULL, an unsweep, or a number that is not canonical; GRAZE_EINPUT the time
 * is beyond the motion, or y is not on the boundary; GRAZE_ELIMIT; GRAZE_ECANCELED; GRAZE_EINTERNAL
 */
GRAZE_API GRAZE_CHECKED graze_status graze_site_create(graze_site **out, graze_context *context,
                                                       const graze_scene *scene, const mpq_t time,
                                                       graze_rationals point);
/** As graze_site_create, for y = M(time)^-1 P, where P is `world`. */
GRAZE_API GRAZE_CHECKED graze_status graze_site_create_at(graze_site **out, graze_context *context,
                                                          const graze_scene *scene,
                                                          const mpq_t time, graze_rationals world);
/**
 * As graze_site_create, but the site is the point of the contact set of `cell` at that time that is
 * nearest to y, of equally near ones the lexicographically first; y need not be on the boundary.
 * Distances are those of the solid's frame. If the set is empty the site has y as given, the cell
 * and zeros for other facts, no near times, no trace and no facets.
 * @param cell in E^3 a face, edge or vertex, in E^2 an edge or vertex
 * @return also GRAZE_EINPUT: the solid has no such cell, or more than two facets meet along an edge
 */
GRAZE_API GRAZE_CHECKED graze_status graze_site_snap(graze_site **out, graze_context *context,
                                                     const graze_scene *scene, const mpq_t time,
                                                     graze_rationals point, graze_cell cell);
/** As graze_site_snap, for y = M(time)^-1 P, where P is `world`. */
GRAZE_API GRAZE_CHECKED graze_status graze_site_snap_at(graze_site **out, graze_context *context,
                                                        const graze_scene *scene, const mpq_t time,
                                                        graze_rationals world, graze_cell cell);
/**
 * Squared distance by which graze_site_snap moved y.
 * @param[out] out initialised; unchanged for 0
 * @return 1; 0 for NULL, for a site that was not snapped, and if the cell has no contact at the
 * site's time
 */
GRAZE_API int graze_site_shift(mpq_t out, const graze_site *site);
/** Free a site. NULL is allowed. */
GRAZE_API void graze_site_destroy(graze_site *site);
/** Facts about a site; zeros for NULL. */
GRAZE_API graze_site_facts graze_site_get(const graze_site *site);
/** y and P, d initialised rationals each; unchanged for NULL. */
GRAZE_API void graze_site_point(mpq_t *body, mpq_t *world, const graze_site *site);
/** Time nearest to t, t excepted, at which the trajectory of P is in the solid; t itself if there
 * are such times as near as one likes; of two the earlier. NULL: there is none. Borrowed. */
GRAZE_API const graze_time *graze_site_near(const graze_site *site);
/** As graze_site_near, with the closure of the times at which P is in the solid's interior. */
GRAZE_API const graze_time *graze_site_near_in(const graze_site *site);
/** Trace of P, borrowed; NULL for NULL and where a cell has no contact. */
GRAZE_API const graze_trace *graze_site_trace(const graze_site *site);
/** Number of pairs of a facet through y and a side of t; 0 for NULL. */
GRAZE_API size_t graze_site_germ_count(const graze_site *site);
/**
 * Pair `index` of a facet and a side of t, zeros past the end. With n the facet's outward normal of
 * coprime integers, `speed` is g = n A^-1 (A' y + b'), `drift` is g_t, the derivative of g by t at
 * fixed y, and `theta` is the second derivative by t of n c, c the trajectory of P.
 * @param[out] speed, drift, theta initialised; unchanged past the end
 */
GRAZE_API graze_site_germ graze_site_germ_at(mpq_t speed, mpq_t drift, mpq_t theta,
                                             const graze_site *site, size_t index);

/** Head of a table of contact points: as graze_report_header. For sites of graze_site_snap
 * `columns` begin with `shift`. */
GRAZE_API GRAZE_CHECKED graze_status graze_site_header(char **out, graze_context *context,
                                                       const graze_scene *scene, const char *notes,
                                                       const char *columns);
/** Row of a site with its newline: as graze_report_row. */
GRAZE_API GRAZE_CHECKED graze_status graze_site_row(char **out, graze_context *context,
                                                    const graze_site *site, graze_format format,
                                                    const char *rest);

#ifdef __cplusplus
}
#endif
#endif
