/* Static point location by one ray, and the side test of the boundary's components.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The ray leaves x in the direction of the first axis. Displaced by (0, e, e^2) with e positive and
 * infinitesimal it meets no vertex and no edge, and no plane parallel to it: every sign below that
 * is zero at x is decided by the first non-zero coefficient of the displacement. The signed number
 * of facets that the ray leaves through is the winding number at x (proofs/claims.md).
 */
#include "solid/solid.h"

#include <flint/fmpq_vec.h>
#include <flint/fmpz_vec.h>
#include <stdlib.h>
#include "number/rational.h"

typedef struct ray {
    const graze_solid *solid;
    const fmpz *x;
    box reach;       /* x and all that lies behind it on the ray */
    size_t skip;     /* a simplex that is not looked at, or SIZE_MAX */
    long winding;    /* facets left minus facets entered */
    int on_boundary; /* x lies in a simplex other than `skip` */
} ray;

/* Sign of a form at the displaced point. */
static int displaced_sign(const fmpz *form, int at_x, int dimension) {
    if (at_x != 0)
        return at_x;
    int sign = fmpz_sgn(form + 1);
    return sign != 0 || dimension == 2 ? sign : fmpz_sgn(form + 2);
}

static void cross_simplex(ray *r, size_t simplex) {
    int d = r->solid->input.dimension;
    const fmpz *plane = solid_plane(r->solid, simplex);
    int parallel = fmpz_is_zero(plane), plane_sign = form_sign(plane, r->x, d);
    if (parallel && plane_sign != 0)
        return;
    int contains = 1, crosses = !parallel;
    for (int k = 0; k < d && (contains || crosses); k++) {
        const fmpz *side = solid_side(r->solid, simplex, k);
        int sign = form_sign(side, r->x, d);
        contains = contains && sign >= 0;
        crosses = crosses && displaced_sign(side, sign, d) > 0;
    }
    if (contains && plane_sign == 0)
        r->on_boundary = 1;
    /* The plane's first coefficient is positive, so the ray runs from its negative to its positive
     * side. */
    if (crosses && displaced_sign(plane, plane_sign, d) < 0)
        r->winding += r->solid->facing[simplex];
}

static void descend(ray *r, size_t index) {
    const tree_node *node = &r->solid->boxes.node[index];
    if (!box_meets(&node->box, &r->reach))
        return;
    if (node->child) {
        descend(r, node->child);
        descend(r, node->child + 1);
    } else if (node->simplex != r->skip) {
        cross_simplex(r, node->simplex);
    }
}

static void shoot(ray *r) {
    int d = r->solid->input.dimension;
    fmpq_t coordinate;
    fmpq_init(coordinate);
    r->reach = (box){{0, 0, 0}, {0, 0, 0}};
    for (int i = 0; i < d; i++) {
        fmpq_set_fmpz_frac(coordinate, r->x + i, r->x + d);
        rational_bounds(&r->reach.low[i], &r->reach.high[i], coordinate);
    }
    double root_high = r->solid->boxes.node[0].box.high[0];
    if (root_high > r->reach.high[0])
        r->reach.high[0] = root_high;
    fmpq_clear(coordinate);
    descend(r, 0);
}

graze_state solid_locate(const graze_solid *solid, const fmpz *x) {
    ray r = {.solid = solid, .x = x, .skip = SIZE_MAX};
    shoot(&r);
    if (r.on_boundary)
        return GRAZE_STATE_B;
    return r.winding == 1 ? GRAZE_STATE_I : r.winding == 0 ? GRAZE_STATE_O : GRAZE_STATE_ABSENT;
}

/* The point with the barycentric weights 1, w, w^2 ... in a simplex, homogeneous. */
static void weighted_point(fmpz *x, const graze_solid *solid, size_t simplex, ulong w) {
    int d = solid->input.dimension;
    fmpq *sum = _fmpq_vec_init(d);
    ulong weight = 1, total = 0;
    for (int k = 0; k < d; k++, weight *= w) {
        const fmpq *v = solid->input.coordinates + solid->cut.item[simplex].vertex[k] * (size_t)d;
        total += weight;
        for (int i = 0; i < d; i++) {
            fmpq_t term;
            fmpq_init(term);
            fmpq_mul_ui(term, v + i, weight);
            fmpq_add(sum + i, sum + i, term);
            fmpq_clear(term);
        }
    }
    fmpz_one(x + d);
    for (int i = 0; i < d; i++)
        fmpz_lcm(x + d, x + d, fmpq_denref(sum + i));
    for (int i = 0; i < d; i++) {
        fmpz_divexact(x + i, x + d, fmpq_denref(sum + i));
        fmpz_mul(x + i, x + i, fmpq_numref(sum + i));
    }
    fmpz_mul_ui(x + d, x + d, total);
    _fmpq_vec_clear(sum, d);
}

/* The winding number outside a simplex that is not parallel to the ray, near a point of its
 * relative interior that lies on no other simplex. Such a point exists: the others meet it in
 * finitely many segments. */
static long winding_outside(const graze_solid *solid, size_t simplex) {
    fmpz *x = _fmpz_vec_init(solid->input.dimension + 1);
    ray r;
    ulong w = 1;
    do {
        weighted_point(x, solid, simplex, w++);
        r = (ray){.solid = solid, .x = x, .skip = simplex};
        shoot(&r);
    } while (r.on_boundary);
    _fmpz_vec_clear(x, solid->input.dimension + 1);
    return solid->facing[simplex] > 0 ? r.winding : r.winding - 1;
}

static graze_status check_component(const graze_solid *solid, graze_context *context,
                                    size_t simplex) {
    long outside = winding_outside(solid, simplex);
    unsigned facet = solid->cut.item[simplex].facet;
    const char *name = solid->input.dimension == 2 ? "edge" : "facet";
    if (outside == 0)
        return GRAZE_OK;
    if (outside < 0)
        return context_fail(context, GRAZE_EILLEGAL,
                            "%s %u: inside out: the winding number is %ld on its outer side and "
                            "%ld on its inner side, not 0 and 1; seen from outside a shell runs "
                            "counter-clockwise, and only a cavity inside a shell runs the other "
                            "way",
                            name, facet, outside, outside + 1);
    return context_fail(context, GRAZE_EILLEGAL,
                        "%s %u: shells overlap: the winding number is %ld on its outer side, "
                        "which already lies in the solid, not 0; no shell may lie inside another, "
                        "and a cavity must be oriented inward",
                        name, facet, outside);
}

graze_status solid_check_sides(const graze_solid *solid, graze_context *context) {
    size_t count = solid->cut.component_count;
    unsigned char *done = calloc(count ? count : 1, 1);
    if (!done)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for %zu components", count);
    graze_status status = GRAZE_OK;
    for (size_t s = 0; s < solid->cut.count && status == GRAZE_OK; s++) {
        size_t component = solid->cut.item[s].component;
        /* A closed boundary is not made of facets parallel to the ray alone. */
        if (done[component] || fmpz_is_zero(solid_plane(solid, s)))
            continue;
        done[component] = 1;
        status = check_component(solid, context, s);
        if (status == GRAZE_OK)
            status = context_poll(context);
    }
    free(done);
    return status;
}
