/* The public functions of boundaries by sampling.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <stdlib.h>
#include <string.h>
#include "api.h"
#include "boundary/boundary.h"
#include "context/environment.h"

/* The box asked for, or the scene's, a sixteenth wider on every side, whose border is all out. */
static graze_status set_box(struct graze_boundary *b, graze_context *context,
                            const graze_boundary_options *o) {
    mpq_t high[3], margin;
    graze_status status = GRAZE_OK;
    mpq_inits(high[0], high[1], high[2], margin, NULL);
    if (!o->low)
        status = graze_scene_box(b->low, high, context, b->scene);
    for (int k = 0; k < b->dimension && !status; k++) {
        if (o->low) {
            mpq_set(b->low[k], o->low[k]);
            mpq_set(high[k], o->high[k]);
        }
        mpq_sub(b->side[k], high[k], b->low[k]);
        if (mpq_sgn(b->side[k]) <= 0)
            status = context_fail(context, GRAZE_EUSE, "the box is empty along axis %d", k);
        if (o->low)
            continue;
        mpq_div_2exp(margin, b->side[k], 4);
        mpq_sub(b->low[k], b->low[k], margin);
        mpq_mul_2exp(margin, margin, 1);
        mpq_add(b->side[k], b->side[k], margin);
    }
    mpq_clears(high[0], high[1], high[2], margin, NULL);
    return status;
}

static graze_status list_leaves(struct graze_boundary *b, graze_context *context) {
    size_t capacity = 0;
    graze_status status = GRAZE_OK;
    for (size_t i = 0; i < b->cell_count && !status; i++) {
        if (b->cells[i].child)
            continue;
        status = boundary_grow((void **)&b->leaves, &capacity, b->leaf_count + 1, sizeof *b->leaves,
                               context);
        if (!status)
            b->leaves[b->leaf_count++] = i;
    }
    return status;
}

static graze_status make(struct graze_boundary *b, graze_context *context,
                         const graze_boundary_options *o) {
    graze_status status = set_box(b, context, o);
    if (!status && o->contacts >= o->budget)
        status = boundary_refuse_budget(context, b, o->contacts);
    if (!status)
        status = boundary_contacts(context, b, o->contacts, o->seed);
    if (!status)
        status = boundary_refine(context, b);
    if (!status)
        status = boundary_surface(context, b);
    return status ? status : list_leaves(b, context);
}

graze_status graze_boundary_create(graze_boundary **out, graze_context *context,
                                   const graze_scene *scene,
                                   const graze_boundary_options *options) {
    if (out)
        *out = NULL;
    if (!out || !context || !scene || !options || !options->low != !options->high)
        return api_misuse(context, "graze_boundary_create",
                          "no argument may be NULL, nor one of low and high");
    if (options->depth > BOUNDARY_DEPTH || options->coarse > options->depth)
        return api_misuse(context, "graze_boundary_create",
                          "the depth is at most 19, and the coarse level at most the depth");
    __attribute__((cleanup(environment_leave), unused)) environment host = environment_enter();
    struct graze_boundary *b = calloc(1, sizeof *b);
    if (!b)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory");
    b->scene = scene;
    b->dimension = graze_scene_dimension(scene);
    b->coarse = options->coarse;
    b->depth = options->depth;
    b->budget = options->budget;
    b->complete = 1;
    for (int k = 0; k < 3; k++)
        mpq_inits(b->low[k], b->side[k], b->point[k], NULL);
    graze_status status = make(b, context, options);
    if (status)
        graze_boundary_destroy(b);
    else
        *out = b;
    return status;
}

void graze_boundary_destroy(graze_boundary *b) {
    if (!b)
        return;
    for (int k = 0; k < 3; k++)
        mpq_clears(b->low[k], b->side[k], b->point[k], NULL);
    table_clear(&b->points);
    table_clear(&b->vertices);
    free(b->cells);
    free(b->leaves);
    free(b->contacts);
    free(b->work);
    free(b->corners);
    free(b);
}

graze_boundary_summary graze_boundary_summarize(const graze_boundary *b) {
    graze_boundary_summary out;
    memset(&out, 0, sizeof out);
    if (!b)
        return out;
    out.points = b->points.count;
    out.cells = b->leaf_count;
    out.vertices = b->vertices.count;
    out.faces = b->face_count;
    out.in = b->known[GRAZE_IN];
    out.on = b->known[GRAZE_ON];
    out.out = b->known[GRAZE_OUT];
    out.contacts = b->asked;
    out.contacts_on = b->contact_count;
    out.missed = b->missed;
    out.level = b->reached;
    out.complete = b->complete;
    out.closed = b->closed;
    return out;
}

graze_pmc graze_boundary_point(mpq_t *point, const graze_boundary *b, size_t index) {
    if (!point || !b || index >= b->points.count)
        return GRAZE_PMC_NONE;
    lattice_point(point, b, b->points.key[index]);
    return (graze_pmc)b->points.value[index];
}

graze_boundary_cell graze_boundary_cell_at(const graze_boundary *b, size_t index) {
    graze_boundary_cell out;
    memset(&out, 0, sizeof out);
    if (!b || index >= b->leaf_count)
        return out;
    const cell *c = b->cells + b->leaves[index];
    int mixed = 0;
    out.level = c->level;
    for (unsigned k = 0; k < 1u << b->dimension; k++) {
        out.corners[k] = table_find(&b->points, cell_corner(b, c, k));
        graze_pmc pmc = (graze_pmc)b->points.value[out.corners[k]];
        mixed |= k > 0 && pmc != out.pmc;
        out.pmc = pmc;
    }
    out.pmc = mixed ? GRAZE_PMC_NONE : out.pmc;
    out.contact = cell_has_contact(b, c);
    return out;
}

void graze_boundary_vertex(mpq_t *point, const graze_boundary *b, size_t index) {
    if (point && b && index < b->vertices.count)
        lattice_point(point, b, b->vertices.key[index]);
}

const size_t *graze_boundary_face(const graze_boundary *b, size_t index) {
    return b && index < b->face_count ? b->corners + index * (size_t)b->dimension : NULL;
}
