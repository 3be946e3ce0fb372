/* The public functions of outlines. SPDX-License-Identifier: GPL-3.0-or-later */
#include "api/api.h"

#include <math.h>
#include "graze/outline.h"
#include "output/report/report.h"
#include "questions/outline/outline.h"

graze_status graze_outline_create(graze_outline **out, graze_context *context,
                                  const graze_scene *scene, const graze_outline_options *options) {
    const double standard = 1e-12, least = 1e-300, greatest = 0.1;
    PUBLIC_OUT(out, context, scene);
    graze_outline_options checked;
    TRY(api_options(&checked, sizeof checked, context, __func__, options));
    double width = checked.width != 0 ? checked.width : standard;
    REFUSED(!(width >= least && width <= greatest), "options.width must be 1e-300 to 0.1");
    TRY(api_takes(context, __func__, scene->solid));
    CREATE(out, made, graze_outline_destroy, outline_make(made, context, scene, width));
}

DESTROYER(graze_outline, outline_clear(of))

graze_outline_facts graze_outline_get(const graze_outline *outline) {
    graze_outline_facts out = {0};
    if (!outline)
        return out;
    out.vertices = outline->vertex_count;
    out.arcs = outline->arc_count;
    out.rings = outline->ring_count;
    out.components = outline->components;
    out.interior_components = outline->interior_components;
    out.holes = outline->holes;
    out.euler = (int)outline->euler;
    out.lower_arcs = outline_lower_count(outline);
    out.lower_points = outline->spot_count;
    out.undecided = outline->undecided;
    outline_bounds(&out.area_low, &out.area_high, outline, &outline->area);
    outline_bounds(&out.length_low, &out.length_high, outline, &outline->length);
    out.area_is_rational = outline->area.is_exact;
    return out;
}

int graze_outline_area(mpq_t out, const graze_outline *outline) {
    if (!outline || !outline->area.is_exact)
        return 0;
    fmpq_get_mpq(out, outline->area.exact);
    return 1;
}

/* Define a public function that gives an outline as text. */
#define OUTLINE_AS(form)                                                                           \
    graze_status graze_outline_##form(char **out, graze_context *context,                          \
                                      const graze_outline *outline) {                              \
        PUBLIC_OUT(out, context, outline);                                                         \
        HELD(text, t);                                                                             \
        TRY(outline_##form(&t, context, outline));                                                 \
        return text_finish(out, context, &t);                                                      \
    }

OUTLINE_AS(text)
OUTLINE_AS(json)
OUTLINE_AS(csv)
OUTLINE_AS(samples)

graze_status graze_outline_polygon(char **out, size_t *rings, graze_context *context,
                                   const graze_outline *outline, double within,
                                   graze_polygon_side side, graze_polygon_format format) {
    PUBLIC_OUT(out, context, outline);
    REFUSED(format < GRAZE_POLYGON_WKT || format > GRAZE_POLYGON_VTK, "format is none of the enum");
    REFUSED(side < GRAZE_POLYGON_NEAR || side > GRAZE_POLYGON_OUTSIDE, "side is none of the enum");
    REFUSED(!(within > 0 && isfinite(within)), "within must be above 0 and finite");
    HELD(text, t);
    ZEROED(outline_polygon, polygon);
    TRY(outline_polygon_beside(&polygon, outline, context, within, side));
    outline_polygon_text(&t, &polygon, format);
    if (rings)
        *rings = polygon.ring_count;
    return text_finish(out, context, &t);
}
