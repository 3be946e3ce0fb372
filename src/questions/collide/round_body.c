/* Balls and capsules as points and segments, with what a solid has for searches.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/context/scope.h"
#include "questions/collide/features.h"

/* Add the points of a ball or capsule, and a simplex whose first corners they are; the last one is
 * repeated. */
static graze_status add_base(graze_solid *out, graze_context *context, const csg_round *round) {
    int d = out->input.dimension;
    simplex *s = &out->cut.item[out->cut.count];
    uint32_t first = (uint32_t)out->input.vertex_count;
    for (int k = 0; k < round->ends; k++)
        TRY(soup_add_vertex(&out->input, context, round->end + k * d));
    *s = (simplex){.component = (uint32_t)out->cut.count++};
    for (int k = 0; k < d; k++)
        s->vertex[k] = first + (uint32_t)(k < round->ends ? k : round->ends - 1);
    return GRAZE_OK;
}

static graze_status fill_bases(graze_solid *out, graze_context *context, const csg *of) {
    TRY(MAKE_ARRAY(context, out->cut.item, of->round_count, "balls and capsules"));
    for (size_t k = 0; k < of->round_count; k++)
        TRY(add_base(out, context, &of->round[k]));
    out->cut.component_count = out->cut.count;
    TRY(skin_bounds(&out->low, &out->high, context, &out->input));
    skin bare = solid_skin(out);
    TRY(skin_tree(&out->boxes, context, &bare));
    TRY(corners_make(&out->corners, context, &out->input, &out->cut, out->low, out->high));
    if (slabs_make(&out->slabs, &out->boxes, &out->corners, out->input.dimension))
        return GRAZE_OK;
    return context_fail(context, GRAZE_ESYSTEM, "out of memory for balls and capsules");
}

graze_status collide_set_round(graze_pair *pair, graze_context *context, int side) {
    const graze_solid **given = side == SIDE_MOVING ? &pair->pair.moving : &pair->pair.fixed;
    const char *name = side == SIDE_MOVING ? "moving" : "fixed";
    const csg *of = (*given)->curved;
    if (!of)
        return GRAZE_OK;
    if (of->not_round)
        return context_fail(context, GRAZE_EINPUT,
                            "the %s solid is curved and no union of balls and capsules, with "
                            "rational radii; expected such a union, a polygon or a polyhedron",
                            name);
    if (side == SIDE_FIXED && pair->options.question == GRAZE_PAIR_INSIDE)
        return context_fail(context, GRAZE_EINPUT,
                            "the fixed solid has balls or capsules, and the question is whether "
                            "the moving one stays inside; expected a polygon or a polyhedron");
    TRY(MAKE_ARRAY(context, pair->base[side], 1, "balls and capsules"));
    graze_solid *base = pair->base[side];
    soup_init(&base->input, of->dimension);
    *given = base;
    pair->pair.round[side] = of->round;
    return fill_bases(base, context, of);
}

int simplex_corners(const placing *p, pair_side side, uint32_t simplex) {
    const csg_round *round = p->pair->round[side];
    return round ? round[simplex].ends : p->pair->motion->dimension;
}

int collide_in_body(size_t *body, graze_cell *cell, const graze_solid *base) {
    if (!base || base->cut.count < 2)
        return 0;
    size_t low = 0, high = base->cut.count;
    while (high - low > 1) {
        size_t middle = low + (high - low) / 2;
        if (base->cut.item[middle].vertex[0] <= cell->a)
            low = middle;
        else
            high = middle;
    }
    size_t first = base->cut.item[low].vertex[0];
    cell->a -= first;
    cell->b -= cell->kind == GRAZE_CELL_EDGE ? first : 0;
    *body = low;
    return 1;
}
