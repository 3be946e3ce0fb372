/* A descent of two trees at a time, the moving one through the images of its boxes.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/collide/near_pairs.h"

#include <math.h>
#include "base/context/array.h"
#include "decide/filter/normal.h"
#include "input/solid/box_image.h"

graze_status node_list_add(node_list *list, graze_context *context, node_pair item) {
    graze_status status = array_grow(context, &list->item, &list->capacity, list->count + 1,
                                     sizeof *list->item, "pairs of boxes");
    if (!status)
        list->item[list->count++] = item;
    return status;
}

graze_status near_pairs_take(near_list *out, graze_context *context, const solid_pair *pair,
                             const node_list *leaves) {
    graze_status status = array_grow(context, &out->item, &out->capacity, leaves->count,
                                     sizeof *out->item, "pairs of simplices");
    out->count = 0;
    for (size_t k = 0; k < leaves->count && !status; k++)
        out->item[out->count++] =
            (near_pair){pair->moving->boxes.node[leaves->item[k].moving].simplex,
                        pair->fixed->boxes.node[leaves->item[k].fixed].simplex};
    return status;
}

/* The plane of a simplex. */
typedef struct rough_plane {
    const double *at; /* a corner */
    normal normal;
} rough_plane;

static void find_plane(rough_plane *out, const corners *of, uint32_t simplex, int d) {
    out->at = of->at + (size_t)simplex * (size_t)(d * d);
    if (d == 3)
        normal_space(&out->normal, out->at, of->error);
    else
        normal_plane(&out->normal, out->at, of->error);
}

/* The side of a plane on which a vertex is at control map k: 0 if it is not certain. */
static int side_at_control(const rough_plane *plane, const corners *plane_of,
                           const control_maps *maps, size_t k, const double *vertex,
                           const corners *of) {
    int d = maps->dimension;
    double value = 0, t = 0, far = maps->shift[k] + maps->slope[k] * of->reach;
    for (int i = 0; i < d; i++) {
        const double *row = maps->entry + k * (size_t)(d * (d + 1)) + i * (d + 1);
        double x = row[d];
        for (int j = 0; j < d; j++)
            x += row[j] * vertex[j];
        double w = x - plane->at[i];
        value += plane->normal.at[i] * w;
        t = larger(t, fabs(w));
    }
    /* What a difference of coordinates errs by. */
    double e =
        0x1p-44 * (far + plane_of->reach) + plane_of->error + of->error * (1 + maps->slope[k]);
    double bound = 4 * (largest3(plane->normal.at) * e + plane->normal.error * (t + e)) + 0x1p-600;
    return !isfinite(value) ? 0 : value > bound ? 1 : value < -bound ? -1 : 0;
}

/* The side on which a vertex is all the time, or 0. */
static int side_throughout(const rough_plane *plane, const corners *plane_of,
                           const control_maps *maps, const double *vertex, const corners *of) {
    int side = 0;
    for (size_t k = 0; k < maps->count; k++) {
        int here = side_at_control(plane, plane_of, maps, k, vertex, of);
        if (!here || (k > 0 && here != side))
            return 0;
        side = here;
    }
    return side;
}

int vertex_off_plane(const corners *plane_of, uint32_t simplex, const control_maps *maps,
                     const double *vertex, const corners *of) {
    rough_plane plane;
    find_plane(&plane, plane_of, simplex, maps->dimension);
    return side_throughout(&plane, plane_of, maps, vertex, of) != 0;
}

/* Are all corners of `simplex` on one side of the plane of `other` all the time? */
static int plane_between(const corners *corners_of, uint32_t simplex, const corners *plane_of,
                         uint32_t other, const control_maps *maps) {
    size_t d = (size_t)maps->dimension;
    const double *at = corners_of->at + simplex * d * d;
    rough_plane plane;
    int side = 0;
    find_plane(&plane, plane_of, other, maps->dimension);
    for (size_t k = 0; k < d; k++) {
        int here = side_throughout(&plane, plane_of, maps, at + k * d, corners_of);
        if (!here || (k > 0 && here != side))
            return 0;
        side = here;
    }
    return 1;
}

/* Are two simplices certainly apart during an interval, by the plane of one of them? */
static int near_pair_apart(const solid_pair *pair, const motion_stretch *at, near_pair simplices) {
    const corners *a = &pair->moving->corners, *b = &pair->fixed->corners;
    if (!a->at || !b->at || !at->forward.count)
        return 0;
    return plane_between(a, simplices.moving, b, simplices.fixed, &at->forward) ||
           (at->inverse.count &&
            plane_between(b, simplices.fixed, a, simplices.moving, &at->inverse));
}

typedef struct refiner {
    const solid_pair *pair;
    const motion_stretch *at;
    node_list *near, *coarse;
    int at_once;
    graze_context *context;
    graze_status status;
} refiner;

/* A node of the moving tree during the interval: its box, and how large it is at one time. */
typedef struct moved_node {
    uint32_t node;
    box box;
    double size;
} moved_node;

static void move_node(moved_node *out, const refiner *r, uint32_t node) {
    const control_maps *maps = &r->at->forward;
    box begun = r->pair->moving->boxes.node[node].box;
    out->node = node;
    control_maps_bound(&out->box, maps, &begun);
    if (maps->count)
        box_image(&begun, maps->entry, maps->dimension, &r->pair->moving->boxes.node[node].box);
    out->size = box_extent(&begun);
}

static void refine_pair(refiner *r, const moved_node *moved, uint32_t fixed) {
    const tree_node *a = &r->pair->moving->boxes.node[moved->node];
    const tree_node *b = &r->pair->fixed->boxes.node[fixed];
    if (r->status || !box_meets(&moved->box, &b->box))
        return;
    double other = box_extent(&b->box);
    int leaves = !a->child && !b->child;
    if (leaves && near_pair_apart(r->pair, r->at, (near_pair){a->simplex, b->simplex}))
        return;
    if (!r->at_once && box_extent(&moved->box) > moved->size + 2 * fmax(moved->size, other)) {
        r->status = node_list_add(r->coarse, r->context, (node_pair){moved->node, fixed});
    } else if (leaves) {
        r->status = node_list_add(r->near, r->context, (node_pair){moved->node, fixed});
    } else if (a->child && (!b->child || moved->size >= other)) {
        for (uint32_t k = 0; k < 2; k++) {
            moved_node child;
            move_node(&child, r, a->child + k);
            refine_pair(r, &child, fixed);
        }
    } else {
        refine_pair(r, moved, b->child);
        refine_pair(r, moved, b->child + 1);
    }
}

graze_status near_pairs_refine(node_list *near, node_list *coarse, graze_context *context,
                               const solid_pair *pair, const motion_stretch *at,
                               const node_list *in, int at_once) {
    refiner r = {.pair = pair, .at = at, .near = near, .coarse = coarse, .at_once = at_once};
    r.context = context;
    moved_node moved;
    for (size_t k = 0; k < in->count && !r.status; k++) {
        if (k == 0 || in->item[k].moving != in->item[k - 1].moving)
            move_node(&moved, &r, in->item[k].moving);
        refine_pair(&r, &moved, in->item[k].fixed);
        if (!r.status && k % 64 == 0)
            r.status = context_poll(context);
    }
    return r.status;
}
