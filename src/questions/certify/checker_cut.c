/* Facets cut as graze-check cuts them: each into the fan of its first corner.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/context/scope.h"
#include "input/solid/solid.h"
#include "input/soup/soup.h"
#include "questions/certify/prove.h"

static graze_status add_fan(soup *out, graze_context *context, const soup *in, size_t facet) {
    size_t cycle = in->facet_start[facet], first = in->cycle_start[cycle];
    size_t n = in->cycle_start[cycle + 1] - first;
    for (size_t k = 1; k + 1 < n; k++) {
        size_t corner[3] = {in->index[first], in->index[first + k], in->index[first + k + 1]};
        TRY(soup_add_facet(out, context));
        TRY(soup_add_cycle(out, context, corner, 3));
    }
    return GRAZE_OK;
}

/* The fans of a legal solid's facets, planar ones, make up the same boundary or are refused: where
 * a piece turns the other way it overlaps others, or has no area. */
static graze_status make_cut(graze_solid **out, graze_context *context, soup *cut) {
    graze_status status = solid_create(out, context, cut, 0);
    soup_init(cut, 3); /* the solid has taken it over */
    if (status == GRAZE_EILLEGAL)
        return context_fail(context, status,
                            "a facet is not the fan of its first corner, so that graze-check "
                            "cannot read it; expected what graze convert writes");
    return status;
}

graze_status certify_cut(graze_solid **out, graze_context *context, const graze_solid *solid) {
    const soup *in = &solid->input;
    *out = NULL;
    if (in->dimension == 2 || in->index_count == 3 * in->facet_count)
        return GRAZE_OK;
    HELD(soup, cut, 3);
    for (size_t v = 0; v < in->vertex_count; v++)
        TRY(soup_add_vertex(&cut, context, in->coordinates + 3 * v));
    for (size_t f = 0; f < in->facet_count; f++)
        TRY(add_fan(&cut, context, in, f));
    return make_cut(out, context, &cut);
}
