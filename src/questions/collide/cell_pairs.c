/* The mean of some corners of a common part lies on exactly the sides that hold all of these
 * corners; each pair of cells that meet contains such a mean.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/context/scope.h"
#include "questions/collide/near_pairs.h"

/** The sides that hold a point: three bits for the moving simplex, then three for the fixed one. */
typedef unsigned side_mask;
enum { SIDE_MASKS = 64, FIXED_SHIFT = 3 };

/* Mark the mask of a corner and those of its means with others: masks are closed under
 * intersection. */
static void close_masks(unsigned char held[SIDE_MASKS], const unsigned zero[2]) {
    side_mask corner = zero[0] | zero[1] << FIXED_SHIFT;
    for (side_mask m = 0; m < SIDE_MASKS; m++)
        if (held[m])
            held[m & corner] = 1;
    held[corner] = 1;
}

/* Mark the masks of the means of all sets of common points. */
static void hold_common(unsigned char held[SIDE_MASKS], placing *p, near_pair simplices) {
    common_points found;
    common_points_find(&found, p, simplices);
    for (int k = 0; k < found.count && !p->status; k++)
        close_masks(held, found.item[k].zero);
}

/* Mark the masks of the means of all sets of pairs of points at the clearance. */
static void hold_near(unsigned char held[SIDE_MASKS], placing *p, near_pair simplices) {
    ZEROED(feature_list, list);
    unsigned zero[2];
    for (int k = features_first(p); k < features_end(p); k++)
        features_add(&list, p, simplices, k, 1);
    for (size_t k = 0; k < list.count && !p->status; k++)
        if (features_sign(zero, p, &list.item[k]) == 0)
            close_masks(held, zero);
}

/* Append the pairs of all names that the input has for two cells. */
static void add_names(cell_pairs *out, placing *p, near_pair simplices, side_mask mask) {
    const graze_solid *a = p->pair->moving, *b = p->pair->fixed;
    graze_cell moving = solid_cell(a, simplices.moving, mask & 7);
    graze_cell fixed = solid_cell(b, simplices.fixed, mask >> FIXED_SHIFT);
    size_t m, n;
    const graze_cell *first = cell_names_of(&m, &a->cut.names, &moving);
    const graze_cell *second = cell_names_of(&n, &b->cut.names, &fixed);
    for (size_t i = 0; i < m; i++)
        for (size_t j = 0; j < n; j++)
            if (PLACING_ROOM(p, out, "pairs of cells"))
                out->item[out->count++] = (graze_cell_pair){first[i], second[j]};
}

static int compare_cell_pairs(const void *left, const void *right) {
    const graze_cell_pair *a = left, *b = right;
    int order = cell_compare(&a->moving, &b->moving);
    return order ? order : cell_compare(&a->fixed, &b->fixed);
}

void cell_pairs_find(cell_pairs *out, placing *p, const near_list *near) {
    for (size_t k = 0; k < near->count && !p->status; k++) {
        unsigned char held[SIDE_MASKS] = {0};
        (p->near ? hold_near : hold_common)(held, p, near->item[k]);
        for (side_mask m = 0; m < SIDE_MASKS && !p->status; m++)
            if (held[m])
                add_names(out, p, near->item[k], m);
    }
    out->count = array_sort_once(out->item, out->count, sizeof *out->item, compare_cell_pairs);
}
