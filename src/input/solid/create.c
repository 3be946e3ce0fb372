/* A solid from a soup: validation, bounds, boxes, tree, side tests.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/solid/solid.h"

#include <stdatomic.h>
#include <stdio.h>
#include "base/context/scope.h"
#include "input/planar/planar.h"

static graze_status make_slabs(graze_solid *solid, graze_context *context) {
    return slabs_make(&solid->slabs, &solid->boxes, &solid->corners, solid->input.dimension)
               ? GRAZE_OK
               : context_fail(context, GRAZE_ESYSTEM, "out of memory for slabs of %zu simplices",
                              solid->cut.count);
}

static void make_note(graze_solid *solid) {
    const flat_sides *flat = &solid->cut.flat;
    char ring[64] = "", others[64] = "a side without length is no edge";
    if (flat->count == 0)
        return;
    if (solid->input.dimension == 2)
        snprintf(ring, sizeof ring, ", ring %zu", flat->cycle);
    if (flat->count > 1)
        snprintf(others, sizeof others, "%zu sides without length are no edges", flat->count);
    snprintf(solid->note, sizeof solid->note,
             "%s %zu%s: vertices %u and %u follow one another at one position; %s",
             solid->input.dimension == 2 ? "polygon" : "facet", flat->facet, ring, flat->from,
             flat->to, others);
}

static unsigned long next_number(void) {
    static atomic_ulong made;
    return atomic_fetch_add(&made, 1) + 1;
}

/* Compute all members that follow from the soup. */
static graze_status fill_solid(graze_solid *solid, graze_context *context, unsigned flags) {
    TRY(validate_soup(&solid->cut, context, &solid->input, flags));
    TRY(skin_bounds(&solid->low, &solid->high, context, &solid->input));
    skin bare = solid_skin(solid);
    TRY(skin_tree(&solid->boxes, context, &bare));
    TRY(corners_make(&solid->corners, context, &solid->input, &solid->cut, solid->low,
                     solid->high));
    TRY(make_slabs(solid, context));
    TRY(solid_check_sides(solid, context));
    make_note(solid);
    return GRAZE_OK;
}

graze_status solid_create(graze_solid **out, graze_context *context, soup *input, unsigned flags) {
    *out = NULL;
    graze_solid *solid = calloc(1, sizeof *solid);
    if (!solid) {
        soup_clear(input);
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for a solid");
    }
    solid->number = next_number();
    solid->input = *input;
    graze_status status = fill_solid(solid, context, flags);
    if (status == GRAZE_OK)
        *out = solid;
    else
        graze_solid_destroy(solid);
    return status;
}

graze_status solid_is_another(graze_context *context, const char *path) {
    return context_fail_in(context, GRAZE_EINPUT, path, 0,
                           "is not the file that was validated: its SHA-256 is another");
}

/* Make a solid of an expression whose surfaces are all planes. Only where given->form is CSG_FACETS
 * afterwards is there one. */
static graze_status take_planes(graze_solid **out, graze_context *context, csg *given,
                                const unsigned char sha256[32], unsigned flags) {
    soup input;
    graze_status status = planar_soup(&input, &given->form, context, given);
    if (status || given->form != CSG_FACETS) {
        soup_clear(&input);
        return status;
    }
    memcpy(input.sha256, sha256, sizeof input.sha256);
    return solid_create(out, context, &input, flags);
}

/* Make a solid of an expression. The function takes the expression over, also on failure. */
static graze_status take_curved(graze_solid **out, graze_context *context, csg *given,
                                const unsigned char sha256[32], unsigned flags) {
    static const char *const why[] = {
        [CSG_EMPTY] = "empty", [CSG_UNBOUNDED] = "unbounded", [CSG_WIDE] = "too large for a mesh"};
    if (flat_surfaces(given)) {
        graze_status status = take_planes(out, context, given, sha256, flags);
        if (status || given->form == CSG_FACETS) {
            csg_clear(given);
            return status;
        }
    }
    graze_solid *solid = calloc(1, sizeof *solid);
    csg *curved = calloc(1, sizeof *curved);
    if (!solid || !curved) {
        csg_clear(given);
        free(curved);
        free(solid);
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for a solid");
    }
    *curved = *given;
    memcpy(solid->input.sha256, sha256, sizeof solid->input.sha256);
    solid->number = next_number();
    solid->input.dimension = curved->dimension;
    solid->curved = curved;
    if (why[curved->form])
        snprintf(solid->note, sizeof solid->note,
                 "all its surfaces are %s, but it is %s, so it is taken as a curved solid",
                 curved->dimension == 3 ? "planes" : "lines", why[curved->form]);
    *out = solid;
    return GRAZE_OK;
}

graze_status solid_create_curved(graze_solid **out, graze_context *context, const char *path,
                                 const unsigned char *sha256) {
    csg curved;
    unsigned char found[32];
    *out = NULL;
    TRY(csg_read(&curved, found, context, path));
    if (sha256 && memcmp(sha256, found, sizeof found) != 0) {
        csg_clear(&curved);
        return solid_is_another(context, path);
    }
    return context_in(
        context, take_curved(out, context, &curved, found, sha256 ? VALIDATE_TRUST_CONTACTS : 0),
        path, 0);
}

graze_status solid_create_curved_text(graze_solid **out, graze_context *context, const char *name,
                                      const char *text, size_t length,
                                      const unsigned char sha256[32]) {
    csg curved;
    *out = NULL;
    TRY(csg_read_text(&curved, context, name, text, length));
    return context_in(context, take_curved(out, context, &curved, sha256, 0), name, 0);
}

void graze_solid_destroy(graze_solid *solid) {
    if (!solid)
        return;
    if (solid->curved)
        csg_clear(solid->curved);
    free(solid->curved);
    free(solid->low);
    free(solid->high);
    tree_clear(&solid->boxes);
    corners_clear(&solid->corners);
    slabs_clear(&solid->slabs);
    simplices_clear(&solid->cut);
    soup_clear(&solid->input);
    free(solid);
}
