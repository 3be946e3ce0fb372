/* graze/topo.h - where a point lies relative to the closed sweep or the regularised unsweep.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * `in` and `out` lie in the interior and in the exterior of the closed sweep, but a point that is
 * `on` may lie in its interior all the same, where swept parts close around it (semantics.md 5). By
 * duality a point that is `on` an unsweep may be far from its interior, on a part that dangles: the
 * regularised unsweep, the closure of the interior, does not have it (semantics.md 6).
 */
#ifndef GRAZE_TOPO_H
#define GRAZE_TOPO_H

#include <graze/core.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Position relative to a closed set. Zero is never an answer. */
typedef enum graze_topo {
    GRAZE_TOPO_NONE = 0,
    GRAZE_TOPO_INTERIOR = 1,
    GRAZE_TOPO_BOUNDARY = 2,
    GRAZE_TOPO_EXTERIOR = 3,
    GRAZE_TOPO_UNDECIDED = 4 /**< no level decides it, or a limit is met */
} graze_topo;
/** Level that decided the position. */
typedef enum graze_topo_level {
    GRAZE_LEVEL_NONE = 0, /**< none decides it */
    GRAZE_LEVEL_WORD = 1, /**< the word: `in`, `out`, or `on` for an unsweep (semantics.md 6) */
    GRAZE_LEVEL_FIRST_ORDER = 2,  /**< leading directions at the contacts (topology.md C46) */
    GRAZE_LEVEL_CURVES = 3,       /**< curves near the point, in a plane (topology.md C49, C50) */
    GRAZE_LEVEL_CLOSED_CONES = 4, /**< closed cones of the contacts, covered exactly (C46, C51) */
    GRAZE_LEVEL_EDGES = 5,        /**< level 4 with ways through pinches and along edges (C52) */
    GRAZE_LEVEL_SECTION = 6,      /**< across a direction on which no contact depends (C54, C128) */
    GRAZE_LEVEL_LEADING_TERMS = 7 /**< both sides of a plane, by leading terms (C55, gaps.md C88) */
} graze_topo_level;

/** Verdict on one point. */
typedef struct graze_topology graze_topology;

/** "interior", "boundary", "exterior" or "undecided", else "none". Static. */
GRAZE_API const char *graze_topo_name(graze_topo topo);
/* The answer whether a point with this position is in the regularised unsweep. */
/** "yes", "no" or "undecided", else "none". Static. */
GRAZE_API const char *graze_regular_name(graze_topo topo);
/** "word", "first_order", "closed_cones", "edges", "leading_terms", "section" or
 * "curves", else "none". Static. */
GRAZE_API const char *graze_topo_level_name(graze_topo_level level);

/**
 * Decide where a point lies relative to the closed sweep, or unsweep. In the plane every point is
 * decided unless a limit is met; in space some `on` points are undecided.
 * @param point d canonical rationals
 * @param trace trace of the point
 * @return GRAZE_EUSE a NULL, or a coordinate that is not canonical; GRAZE_ELIMIT; GRAZE_ECANCELED;
 * GRAZE_ESYSTEM; GRAZE_EINTERNAL
 */
GRAZE_API GRAZE_CHECKED graze_status graze_trace_topo(graze_topology **out, graze_context *context,
                                                      const graze_scene *scene,
                                                      graze_rationals point,
                                                      const graze_trace *trace);
/**
 * Decide where a point lies relative to the regularised unsweep: `in` is interior and `out`
 * exterior; `on` is boundary, with a witness that is `in`, or exterior, on a dangling part
 * (dangling.md C113). It is undecided in the cases in which graze_trace_topo is.
 * @return as graze_trace_topo; GRAZE_EUSE also for a sweep: no part of one dangles
 */
GRAZE_API GRAZE_CHECKED graze_status graze_trace_regular(graze_topology **out,
                                                         graze_context *context,
                                                         const graze_scene *scene,
                                                         graze_rationals point,
                                                         const graze_trace *trace);
/** Free a verdict. NULL is allowed. */
GRAZE_API void graze_topology_destroy(graze_topology *topology);
/** The position; GRAZE_TOPO_NONE for NULL. */
GRAZE_API graze_topo graze_topology_position(const graze_topology *topology);
/** Level that decided it; GRAZE_LEVEL_NONE for NULL. */
GRAZE_API graze_topo_level graze_topology_level(const graze_topology *topology);
/** Why a point is undecided, in one line; "" for another, and for NULL. Static. */
GRAZE_API const char *graze_topology_reason(const graze_topology *topology);
/**
 * A point that is `out`, for an `on` point of a sweep that is `boundary`; in a verdict of
 * graze_trace_regular a point that is `in`. The points of the functions below are of the same pmc.
 * @param[out] out d initialised rationals; unchanged if there is no such point
 * @return 1, or 0 if there is none
 */
GRAZE_API int graze_topology_witness(mpq_t *out, const graze_topology *topology);
/**
 * The ray on which the witness lies, where first order decides: the points P + s direction with 0 <
 * s <= epsilon all have the pmc of the witness, and the witness is that at epsilon (closure.md
 * C74).
 * @param[out] direction d initialised rationals, integers
 * @param[out] epsilon   initialised
 * @return 1, or 0 with both unchanged
 */
GRAZE_API int graze_topology_ray(mpq_t *direction, mpq_t epsilon, const graze_topology *topology);
/**
 * The path on which the witness lies, where leading terms decide, in space: the points P + s^m
 * direction + s^(m + 1) z normal with 0 < s <= epsilon all have the pmc of the witness, which is
 * that at epsilon (gaps.md C88).
 * @param[out] direction d initialised rationals, integers; `normal` is orthogonal to it
 * @param[out] normal    the same
 * @param[out] z         initialised
 * @param[out] order     m, 1 if the gap is left by second order
 * @param[out] epsilon   initialised
 * @return 1, or 0 with all unchanged
 */
GRAZE_API int graze_topology_path(mpq_t *direction, mpq_t *normal, mpq_t z, size_t *order,
                                  mpq_t epsilon, const graze_topology *topology);
/**
 * The square on which the witness lies, where a section or curves decide: it is P + x a + y b with
 * |x| and |y| at most rho, one of them rho, and every smaller square about P holds a point of the
 * same pmc too.
 * @param[out] along 2 d initialised rationals, integers: a, then b
 * @param[out] rho   initialised
 * @return 1, or 0 with both unchanged
 */
GRAZE_API int graze_topology_square(mpq_t *along, mpq_t rho, const graze_topology *topology);

#ifdef __cplusplus
}
#endif
#endif
