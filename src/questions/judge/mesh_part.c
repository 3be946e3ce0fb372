/* A node is cut into its children, a triangle through the middle of its longest side.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/judge/cube.h"

#include <math.h>
#include <string.h>

/* Bound of the error of a distance, over the error of each of three coordinates: above the root of
 * 3, with rounding. */
static const double WIDER = 1.75;

/* Bound of the rounding error of a distance between points of the mesh. */
static double rounding_of(const judged_mesh *mesh) {
    return WIDER * 4 * UNIT_ROUNDING * mesh->corners.reach;
}

/* Set a triangle's x and radius, and enlarge its error by rounding. */
static void finish_triangle(mesh_part *p, const judged_mesh *mesh) {
    const double *v = p->corner;
    for (int i = 0; i < 3; i++)
        p->x[i] = (v[i] + v[3 + i] + v[6 + i]) / 3;
    p->error += rounding_of(mesh);
    p->radius = 0;
    for (int k = 0; k < 3; k++)
        p->radius = larger(p->radius, distance_above(p->x, v + 3 * k));
    p->radius += p->error + rounding_of(mesh);
}

static void part_of_simplex(mesh_part *out, const judged_mesh *mesh, uint32_t simplex) {
    out->node = PART_OF_TRIANGLE;
    out->simplex = simplex;
    memcpy(out->corner, mesh->corners.at + (size_t)simplex * 9, sizeof out->corner);
    out->error = WIDER * mesh->corners.error;
    finish_triangle(out, mesh);
}

/* Set x to a corner of the mesh near the middle of a node's box: each step goes to the child whose
 * box is nearer to it. */
static void take_middle(mesh_part *out, const judged_mesh *mesh, uint32_t node) {
    const tree_node *all = mesh->boxes.node;
    double middle[3];
    for (int i = 0; i < 3; i++)
        middle[i] = 0.5 * (all[node].box.low[i] + all[node].box.high[i]);
    while (all[node].child) {
        double off[2] = {0, 0};
        for (uint32_t k = 0; k < 2; k++)
            for (int i = 0; i < 3; i++) {
                const box *b = &all[all[node].child + k].box;
                off[k] += fabs(0.5 * (b->low[i] + b->high[i]) - middle[i]);
            }
        node = all[node].child + (off[1] < off[0]);
    }
    const double *corner = mesh->corners.at + (size_t)all[node].simplex * 9, *best = corner;
    for (int k = 1; k < 3; k++)
        if (distance_above(corner + 3 * k, middle) < distance_above(best, middle))
            best = corner + 3 * k;
    memcpy(out->x, best, sizeof out->x);
    out->simplex = all[node].simplex;
}

void mesh_part_of_node(mesh_part *out, const judged_mesh *mesh, uint32_t node) {
    const box *b = &mesh->boxes.node[node].box;
    if (!mesh->boxes.node[node].child) {
        part_of_simplex(out, mesh, mesh->boxes.node[node].simplex);
        return;
    }
    double far[3];
    take_middle(out, mesh, node);
    for (int i = 0; i < 3; i++)
        far[i] = b->high[i] - out->x[i] > out->x[i] - b->low[i] ? b->high[i] : b->low[i];
    out->node = node;
    out->error = WIDER * mesh->corners.error;
    out->radius = distance_above(out->x, far) + rounding_of(mesh);
}

static void cut_triangle(mesh_part out[2], const judged_mesh *mesh, const mesh_part *whole) {
    int longest = 0;
    double length[3];
    for (int k = 0; k < 3; k++) {
        length[k] = distance_above(whole->corner + 3 * k, whole->corner + 3 * ((k + 1) % 3));
        if (length[k] > length[longest])
            longest = k;
    }
    int next = (longest + 1) % 3;
    for (int part = 0; part < 2; part++) {
        out[part] = *whole;
        for (int i = 0; i < 3; i++)
            out[part].corner[3 * (part ? longest : next) + i] =
                0.5 * (whole->corner[3 * longest + i] + whole->corner[3 * next + i]);
        finish_triangle(&out[part], mesh);
    }
}

void mesh_part_cut(mesh_part out[2], const judged_mesh *mesh, const mesh_part *whole) {
    if (whole->node == PART_OF_TRIANGLE) {
        cut_triangle(out, mesh, whole);
        return;
    }
    uint32_t child = mesh->boxes.node[whole->node].child;
    for (uint32_t k = 0; k < 2; k++)
        mesh_part_of_node(&out[k], mesh, child + k);
}
