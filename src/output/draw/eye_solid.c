/* One maker for each dimension.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/draw/eye_solid.h"

#include <stdlib.h>
#include "output/draw/eye_outline.h"
#include "output/draw/eye_surface.h"

graze_status eye_solid_make(graze_solid *out, graze_context *context, const csg *solid) {
    *out = (graze_solid){.input = {.dimension = solid->dimension}};
    return (solid->dimension == 2 ? eye_outline_make : eye_surface_make)(out, context, solid);
}

void eye_solid_clear(graze_solid *made) {
    free(made->low);
    free(made->cut.item);
    made->low = NULL;
    made->cut.item = NULL;
}
