/* Gathers the edges of a flat solid's facets into cycles, and facets with their holes.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <math.h>
#include "base/context/scope.h"
#include "input/planar/walk.h"
#include "input/read/read.h"

/* Closed paths without a vertex that stands twice in one. */
typedef struct flat_paths {
    numbers vertex; /* of all paths */
    numbers size;
} flat_paths;

static void flat_paths_clear(flat_paths *p) {
    numbers_clear(&p->vertex);
    numbers_clear(&p->size);
}

/* Move the path's part behind the place at which its last vertex stood before to `out`. */
static graze_status close_path(flat_paths *out, graze_context *context, numbers *path, size_t begin,
                               size_t *place) {
    for (size_t k = begin; k < path->count; k++) {
        TRY(numbers_add(&out->vertex, context, path->item[k], "the facets of a solid"));
        place[path->item[k]] = 0;
    }
    TRY(numbers_add(&out->size, context, path->count - begin, "the facets of a solid"));
    path->count = begin;
    return GRAZE_OK;
}

/* Append the paths of some edges. There are places for all vertices, 0 before and after the call.
 */
static graze_status find_paths(flat_paths *out, graze_context *context, const flat_edge *edges,
                               size_t count, size_t *place) {
    ZEROED(numbers, path);
    FREED(char, used, NULL);
    TRY(MAKE_ARRAY(context, used, count, "%zu edges", count));
    for (size_t k = 0; k < count; k++) {
        size_t at = k;
        /* Each vertex has as many edges from it as to it, so a path ends where it began. */
        while (at < count && !used[at]) {
            const flat_edge *e = &edges[at];
            used[at] = 1;
            TRY(numbers_add(&path, context, e->from, "the facets of a solid"));
            place[e->from] = path.count;
            if (place[e->to])
                TRY(close_path(out, context, &path, place[e->to] - 1, place));
            at = array_first(&(flat_edge){.from = e->to}, edges, count, sizeof *edges,
                             flat_from_order);
            while (at < count && used[at] && edges[at].from == e->to)
                at++;
            if (at < count && edges[at].from != e->to)
                break;
        }
    }
    return path.count == 0 ? GRAZE_OK
                           : context_fail(context, GRAZE_EINTERNAL,
                                          "the edges of a facet do not close: please report it");
}

/* Add the facets that some edges bound, which lie in one plane and are sorted by `from`. */
static graze_status add_plane_facets(soup *out, flat_walk *w, const flat_edge *edges, size_t count,
                                     size_t *place) {
    ZEROED(flat_paths, paths);
    int axis[2] = {0, 1};
    if (w->dimension == 3) {
        const fmpz *form = w->form + 4 * edges->plane;
        int drop = 0;
        while (fmpz_is_zero(form + drop))
            drop++;
        int back = fmpz_sgn(form + drop) != edges->facing;
        axis[back] = (drop + 1) % 3;
        axis[!back] = (drop + 2) % 3;
    }
    TRY(find_paths(&paths, w->context, edges, count, place));
    return nesting_add_rings(out, w->context, paths.size.item, paths.size.count, paths.vertex.item,
                             axis);
}

graze_status flat_facets(soup *out, flat_walk *w) {
    ZEROED(flat_edges, edges);
    ZEROED(flat_points, points);
    TRY(flat_edges_find(&edges, &points, w));
    FREED(size_t, place, NULL);
    TRY(MAKE_ARRAY(w->context, place, points.vertices + 1, "%zu vertices", points.vertices));
    for (size_t v = 0; v < points.vertices; v++)
        TRY(soup_add_vertex(out, w->context, points.at + 3 * points.first[v]));
    for (size_t k = 0, end; k < edges.count; k = end) {
        end = w->dimension == 2 ? edges.count : flat_facet_end(&edges, k);
        if (w->dimension == 2)
            qsort(edges.item, edges.count, sizeof *edges.item, flat_from_order);
        TRY(add_plane_facets(out, w, edges.item + k, end - k, place));
    }
    return GRAZE_OK;
}

/* Find a box in doubles around that of the solid, or around the sides that were added; returns 0 if
 * there is none that search takes. */
static int find_box(double *low, double *high, const flat_walk *w, const csg *solid) {
    double reach = 0;
    for (int i = 0; i < w->dimension; i++) {
        if (solid->box.dimension) {
            low[i] = fmpq_get_d(&solid->box.low[i]);
            high[i] = fmpq_get_d(&solid->box.high[i]);
        } else {
            high[i] = fmpz_get_d(w->form + 4 * (w->plane_count - 2) + 3);
            low[i] = -high[i];
        }
        reach = fmax(reach, fmax(fabs(low[i]), fabs(high[i])));
    }
    for (int i = 0; i < w->dimension; i++) {
        low[i] -= 0x1p-10 * reach;
        high[i] += 0x1p-10 * reach;
    }
    return reach < 0x1p890;
}

graze_status planar_soup(soup *out, csg_form *form, graze_context *context, const csg *solid) {
    ZEROED(flat_walk, w);
    double low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
    soup_init(out, solid->dimension);
    TRY(flat_walk_begin(&w, context, solid));
    *form = CSG_WIDE;
    if (!find_box(low, high, &w, solid))
        return GRAZE_OK;
    TRY(flat_walk_box(&w, low, high));
    *form = w.unbounded ? CSG_UNBOUNDED : w.pieces.count == 0 ? CSG_EMPTY : CSG_FACETS;
    return *form == CSG_FACETS ? flat_facets(out, &w) : GRAZE_OK;
}
