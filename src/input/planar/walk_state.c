/* The state of a search for the facets of a flat solid: its planes, expression, truths and work.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/planar/walk.h"

#include <math.h>
#include "base/context/scope.h"

int flat_surfaces(const csg *solid) {
    int flat = solid->surface_count > 0;
    for (size_t k = 0; k < solid->surface_count && flat; k++)
        flat = solid->surface[k].degree == 1;
    return flat;
}

/* Set the form of a plane from a surface's terms. */
static void set_plane_form(fmpz *form, const csg_surface *s) {
    for (size_t k = 0; k < s->count; k++) {
        int at = 3;
        for (int i = 0; i < 3; i++)
            at = s->power[k][i] ? i : at;
        fmpz_set(form + at, s->coefficient + k);
    }
}

/* Round a form to doubles, over the power of two that makes its entries less than 1. */
static void set_near(double *near, const fmpz *form) {
    slong exponent[4], most = 0;
    for (int i = 0; i < 4; i++) {
        near[i] = fmpz_get_d_2exp(&exponent[i], form + i);
        most = exponent[i] > most ? exponent[i] : most;
    }
    for (int i = 0; i < 4; i++)
        near[i] = ldexp(near[i], exponent[i] - most < -2000 ? -2000 : (int)(exponent[i] - most));
}

static graze_status allocate_walk(flat_walk *w, const csg *solid) {
    size_t sides = solid->box.dimension ? 0 : 2 * (size_t)solid->dimension;
    w->added = solid->surface_count;
    w->plane_count = w->added + sides;
    w->node_count = solid->node_count + (sides ? sides + 1 : 0);
    w->form = _fmpz_vec_init((slong)(4 * w->plane_count + 4));
    size_t n = w->plane_count;
    TRY(MAKE_ARRAY(w->context, w->near, 4 * n, "%zu planes", n));
    TRY(MAKE_ARRAY(w->context, w->node, w->node_count, "%zu planes", n));
    TRY(MAKE_ARRAY(w->context, w->operand, solid->operand_count + 2 * sides + 1, "%zu planes", n));
    TRY(MAKE_ARRAY(w->context, w->sign, n, "%zu planes", n));
    TRY(MAKE_ARRAY(w->context, w->truth, w->node_count, "%zu planes", n));
    TRY(MAKE_ARRAY(w->context, w->matters, n + w->node_count, "%zu planes", n));
    memset(w->truth, UNKNOWN, w->node_count);
    memcpy(w->node, solid->node, solid->node_count * sizeof *w->node);
    memcpy(w->operand, solid->operand, solid->operand_count * sizeof *w->operand);
    for (size_t k = 0; k < w->added; k++)
        set_plane_form(w->form + 4 * k, &solid->surface[k]);
    fmpz_one(w->form + 4 * w->plane_count + 2);
    return GRAZE_OK;
}

/* Add to the expression that a point is in a box about the origin, of half side `reach`. */
static void add_box_sides(flat_walk *w, const csg *solid, const fmpz_t reach) {
    size_t next = solid->operand_count, node = solid->node_count, sides = w->plane_count - w->added;
    for (size_t k = 0; k < sides; k++, next++, node++) {
        fmpz *form = w->form + 4 * (w->added + k);
        fmpz_one(form + k / 2);
        fmpz_set(form + 3, reach);
        if (k % 2)
            fmpz_neg(form + 3, form + 3);
        w->operand[next] = w->added + k;
        w->node[node] =
            (csg_node){.operation = CSG_SIGN, .complement = k % 2 == 0, .first = next, .count = 1};
    }
    w->node[node] = (csg_node){.operation = CSG_ALL, .first = next, .count = sides + 1};
    for (size_t k = 0; k <= sides; k++)
        w->operand[next + k] = solid->node_count - 1 + k;
}

graze_status flat_walk_begin(flat_walk *w, graze_context *context, const csg *solid) {
    *w = (flat_walk){.context = context, .dimension = solid->dimension};
    TRY(allocate_walk(w, solid));
    if (w->plane_count > w->added) {
        /* Cramer: the coordinates of a point in which planes meet are quotients of determinants of
         * at most 3 rows of their entries, less than 6 times the cube of the largest. */
        LOCAL(fmpz, reach);
        ulong bits = (ulong)labs(_fmpz_vec_max_bits(w->form, (slong)(4 * w->added)));
        fmpz_one_2exp(reach, 3 * bits + 3);
        add_box_sides(w, solid, reach);
    }
    for (size_t k = 0; k < w->plane_count; k++)
        set_near(w->near + 4 * k, w->form + 4 * k);
    return GRAZE_OK;
}

void flat_walk_clear(flat_walk *w) {
    if (w->form)
        _fmpz_vec_clear(w->form, (slong)(4 * w->plane_count + 4));
    for (size_t k = 0; k < w->pieces.count; k++) {
        fmpq_clear(&w->pieces.item[k].from);
        fmpq_clear(&w->pieces.item[k].to);
    }
    for (size_t k = 0; k < LINE_FORM * w->lines.count; k++)
        fmpz_clear(w->lines.item + k);
    numbers_clear(&w->stack);
    free(w->near);
    free(w->node);
    free(w->operand);
    free(w->sign);
    free(w->truth);
    free(w->matters);
    free(w->pieces.item);
    free(w->lines.item);
    *w = (flat_walk){.dimension = 0};
}

static signed char node_truth(const flat_walk *w, const csg_node *node) {
    int value = node->operation == CSG_ALL, unknown = 0;
    for (size_t k = node->first; k < node->first + node->count; k++) {
        size_t at = w->operand[k];
        int next = node->operation != CSG_SIGN ? w->truth[at]
                   : w->sign[at]               ? w->sign[at] < 0
                                               : UNKNOWN;
        if (next == UNKNOWN)
            unknown = 1;
        else if (node->operation == CSG_ALL || node->operation == CSG_ANY) {
            if (next != (node->operation == CSG_ALL))
                return (signed char)(next ^ node->complement);
        } else
            value ^= next;
    }
    return (signed char)(unknown ? UNKNOWN : value ^ node->complement);
}

int flat_evaluate(flat_walk *w, const flat_live *live) {
    size_t n = 0;
    for (size_t k = 0; k < live->nodes; k++) {
        n = w->stack.item[live->node + k];
        w->truth[n] = node_truth(w, &w->node[n]);
    }
    return w->truth[n];
}

graze_status flat_spend(flat_walk *w, unsigned long work) {
    graze_context *context = w->context;
    if (work > context->limits[GRAZE_LIMIT_WORK] - context->work)
        return context_limit(context, GRAZE_LIMIT_WORK, "the facets of a solid of planes");
    context->work += work;
    return context_work(context, work);
}
