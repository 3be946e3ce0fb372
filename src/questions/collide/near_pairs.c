/* A simultaneous descent of both trees; the moving tree's boxes are replaced by bounds of their
 * images. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <math.h>
#include "base/context/scope.h"
#include "questions/collide/near_pairs.h"

graze_status node_list_add(node_list *list, graze_context *context, node_pair item) {
    TRY(LIST_GROW(context, list, "pairs of boxes"));
    list->item[list->count++] = item;
    return GRAZE_OK;
}

void node_list_clear(node_list *list) {
    free(list->item);
}

void near_list_clear(near_list *list) {
    free(list->item);
}

graze_status near_pairs_take(near_list *out, graze_context *context, const solid_pair *pair,
                             const node_list *leaves) {
    TRY(ARRAY_GROW(context, out->item, out->capacity, leaves->count, "pairs of simplices"));
    out->count = 0;
    for (size_t k = 0; k < leaves->count; k++)
        out->item[out->count++] =
            (near_pair){pair->moving->boxes.node[leaves->item[k].moving].simplex,
                        pair->fixed->boxes.node[leaves->item[k].fixed].simplex};
    return GRAZE_OK;
}

typedef struct refiner {
    const solid_pair *pair;
    const control_maps *maps;
    double error; /* of error_of_places */
    node_list *near, *coarse;
    int at_once;
    graze_context *context;
    graze_status status;
} refiner;

/* A node of the moving tree, with a box around its images during the interval and its size at one
 * time. */
typedef struct moved_node {
    uint32_t node;
    box box;
    double size;
} moved_node;

static void move_node(moved_node *out, const refiner *r, uint32_t node) {
    const control_maps *maps = r->maps;
    box begun = r->pair->moving->boxes.node[node].box;
    out->node = node;
    control_maps_bound(&out->box, maps, &begun);
    if (maps->count)
        box_image(&begun, maps->entry, maps->dimension, &r->pair->moving->boxes.node[node].box);
    out->size = box_extent(&begun);
}

/* Is the distance of two boxes certainly greater than the clearance? */
static int boxes_far(const refiner *r, const box *a, const box *b) {
    double gap[3];
    if (r->maps->most == 0)
        return !box_meets(a, b);
    for (int i = 0; i < 3; i++)
        gap[i] = fmax(0, fmax(a->low[i] - b->high[i], b->low[i] - a->high[i]));
    return sqrt(dot3(gap, gap)) * (1 - 0x1p-48) > r->maps->most;
}

/* Are all points of two boxes certainly nearer than the clearance? */
static int boxes_within(const refiner *r, const box *a, const box *b) {
    double far[3];
    for (int i = 0; i < 3; i++)
        far[i] = fmax(a->high[i] - b->low[i], b->high[i] - a->low[i]);
    return sqrt(dot3(far, far)) * (1 + 0x1p-48) < r->maps->least;
}

static nearness pair_nearness(const refiner *r, uint32_t moving, uint32_t fixed) {
    const tree_node *a = &r->pair->moving->boxes.node[moving];
    const tree_node *b = &r->pair->fixed->boxes.node[fixed];
    int d = r->maps->dimension;
    if (a->child || b->child)
        return slabs_apart(r->pair, r->maps, moving, fixed, r->error) ? NEAR_NEVER : NEAR_UNKNOWN;
    return corners_nearness(r->pair, r->maps, (corner_run){a->simplex, 0, d},
                            (corner_run){b->simplex, 0, d}, r->error);
}

static void refine_pair(refiner *r, const moved_node *moved, uint32_t fixed) {
    const tree_node *a = &r->pair->moving->boxes.node[moved->node];
    const tree_node *b = &r->pair->fixed->boxes.node[fixed];
    if (r->status || r->near->within || boxes_far(r, &moved->box, &b->box))
        return;
    int within = r->maps->least > 0 && boxes_within(r, &moved->box, &b->box);
    nearness found = within ? NEAR_ALWAYS : pair_nearness(r, moved->node, fixed);
    if (found == NEAR_NEVER)
        return;
    r->near->within |= found == NEAR_ALWAYS;
    r->near->soon |= found == NEAR_SOON;
    /* Points have no size, but their clearance has. */
    double other = larger(box_extent(&b->box), 0x1p-4 * r->maps->least);
    if (!r->at_once && box_extent(&moved->box) > moved->size + larger(moved->size, other)) {
        r->status = node_list_add(r->coarse, r->context, (node_pair){moved->node, fixed});
    } else if (!a->child && !b->child) {
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
                               const solid_pair *pair, const control_maps *maps,
                               const node_list *in, int at_once) {
    refiner r = {.pair = pair, .maps = maps, .near = near, .coarse = coarse, .at_once = at_once};
    r.context = context;
    r.error = error_of_places(pair, maps);
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

graze_status near_pairs_find(near_list *out, int *within, const placing *p,
                             const dyadic_interval *interval, const node_list *of) {
    node_pair roots = {0, 0};
    const node_list all = {.count = 1, .item = &roots};
    ZEROED(node_list, leaves);
    ZEROED(control_maps, maps);
    HELD(map_forms, forms, p->map[SIDE_MOVING], interval);
    if (!control_maps_set(&maps, &forms))
        return context_fail(p->context, GRAZE_ESYSTEM, "out of memory for a time of a motion");
    clearance_enclose(&maps, p, interval);
    maps.least = within ? maps.least : 0; /* then none are left out for being nearer */
    TRY(near_pairs_refine(&leaves, NULL, p->context, p->pair, &maps, of ? of : &all, 1));
    if (within)
        *within = leaves.within;
    return near_pairs_take(out, p->context, p->pair, &leaves);
}

graze_status features_near(feature_list *out, placing *p) {
    unsigned zero[2];
    ZEROED(near_list, near);
    ZEROED(feature_list, list);
    TRY(near_pairs_find(&near, NULL, p, &unit_interval, NULL));
    for (int kind = 0; kind < features_end(p); kind++) {
        features_gather(&list, p, &near, kind);
        for (size_t k = 0; k < list.count && !p->status; k++)
            if (features_sign(zero, p, &list.item[k]) <= 0 &&
                PLACING_ROOM(p, out, "pairs of features"))
                out->item[out->count++] = list.item[k];
    }
    return p->status;
}
