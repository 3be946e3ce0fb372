/* graze/curved.h - curved solids: Boolean expressions over polynomial inequalities.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * graze_solid_read reads `.csg.json` files (formats.md, Curved solids). Scenes of such solids serve
 * graze_classify, traces, the reports of points and, in E^3, graze_compare_mesh; where a box is
 * known (graze_solid_bounded) also boxes, grids, generators and pictures. Other functions fail with
 * GRAZE_EINPUT. A point with an undecided state has GRAZE_CLASS_UNDECIDED, and GRAZE_PMC_UNDECIDED
 * where the decided states do not give its membership.
 */
#ifndef GRAZE_CURVED_H
#define GRAZE_CURVED_H

#include <graze/core.h>

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Read a curved solid from `length` bytes of JSON as in a `.csg.json` file, which need not end in
 * NUL. A program that composes solids writes such text: an operation is an object around others.
 * @param[out] out destroy with graze_solid_destroy; NULL on failure
 * @return as graze_solid_read
 */
GRAZE_API GRAZE_CHECKED graze_status graze_solid_from_csg(graze_solid **out, graze_context *context,
                                                          const char *text, size_t length);

/** Number of primitives of a curved solid; 0 for a polyhedron and NULL. */
GRAZE_API size_t graze_solid_primitive_count(const graze_solid *solid);
/** Title of a primitive, counted from 0: its kind, its number and its name, such as
 * `ball 2 "tip"`; "" past the end. Borrowed. */
GRAZE_API const char *graze_solid_primitive(const graze_solid *solid, size_t index);
/** Number of surfaces: irreducible polynomials, equal ones counted once; 0 for a polyhedron and
 * NULL. */
GRAZE_API size_t graze_solid_surface_count(const graze_solid *solid);

/** Whether a box of the solid is known, which graze_solid_box, graze_scene_box and grids need: 1
 * for a polyhedron or polygon, and for a curved solid that its primitives bound; 0 for NULL. */
GRAZE_API int graze_solid_bounded(const graze_solid *solid);

/**
 * The first place where the rules leave a state of a trace undecided.
 * @param[out] out `from` and `to` are the time of that place, `cells` the primitives on which the
 *                 state depends there; other members zero. Borrowed from the trace. Unchanged if
 *                 the result is 0
 * @return 1; 0 if all states are decided, or for NULL
 */
GRAZE_API int graze_trace_undecided(graze_contact *out, const graze_trace *trace);
/** Why the state at the place of graze_trace_undecided is not decided, in one line; "" if all
 * states are decided, or for NULL. Static. */
GRAZE_API const char *graze_trace_reason(const graze_trace *trace);

#ifdef __cplusplus
}
#endif
#endif
