/* Static point location by one ray, and the side test of the boundary's components.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The ray leaves x in the direction of the first axis. Displaced by (0, e, e^2) with e positive and
 * infinitesimal it meets no vertex and no edge, and no plane parallel to it: every sign below that
 * is zero at x is decided by the first non-zero coefficient of the displacement. The signed number
 * of facets that the ray leaves through is the winding number at x (proofs/claims.md C6). Doubles
 * settle the triangles that the ray clearly misses or clearly crosses beyond x.
 */
#include "input/solid/solid.h"

#include <math.h>
#include "base/context/scope.h"
#include "base/number/rounding.h"

typedef struct ray {
    const skin *of;
    const fmpz *x;
    box around;      /* holds x */
    box reach;       /* holds x and the ray up to the last simplex */
    size_t skip;     /* a simplex that is not looked at, or SIZE_MAX */
    long winding;    /* facets left minus facets entered */
    int on_boundary; /* x lies in a simplex other than `skip` */
} ray;

/* Sign of a form at the displaced point; `at_x` is the sign at x. */
static int displaced_sign(const fmpz *form, int at_x, int dimension) {
    if (at_x != 0)
        return at_x;
    int sign = fmpz_sgn(form + 1);
    return sign != 0 || dimension == 2 ? sign : fmpz_sgn(form + 2);
}

/* The last two coordinates of the vector from x to a vertex, and bounds of their errors. */
typedef struct arrow {
    double y, z, off_y, off_z;
} arrow;

/* v - x differs from `value` by at most the two widths and the rounding of the subtraction, 2^-53
 * |value|. Factors larger than needed outweigh the rounding of the bound, and the last term
 * outweighs underflow. */
static double separation(double *off, double low, double high, double x_low, double x_high) {
    double value = low - x_low;
    *off = 2 * ((high - low) + (x_high - x_low)) + 0x1p-51 * fabs(value) + 0x1p-1060;
    return value;
}

static arrow arrow_to(const ray *r, size_t vertex) {
    const double *low = r->of->low + 3 * vertex, *high = r->of->high + 3 * vertex;
    const box *x = &r->around;
    arrow a;
    a.y = separation(&a.off_y, low[1], high[1], x->low[1], x->high[1]);
    a.z = separation(&a.off_z, low[2], high[2], x->low[2], x->high[2]);
    return a;
}

/* Sign of a.y b.z - a.z b.y, or 0 where doubles do not decide it, as with infinities and NaN. A
 * product of true values is within off_y (|z| + off_z) + |y| off_z of y z; three roundings take
 * less than 2^-51 of the two products, and 2^-900 outweighs underflow. */
static int turn(const arrow *a, const arrow *b) {
    double first = a->y * b->z, second = a->z * b->y;
    double value = first - second;
    double bound = 2 * (a->off_y * (fabs(b->z) + b->off_z) + fabs(a->y) * b->off_z +
                        a->off_z * (fabs(b->y) + b->off_y) + fabs(a->z) * b->off_y) +
                   0x1p-50 * (fabs(first) + fabs(second)) + 0x1p-900;
    return (value > bound) - (value < -bound);
}

/* Settle a triangle in doubles; 0 if they do not decide. Projected along the ray, x is outside it
 * if it lies on different sides of two edges, and strictly inside if it lies on the same side of
 * all. In that case the outward normal points along the ray iff the triangle turns to the left, and
 * the crossing is beyond x if the whole triangle is. */
static int settle(ray *r, size_t simplex) {
    const uint32_t *v = r->of->cut->item[simplex].vertex;
    arrow to[3] = {arrow_to(r, v[0]), arrow_to(r, v[1]), arrow_to(r, v[2])};
    int left = 0, right = 0, beyond = 1;
    for (int k = 0; k < 3; k++) {
        int sign = turn(&to[k], &to[(k + 1) % 3]);
        left += sign > 0;
        right += sign < 0;
        beyond = beyond && r->of->low[3 * (size_t)v[k]] > r->around.high[0];
    }
    if (left > 0 && right > 0)
        return 1;
    if (!beyond || (left < 3 && right < 3))
        return 0;
    r->winding += left == 3 ? 1 : -1;
    return 1;
}

static void cross_exactly(ray *r, size_t simplex) {
    int d = r->of->input->dimension;
    LOCAL_VEC(fmpz, plane, 2 * (d + 1));
    fmpz *side = plane + d + 1;
    int facing = skin_plane(plane, r->of, simplex);
    int parallel = fmpz_is_zero(plane), plane_sign = form_sign(plane, r->x, d);
    int contains = plane_sign == 0;
    /* The plane's first coefficient is positive, so the ray runs from its negative to its positive
     * side. */
    int crosses = !parallel && displaced_sign(plane, plane_sign, d) < 0;
    for (int k = 0; k < d && (contains || crosses); k++) {
        skin_side(side, r->of, simplex, plane, k);
        int sign = form_sign(side, r->x, d);
        contains = contains && sign >= 0;
        crosses = crosses && displaced_sign(side, sign, d) > 0;
    }
    r->on_boundary |= contains;
    r->winding += crosses ? facing : 0;
}

static void descend(ray *r, size_t index) {
    const tree_node *node = &r->of->boxes->node[index];
    if (!box_meets(&node->box, &r->reach))
        return;
    if (node->child) {
        descend(r, node->child);
        descend(r, node->child + 1);
    } else if (node->simplex != r->skip &&
               !(r->of->input->dimension == 3 && settle(r, node->simplex))) {
        cross_exactly(r, node->simplex);
    }
}

static void shoot(ray *r) {
    int d = r->of->input->dimension;
    LOCAL(fmpq, coordinate);
    r->around = (box){{0, 0, 0}, {0, 0, 0}};
    for (int i = 0; i < d; i++) {
        fmpq_set_fmpz_frac(coordinate, r->x + i, r->x + d);
        rational_bounds(&r->around.low[i], &r->around.high[i], coordinate);
    }
    r->reach = r->around;
    double root_high = r->of->boxes->node[0].box.high[0];
    if (root_high > r->reach.high[0])
        r->reach.high[0] = root_high;
    descend(r, 0);
}

long skin_winding(int *on, const skin *s, const fmpz *x) {
    ray r = {.of = s, .x = x, .skip = SIZE_MAX};
    if (s->boxes->node_count)
        shoot(&r);
    *on = r.on_boundary;
    return r.winding;
}

graze_state solid_locate(const graze_solid *solid, const fmpz *x) {
    skin boundary = solid_skin(solid);
    int on;
    long winding = skin_winding(&on, &boundary, x);
    if (on)
        return GRAZE_STATE_B;
    return winding == 1 ? GRAZE_STATE_I : winding == 0 ? GRAZE_STATE_O : GRAZE_STATE_ABSENT;
}

void solid_point_within(fmpz *x, const graze_solid *solid, size_t simplex, ulong w) {
    int d = solid->input.dimension;
    LOCAL_VEC(fmpq, sum, d);
    ulong weight = 1, total = 0;
    for (int k = 0; k < d; k++, weight *= w) {
        const fmpq *v = solid->input.coordinates + solid->cut.item[simplex].vertex[k] * (size_t)d;
        total += weight;
        for (int i = 0; i < d; i++) {
            LOCAL(fmpq, term);
            fmpq_mul_ui(term, v + i, weight);
            fmpq_add(sum + i, sum + i, term);
        }
    }
    _fmpq_vec_get_fmpz_vec_fmpz(x, x + d, sum, d);
    fmpz_mul_ui(x + d, x + d, total);
}

/* The winding number on the outer side of a simplex that is not parallel to the ray, near a point
 * of its relative interior that lies on no other simplex. Such a point exists: the others meet this
 * simplex in finitely many points or segments. */
static long winding_outside(const graze_solid *solid, size_t simplex, int facing) {
    LOCAL_VEC(fmpz, x, solid->input.dimension + 1);
    skin boundary = solid_skin(solid);
    ray r;
    ulong w = 1;
    do {
        solid_point_within(x, solid, simplex, w++);
        r = (ray){.of = &boundary, .x = x, .skip = simplex};
        shoot(&r);
    } while (r.on_boundary);
    return facing > 0 ? r.winding : r.winding - 1;
}

static graze_status check_component(const graze_solid *solid, graze_context *context,
                                    size_t simplex, int facing) {
    long outside = winding_outside(solid, simplex, facing);
    unsigned facet = solid->cut.item[simplex].facet;
    const char *name = solid->input.dimension == 2 ? "edge" : "facet";
    if (outside == 0)
        return GRAZE_OK;
    if (outside < 0)
        context_fail(context, GRAZE_EILLEGAL,
                     "inside out: the winding number is %ld on its outer side and "
                     "%ld on its inner side, not 0 and 1; seen from outside a shell runs "
                     "counter-clockwise, and only a cavity inside a shell runs the other "
                     "way",
                     outside, outside + 1);
    else
        context_fail(context, GRAZE_EILLEGAL,
                     "shells overlap: the winding number is %ld on its outer side, "
                     "which already lies in the solid, not 0; no shell may lie inside another, "
                     "and a cavity must be oriented inward",
                     outside);
    return context_item(context, GRAZE_EILLEGAL, name, facet, NULL);
}

graze_status solid_check_sides(const graze_solid *solid, graze_context *context) {
    size_t count = solid->cut.component_count;
    FREED(unsigned char, done, calloc(count ? count : 1, 1));
    if (!done)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for %zu components", count);
    LOCAL_VEC(fmpz, plane, solid->input.dimension + 1);
    for (size_t s = 0; s < solid->cut.count; s++) {
        size_t component = solid->cut.item[s].component;
        if (done[component])
            continue;
        int facing = solid_plane(plane, solid, s);
        /* Every component has a facet that is not parallel to the ray, since it is closed. */
        if (fmpz_is_zero(plane))
            continue;
        done[component] = 1;
        TRY(check_component(solid, context, s, facing));
        TRY(context_poll(context));
    }
    return GRAZE_OK;
}
