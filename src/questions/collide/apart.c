/* A separation is proved by the extents along a direction. Any vector may be tried, so directions
 * are chosen that separate often. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/collide/near_pairs.h"

/* Bounds that keep products in the range of doubles. */
#define MOST_BOUND 0x1p950
#define MOST_SLOPE 0x1p200

static double size1(const double *n) {
    return fabs(n[0]) + fabs(n[1]) + fabs(n[2]);
}

/** An extent along a direction. */
typedef struct extent {
    double low, high;
} extent;

static void take_place(extent *e, double x) {
    e->low = smaller(e->low, x);
    e->high = larger(e->high, x);
}

/* A bound of the clearance along n, in units of n. */
static double clearance_along(const double n[3], double most) {
    double length = dot3(n, n);
    return most == 0 ? 0 : most * (length > 0x1p-900 ? sqrt(length) : size1(n)) * (1 + 0x1p-40);
}

/* Are two extents disjoint by more than their errors and the clearance? */
static int extents_apart(extent a, extent b, const double n[3], double error, double most) {
    double bound = size1(n) * error + 0x1p-800 + clearance_along(n, most);
    return bound < MOST_BOUND && (a.low - b.high > bound || b.low - a.high > bound);
}

/* The images of one to three points under some maps: three coordinates each, the third 0 in E^2. */
typedef struct point_group {
    size_t maps;
    int count;
    const double *at; /* maps * count points, map by map */
} point_group;

static const double *run_corner(const corners *of, corner_run run, int k, int d) {
    return of->at + (run.simplex * (size_t)d + (size_t)((run.first + k) % d)) * (size_t)d;
}

static point_group stand(double room[9], const corners *of, corner_run run, int d) {
    for (int k = 0; k < run.count; k++) {
        const double *v = run_corner(of, run, k, d);
        for (int i = 0; i < 3; i++)
            room[3 * k + i] = i < d ? v[i] : 0;
    }
    return (point_group){1, run.count, room};
}

static point_group move(const control_maps *maps, const corners *of, corner_run run) {
    int d = maps->dimension;
    double *out = maps->room;
    for (size_t m = 0; m < maps->count; m++)
        for (int k = 0; k < run.count; k++, out += 3) {
            const double *row = maps->entry + m * (size_t)(d * (d + 1));
            const double *v = run_corner(of, run, k, d);
            out[2] = 0;
            for (int i = 0; i < d; i++, row += d + 1)
                out[i] = row[0] * v[0] + row[1] * v[1] + (d == 3 ? row[2] * v[2] : 0) + row[d];
        }
    return (point_group){maps->count, run.count, maps->room};
}

double error_of_places(const solid_pair *pair, const control_maps *maps) {
    const corners *a = &pair->moving->corners, *b = &pair->fixed->corners;
    double far = maps->shift + maps->slope * a->reach + b->reach;
    if (!a->at || !b->at || !maps->count || maps->slope > MOST_SLOPE || !(far < INFINITY))
        return INFINITY;
    return 0x1p-42 * far + b->error + 2 * maps->slope * a->error + 0x1p-640;
}

static extent group_extent(const point_group *g, const double n[3]) {
    extent e = {INFINITY, -INFINITY};
    const double *x = g->at;
    for (size_t k = 0; k < g->maps * (size_t)g->count; k++, x += 3)
        take_place(&e, dot3(n, x));
    return e;
}

typedef struct divider {
    const point_group *moved, *standing;
    double error, most; /* the bound of the clearance */
} divider;

static int divides(const divider *d, const double n[3]) {
    return extents_apart(group_extent(d->moved, n), group_extent(d->standing, n), n, d->error,
                         d->most);
}

/* Give the edges between a group's points under the middle map. @return their number */
static int edges_of(double out[3][3], const point_group *g) {
    const double *x = g->at + g->maps / 2 * (size_t)(3 * g->count);
    int edges = g->count == 3 ? 3 : g->count - 1;
    for (int k = 0; k < edges; k++)
        for (int i = 0; i < 3; i++)
            out[k][i] = x[3 * ((k + 1) % g->count) + i] - x[3 * k + i];
    return edges;
}

/* Try the directions perpendicular to `normal` and to an edge, for each edge. */
static int divides_in_plane(const divider *d, const double normal[3], double edge[][3], int count) {
    double n[3];
    for (int k = 0; k < count; k++) {
        cross3(n, normal, edge[k]);
        if (divides(d, n))
            return 1;
    }
    return 0;
}

/* Try the normals of the triangles, and the directions perpendicular to an edge of each; set
 * `normal` for divides_in_plane. */
static int divides_in_space(double normal[3], const divider *d, double a[][3], int edges_a,
                            double b[][3], int edges_b) {
    if (edges_b == 3) {
        cross3(normal, b[0], b[1]);
        if (divides(d, normal))
            return 1;
    }
    double n[3];
    if (edges_a == 3) {
        cross3(n, a[0], a[1]);
        if (divides(d, n))
            return 1;
    }
    for (int k = 0; k < edges_a; k++)
        for (int l = 0; l < edges_b; l++) {
            cross3(n, a[k], b[l]);
            if (divides(d, n))
                return 1;
        }
    if (edges_b < 3)
        cross3(normal, a[0], edges_a == 3 ? a[1] : b[0]);
    return 0;
}

/* Give the way from x to the nearest point of the segment from a to b. */
static void way_to_segment(double out[3], const double *x, const double *a, const double *b) {
    double along[3], off[3];
    for (int i = 0; i < 3; i++) {
        along[i] = b[i] - a[i];
        off[i] = x[i] - a[i];
    }
    double length = dot3(along, along), share = dot3(off, along);
    share = share <= 0 ? 0 : share >= length ? 1 : share / length;
    for (int i = 0; i < 3; i++)
        out[i] = share * along[i] - off[i];
}

/* Try the shortest way from a point of one group to a point, or a segment between points, of the
 * other, under the middle map. */
static int divides_nearest(const divider *d) {
    const point_group *g[2] = {d->moved, d->standing};
    double best[3] = {0, 0, 0}, least = INFINITY, way[3];
    for (int side = 0; side < 2; side++) {
        const point_group *own = g[side], *other = g[!side];
        const double *x = own->at + own->maps / 2 * (size_t)(3 * own->count);
        const double *y = other->at + other->maps / 2 * (size_t)(3 * other->count);
        for (int i = 0; i < own->count; i++)
            for (int j = 0; j < other->count; j++) {
                way_to_segment(way, x + 3 * i, y + 3 * j, y + 3 * ((j + 1) % other->count));
                if (dot3(way, way) < least) {
                    least = dot3(way, way);
                    for (int k = 0; k < 3; k++)
                        best[k] = way[k];
                }
            }
    }
    return divides(d, best);
}

int corners_apart(const solid_pair *pair, const control_maps *maps, corner_run moving,
                  corner_run fixed, double error) {
    double room[9], a[3][3], b[3][3], normal[3] = {0, 0, 1};
    if (!(error < INFINITY))
        return 0;
    point_group moved = move(maps, &pair->moving->corners, moving);
    point_group standing = stand(room, &pair->fixed->corners, fixed, maps->dimension);
    divider d = {&moved, &standing, error, maps->most};
    int edges_a = edges_of(a, &moved), edges_b = edges_of(b, &standing);
    if (maps->most > 0 && divides_nearest(&d))
        return 1;
    if (edges_a + edges_b < maps->dimension - 1)
        return 0;
    if (maps->dimension == 3 && divides_in_space(normal, &d, a, edges_a, b, edges_b))
        return 1;
    return divides_in_plane(&d, normal, a, edges_a) || divides_in_plane(&d, normal, b, edges_b);
}

/* A node's box, which has no height in E^2, and the node's slab. */
typedef struct flat_box {
    const box *box;
    const slab *slab;
} flat_box;

/* A bound of the extent along n of the intersection of a box and a slab, from n = share * the
 * slab's normal + rest. */
static extent flat_extent(const flat_box *f, const double n[3]) {
    const double *normal = f->slab->normal;
    double length = dot3(normal, normal), share = length > 0 ? dot3(n, normal) / length : 0;
    double centre = 0, half = 0;
    for (int i = 0; i < 3; i++) {
        double rest = n[i] - share * normal[i];
        centre += rest * (0.5 * f->box->low[i] + 0.5 * f->box->high[i]);
        half += fabs(rest) * (0.5 * f->box->high[i] - 0.5 * f->box->low[i]);
    }
    if (share == 0)
        return (extent){centre - half, centre + half};
    double one = share * f->slab->low, other = share * f->slab->high;
    return (extent){centre - half + smaller(one, other), centre + half + larger(one, other)};
}

/* A bound of the extent along n of the images of a box and slab, from n . (A x + b) = (A^T n) . x +
 * n . b. */
static extent moved_extent(const flat_box *f, const control_maps *maps, const double n[3]) {
    extent all = {INFINITY, -INFINITY};
    int d = maps->dimension;
    for (size_t k = 0; k < maps->count; k++) {
        const double *row = maps->entry + k * (size_t)(d * (d + 1));
        double back[3] = {0, 0, 0}, shift = 0;
        for (int i = 0; i < d; i++, row += d + 1) {
            for (int j = 0; j < d; j++)
                back[j] += n[i] * row[j];
            shift += n[i] * row[d];
        }
        extent one = flat_extent(f, back);
        take_place(&all, one.low + shift);
        take_place(&all, one.high + shift);
    }
    return all;
}

/* Give a normal of the image, under the middle map, of a plane with the normal n. */
static void carry_normal(double out[3], const control_maps *maps, const double n[3]) {
    int d = maps->dimension;
    const double *m = maps->entry + maps->count / 2 * (size_t)(d * (d + 1));
    if (d == 2) {
        out[0] = m[4] * n[0] - m[3] * n[1];
        out[1] = m[0] * n[1] - m[1] * n[0];
        out[2] = 0;
        return;
    }
    for (int i = 0; i < 3; i++) {
        double minor[3];
        cross3(minor, m + 4 * ((i + 1) % 3), m + 4 * ((i + 2) % 3));
        out[i] = dot3(minor, n);
    }
}

/* Do the extents along n separate two nodes? n is 0 for a slab without bounds. */
static int slabs_apart_along(const flat_box *moved, const flat_box *standing,
                             const control_maps *maps, const double n[3], double error) {
    return size1(n) > 0 && extents_apart(moved_extent(moved, maps, n), flat_extent(standing, n), n,
                                         error, maps->most);
}

int slabs_apart(const solid_pair *pair, const control_maps *maps, uint32_t moving, uint32_t fixed,
                double error) {
    const graze_solid *a = pair->moving, *b = pair->fixed;
    const tree_node *m = &a->boxes.node[moving], *f = &b->boxes.node[fixed];
    double carried[3];
    if (!(error < INFINITY))
        return 0;
    flat_box moved = {&m->box, &a->slabs.item[m->child ? m->slab : 0]};
    flat_box standing = {&f->box, &b->slabs.item[f->child ? f->slab : 0]};
    if (slabs_apart_along(&moved, &standing, maps, standing.slab->normal, error))
        return 1;
    carry_normal(carried, maps, moved.slab->normal);
    return slabs_apart_along(&moved, &standing, maps, carried, error);
}
