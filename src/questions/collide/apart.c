/* A separation is proved by the extents along a direction. Any vector may be tried, so directions
 * are chosen that separate often. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/collide/near_pairs.h"

/* Bounds that keep products in the range of doubles. */
#define MOST_BOUND 0x1p950
#define MOST_SLOPE 0x1p200

/* Places that are nearer under the middle map, and this many clearances away under the others, soon
 * are nearer under all: each halving of the interval halves their ways. */
#define SOON_WITHIN 16

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
    return most == 0 ? 0 : most * (length > 0x1p-900 ? sqrt(length) : size1(n));
}

/* Are two extents disjoint by more than their errors and the clearance? */
static inline int extents_apart(extent a, extent b, const double n[3], double error, double most) {
    double gap = larger(a.low - b.high, b.low - a.high);
    if (!(gap > 0))
        return 0;
    double bound = size1(n) * error + 0x1p-800 + clearance_along(n, most);
    return bound < MOST_BOUND && gap > bound;
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
    return 0x1p-42 * far + 0x1p-530; /* corners err by far less */
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

/* Two points that are nearly nearest under the middle map: corner `at` of one group, of those that
 * stand if `side` is 1, and that share of the way from corner `along` of the other to its next. */
typedef struct near_places {
    int side, at, along;
    double share, way[3];
} near_places;

/* A corner of a group under a map; a group that stands has one map. */
static const double *place_of_corner(const point_group *g, size_t map, int corner) {
    return g->at + 3 * (map % g->maps * (size_t)g->count + (size_t)(corner % g->count));
}

/* Give the way from one of two places to the other under a map. */
static void way_between(double out[3], const divider *d, const near_places *n, size_t map) {
    const point_group *own = n->side ? d->standing : d->moved;
    const point_group *other = n->side ? d->moved : d->standing;
    const double *x = place_of_corner(own, map, n->at);
    const double *a = place_of_corner(other, map, n->along);
    const double *b = place_of_corner(other, map, n->along + 1);
    for (int i = 0; i < 3; i++)
        out[i] = a[i] - x[i] + n->share * (b[i] - a[i]);
}

/* Set the share at which a segment is nearest to the other place under a map, and the way there. */
static void go_nearest(near_places *n, const divider *d, size_t map) {
    double off[3], end[3], along[3];
    n->share = 0;
    way_between(off, d, n, map);
    n->share = 1;
    way_between(end, d, n, map);
    for (int i = 0; i < 3; i++)
        along[i] = end[i] - off[i];
    double length = dot3(along, along), part = -dot3(off, along);
    n->share = part <= 0 ? 0 : part >= length ? 1 : part / length;
    way_between(n->way, d, n, map);
}

/* Find the shortest way from a corner of one group to a corner, or a segment between corners, of
 * the other. */
static near_places find_nearest(const divider *d) {
    near_places best = {.way = {INFINITY}}, n = {0};
    for (n.side = 0; n.side < 2; n.side++)
        for (n.at = 0; n.at < (n.side ? d->standing : d->moved)->count; n.at++)
            for (n.along = 0; n.along < (n.side ? d->moved : d->standing)->count; n.along++) {
                go_nearest(&n, d, d->moved->maps / 2);
                if (dot3(n.way, n.way) < dot3(best.way, best.way))
                    best = n;
            }
    return best;
}

/* Are two places nearer than the clearance under all maps? If not, are they under the middle one,
 * so that they will be in a few halves of the interval? */
static nearness nearness_of(const divider *d, const near_places *n, double least) {
    double bound = 2 * d->error, middle = sqrt(dot3(n->way, n->way)), way[3];
    int within = 1, soon = middle + bound < least / 2;
    for (size_t map = 0; map < d->moved->maps; map++) {
        way_between(way, d, n, map);
        double length = sqrt(dot3(way, way)) + bound;
        within &= length < least;
        soon &= length < SOON_WITHIN * least;
    }
    return within ? NEAR_ALWAYS : soon ? NEAR_SOON : NEAR_UNKNOWN;
}

nearness corners_nearness(const solid_pair *pair, const control_maps *maps, corner_run moving,
                          corner_run fixed, double error) {
    double room[9], a[3][3], b[3][3], normal[3] = {0, 0, 1};
    if (!(error < INFINITY))
        return NEAR_UNKNOWN;
    point_group moved = move(maps, &pair->moving->corners, moving);
    point_group standing = stand(room, &pair->fixed->corners, fixed, maps->dimension);
    divider d = {&moved, &standing, error, maps->most};
    int edges_a = edges_of(a, &moved), edges_b = edges_of(b, &standing);
    nearness found = NEAR_UNKNOWN;
    if (maps->most > 0) {
        near_places n = find_nearest(&d);
        found = divides(&d, n.way) ? NEAR_NEVER : nearness_of(&d, &n, maps->least);
    }
    if (found || edges_a + edges_b < maps->dimension - 1)
        return found;
    if ((maps->dimension == 3 && divides_in_space(normal, &d, a, edges_a, b, edges_b)) ||
        divides_in_plane(&d, normal, a, edges_a) || divides_in_plane(&d, normal, b, edges_b))
        return NEAR_NEVER;
    return NEAR_UNKNOWN;
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
