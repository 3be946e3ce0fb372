/* The nearest place of a triangle is a guess; weak duality makes it certain.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/judge/cube.h"

#include <math.h>
#include "questions/distance/distance.h"

typedef struct gap_search {
    const judged_mesh *mesh;
    stance from;
    double slop; /* what errs: corners, places between them, differences of coordinates */
    mesh_gap found;
} gap_search;

static void begin_gap(gap_search *s, const judged_mesh *mesh, const double *point) {
    *s = (gap_search){.mesh = mesh,
                      .from = {.rigid = 1, .dimension = 3},
                      .found = {INFINITY, INFINITY, UINT32_MAX}};
    for (int i = 0; i < 3; i++)
        s->from.c[i] = point[i];
    s->slop =
        2 * (mesh->corners.error + 64 * UNIT_ROUNDING * (mesh->corners.reach + largest3(point)));
}

/* How far the point is from the plane across m that bounds the triangle: no more than the distance.
 */
static double gap_across(const double *m, const double *point, const double *corner) {
    double least = INFINITY, length = sqrt(dot3(m, m));
    for (int k = 0; k < 3; k++) {
        double off[3];
        for (int i = 0; i < 3; i++)
            off[i] = point[i] - corner[3 * k + i];
        least = smaller(least, dot3(m, off));
    }
    return length > 0 ? least / length : 0;
}

static void gap_to_triangle(gap_search *s, uint32_t simplex) {
    const double *corner = s->mesh->corners.at + (size_t)simplex * 9;
    foot at;
    foot_find(&at, &s->from, corner);
    double high = distance_above(s->from.c, at.q) + s->slop;
    double low = larger(gap_across(at.m, s->from.c, corner) - s->slop, 0);
    s->found.low = smaller(s->found.low, low);
    if (high < s->found.high) {
        s->found.high = high;
        s->found.simplex = simplex;
    }
}

static double gap_to_box(const gap_search *s, const box *b) {
    double g[3];
    return sqrt(foot_of_box(g, &s->from, b)) - s->slop;
}

static void gap_to_node(gap_search *s, uint32_t index) {
    for (;;) {
        const tree_node *node = &s->mesh->boxes.node[index];
        if (!(gap_to_box(s, &node->box) < s->found.high))
            return;
        if (!node->child) {
            gap_to_triangle(s, node->simplex);
            return;
        }
        uint32_t near = node->child, far = near + 1;
        if (gap_to_box(s, &s->mesh->boxes.node[far].box) <
            gap_to_box(s, &s->mesh->boxes.node[near].box)) {
            near = far;
            far = node->child;
        }
        gap_to_node(s, near);
        index = far;
    }
}

mesh_gap mesh_gap_of(const judged_mesh *mesh, const double *point) {
    gap_search s;
    begin_gap(&s, mesh, point);
    if (mesh->boxes.node_count)
        gap_to_node(&s, 0);
    s.found.low = smaller(s.found.low, s.found.high);
    return s.found;
}

double mesh_gap_of_cube(const judged_mesh *mesh, uint32_t simplex, const double *centre,
                        double half) {
    double most = 0;
    for (int k = 0; k < 8; k++) {
        gap_search s;
        double corner[3];
        for (int i = 0; i < 3; i++)
            corner[i] = centre[i] + (k >> i & 1 ? half : -half);
        begin_gap(&s, mesh, corner);
        gap_to_triangle(&s, simplex);
        most = larger(most, s.found.high);
    }
    return most;
}
