/* A descent of two trees at a time, the moving one through the images of its boxes.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/collide/near_pairs.h"

#include <math.h>
#include "base/context/array.h"
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

static void image_of(double out[3], const double *entry, int d, const double *x) {
    for (int i = 0; i < d; i++) {
        const double *row = entry + i * (d + 1);
        out[i] = row[d];
        for (int j = 0; j < d; j++)
            out[i] += row[j] * x[j];
    }
}

/* Bounds of what an image errs by and of how far it is from the origin. */
static double image_reach(const double *entry, int d, double reach) {
    double most = 0;
    for (int i = 0; i < d; i++) {
        double sum = fabs(entry[i * (d + 1) + d]);
        for (int j = 0; j < d; j++)
            sum += fabs(entry[i * (d + 1) + j]) * reach;
        most = fmax(most, sum);
    }
    return most;
}

/* The volume (E^2: area) that a simplex's corners p span with x, from differences of at most s
 * within the simplex and at most t to x. */
static double spanned(double *s, double *t, const double *p, int d, const double *x) {
    double u[3] = {0}, v[3] = {0}, w[3] = {0};
    *s = *t = 0;
    for (int i = 0; i < d; i++) {
        u[i] = p[d + i] - p[i];
        v[i] = d == 3 ? p[2 * d + i] - p[i] : 0;
        w[i] = x[i] - p[i];
        *s = fmax(*s, fmax(fabs(u[i]), fabs(v[i])));
        *t = fmax(*t, fabs(w[i]));
    }
    if (d == 2)
        return u[0] * w[1] - u[1] * w[0];
    return (u[1] * v[2] - u[2] * v[1]) * w[0] + (u[2] * v[0] - u[0] * v[2]) * w[1] +
           (u[0] * v[1] - u[1] * v[0]) * w[2];
}

/* The side of a simplex's plane on which a point is at one control map: 0 if it is not certain. */
static int side_at_control(const corners *plane_of, uint32_t simplex, int d, const double *entry,
                           const double *vertex, double error, double reach) {
    double x[3], s, t, far = image_reach(entry, d, reach);
    image_of(x, entry, d, vertex);
    double value = spanned(&s, &t, plane_of->at + (size_t)simplex * (size_t)(d * d), d, x);
    /* What a difference of coordinates errs by. */
    double e = 0x1p-44 * (far + plane_of->reach) + plane_of->error + error * (1 + far / reach);
    double bound = 16 * e * (d == 3 ? s + e : 1) * (s + t + e) + 0x1p-600;
    return value > bound ? 1 : value < -bound ? -1 : 0;
}

int vertex_off_plane(const corners *plane_of, uint32_t simplex, const control_maps *maps,
                     const double *vertex, double error, double reach) {
    int side = 0, d = maps->dimension;
    for (size_t k = 0; k < maps->count; k++) {
        int here = side_at_control(plane_of, simplex, d, maps->entry + k * (size_t)(d * (d + 1)),
                                   vertex, error, reach);
        if (!here || (k > 0 && here != side))
            return 0;
        side = here;
    }
    return side;
}

/* Are all corners of `simplex` on one side of the plane of `other` all the time? */
static int plane_between(const corners *corners_of, uint32_t simplex, const corners *plane_of,
                         uint32_t other, const control_maps *maps) {
    size_t d = (size_t)maps->dimension;
    const double *at = corners_of->at + simplex * d * d;
    int side = 0;
    for (size_t k = 0; k < d; k++) {
        int here = vertex_off_plane(plane_of, other, maps, at + k * d, corners_of->error,
                                    corners_of->reach);
        if (!here || (k > 0 && here != side))
            return 0;
        side = here;
    }
    return 1;
}

int near_pair_apart(const solid_pair *pair, const motion_stretch *at, near_pair simplices) {
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

static void refine_pair(refiner *r, node_pair p) {
    const tree_node *a = &r->pair->moving->boxes.node[p.moving];
    const tree_node *b = &r->pair->fixed->boxes.node[p.fixed];
    box moved, begun = a->box;
    control_maps_bound(&moved, &r->at->forward, &a->box);
    if (r->status || !box_meets(&moved, &b->box))
        return;
    if (r->at->forward.count)
        box_image(&begun, r->at->forward.entry, r->at->forward.dimension, &a->box);
    double size = box_extent(&begun), other = box_extent(&b->box);
    int leaves = !a->child && !b->child;
    if (leaves && near_pair_apart(r->pair, r->at, (near_pair){a->simplex, b->simplex}))
        return;
    if (!r->at_once && box_extent(&moved) > size + 2 * fmax(size, other)) {
        r->status = node_list_add(r->coarse, r->context, p);
    } else if (leaves) {
        r->status = node_list_add(r->near, r->context, p);
    } else if (a->child && (!b->child || size >= other)) {
        refine_pair(r, (node_pair){a->child, p.fixed});
        refine_pair(r, (node_pair){a->child + 1, p.fixed});
    } else {
        refine_pair(r, (node_pair){p.moving, b->child});
        refine_pair(r, (node_pair){p.moving, b->child + 1});
    }
}

graze_status near_pairs_refine(node_list *near, node_list *coarse, graze_context *context,
                               const solid_pair *pair, const motion_stretch *at,
                               const node_list *in, int at_once) {
    refiner r = {.pair = pair, .at = at, .near = near, .coarse = coarse, .at_once = at_once};
    r.context = context;
    for (size_t k = 0; k < in->count && !r.status; k++) {
        refine_pair(&r, in->item[k]);
        if (!r.status && k % 64 == 0)
            r.status = context_poll(context);
    }
    return r.status;
}
