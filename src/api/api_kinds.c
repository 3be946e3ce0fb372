/* The table of the kinds of solids that public functions take.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "api/api.h"

/* All kinds, but of curved solids only those for which a box is proved. */
enum { BOXED = SOLID_STRAIGHT | SOLID_CURVED };

static const char straight[] = "a polygon or a polyhedron",
                  boxed[] = "balls, cylinders with two ends and other bounded primitives, or their "
                            "intersection with a box";

/* A function, an argument of one, or a column of rows, and the kinds it takes. */
static const struct {
    const char *name;
    unsigned kinds;
    const char *expected; /* these kinds in words */
} table[] = {
    {"graze_boundary_create", SOLID_STRAIGHT, straight},
    {"graze_certifier_create", SOLID_STRAIGHT, straight},
    {"graze_compare_mesh", SOLID_POLYHEDRON | SOLID_CURVED_SPACE, "a solid in space"},
    {"graze_distances", SOLID_STRAIGHT, straight},
    {"graze_distances_doubles", SOLID_STRAIGHT, straight},
    {"graze_draw", BOXED, boxed},
    {"graze_draw: by distance", SOLID_STRAIGHT, straight},
    {"graze_draw: surface", SOLID_STRAIGHT, straight},
    {"graze_draw_cones", SOLID_STRAIGHT, straight},
    {"graze_envelope_create", SOLID_STRAIGHT, straight},
    {"graze_generator_create", BOXED, boxed},
    {"graze_grid_create", BOXED, boxed},
    {"graze_judge", SOLID_POLYHEDRON, "a polyhedron"},
    {"graze_mesh_distances", SOLID_POLYHEDRON, "a polyhedron"},
    {"graze_outline_create", SOLID_POLYGON,
     "a polygon; graze_boundary_create and graze_draw take others"},
    {"graze_scene_box", BOXED, boxed},
    {"graze_scene_diagonal", SOLID_STRAIGHT, straight},
    {"graze_scene_width", SOLID_STRAIGHT, straight},
    {"graze_site_create", SOLID_STRAIGHT, straight},
    {"graze_site_create_at", SOLID_STRAIGHT, straight},
    {"graze_site_snap", SOLID_STRAIGHT, straight},
    {"graze_site_snap_at", SOLID_STRAIGHT, straight},
    {"graze_solid_box", BOXED, boxed},
    {"graze_solid_text", SOLID_STRAIGHT, straight},
    {"graze_trace_regular", SOLID_STRAIGHT, straight},
    {"graze_trace_topo", SOLID_STRAIGHT, straight},
    {"regular", SOLID_STRAIGHT, straight},
    {"sdf", SOLID_STRAIGHT, straight},
    {"topo", SOLID_STRAIGHT, straight},
};

graze_status api_takes(graze_context *context, const char *name, const graze_solid *solid) {
    static const char *const is[] = {"a polygon", "a polyhedron", "a curved solid in the plane",
                                     "a curved solid in space"};
    solid_kind kind = solid_kind_of(solid);
    size_t k = 0;
    while (k < sizeof table / sizeof *table && strcmp(table[k].name, name) != 0)
        k++;
    if (k == sizeof table / sizeof *table)
        return context_fail(context, GRAZE_EINTERNAL, "%s is in no row of the table of kinds",
                            name);
    unsigned kinds = table[k].kinds;
    if (!(kinds & kind)) {
        int turned = kind & SOLID_CURVED && !(kinds & SOLID_CURVED);
        return context_fail(context, turned ? GRAZE_EINPUT : GRAZE_EILLEGAL,
                            "%s: the solid is %s%s%s; expected %s", name, is[__builtin_ctz(kind)],
                            turned && *solid->note ? ": " : "", turned ? solid->note : "",
                            table[k].expected);
    }
    if (kinds != BOXED || solid_bounded(solid))
        return GRAZE_OK;
    return context_fail(context, GRAZE_EINPUT,
                        "%s: no box of the curved solid is proved; expected %s", name,
                        table[k].expected);
}
