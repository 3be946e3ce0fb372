/* Marching squares whose nodes are bisected, or interpolated between distances.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/draw/views.h"

#include "base/context/array.h"
#include "base/context/scope.h"

/* The grid of cells, surrounded by two rings of cells: the inner ring, from (1, 1) on, repeats its
 * neighbours in the grid, and the outer ring is outside the region. */
typedef struct marching {
    graze_context *context;
    const graze_scene *scene; /* NULL: the region of distances below `level` */
    const cells *cells;
    const panel *at;
    tone least;
    double level;
    size_t parts; /* steps of bisection between two centres */
    graze_status status;
} marching;

static int in_region(const marching *m, tone t) {
    return t >= m->least && t != TONE_EXTERIOR && t != TONE_OUT && t < TONE_OUTER;
}

/* The index, on an axis of the grid, of the cell nearest to index i of the grid with its rings. */
static size_t nearest(const marching *m, int axis, size_t i) {
    size_t count = m->cells->count[axis];
    return i < 2 ? 0 : i < count + 2 ? i - 2 : count - 1;
}

static size_t cell_at(const marching *m, size_t i, size_t j) {
    return nearest(m, 1, j) * m->cells->count[0] + nearest(m, 0, i);
}

static int is_centre_in(const marching *m, size_t i, size_t j) {
    const cells *c = m->cells;
    size_t cell = cell_at(m, i, j);
    return i && j && i < c->count[0] + 3 && j < c->count[1] + 3 &&
           (m->scene ? in_region(m, (tone)c->tone[cell]) : c->distance[cell] < m->level);
}

/* Is the point in the region that is off a centre by (u, v) / parts of a cell? */
static int is_point_in(marching *m, size_t i, size_t j, size_t u, size_t v) {
    tone found = TONE_NONE;
    size_t x = (2 * nearest(m, 0, i) + 1) * m->parts + 2 * u;
    size_t y = (2 * nearest(m, 1, j) + 1) * m->parts + 2 * v;
    if (!m->status && m->scene)
        m->status = cells_ask(&found, m->cells, m->context, m->scene, 2 * m->parts, x, y);
    return in_region(m, found);
}

/* The node between a centre and the centre on the right or, if `up`, above, as a share of the way
 * between them; -1 if there is none. */
static double find_node(marching *m, size_t i, size_t j, size_t up) {
    int from = is_centre_in(m, i, j);
    size_t low = 0, high = m->parts;
    if (from == is_centre_in(m, i + !up, j + up))
        return -1;
    size_t cell = cell_at(m, i, j), next = cell_at(m, i + !up, j + up);
    const double *distance = m->cells->distance;
    if (cell == next)
        return .5; /* off the frame */
    if (!m->scene)
        return (m->level - distance[cell]) / (distance[next] - distance[cell]);
    while (high - low > 1) {
        size_t middle = (low + high) / 2;
        int same = from == is_point_in(m, i, j, !up * middle, up * middle);
        *(same ? &low : &high) = middle;
    }
    return (double)(low + high) / 2 / (double)m->parts;
}

/* Add the segments of the square whose lower left corner is a centre, and return their number. Side
 * 0 is the lower one, the others follow counterclockwise; node k is on side k. */
static size_t march_square(chain_segment *out, marching *m, size_t i, size_t j) {
    const double node[4] = {find_node(m, i, j, 0), find_node(m, i + 1, j, 1),
                            find_node(m, i, j + 1, 0), find_node(m, i, j, 1)};
    double size = m->at->width / (double)m->cells->count[0];
    size_t side[5] = {0}, found = 0;
    for (size_t k = 0; k < 4; k++)
        if (node[k] >= 0)
            side[found++] = k;
    size_t turn =
        found == 4 && is_centre_in(m, i, j) != is_point_in(m, i, j, m->parts / 2, m->parts / 2);
    for (size_t k = 0; k < found; k++) {
        size_t s = side[k + turn], up = s % 2, u = i + (s == 1), v = j + (s == 2);
        chain_segment *segment = &out[k / 2];
        segment->key[k % 2] = (v * (m->cells->count[0] + 4) + u) * 2 + up;
        segment->x[k % 2] = m->at->x + size * ((double)u - 1.5 + (up ? 0 : node[s]));
        segment->y[k % 2] =
            m->at->y + m->at->height - size * ((double)v - 1.5 + (up ? node[s] : 0));
    }
    return found / 2;
}

graze_status contour_path(drawn_path *out, graze_context *context, const graze_scene *scene,
                          const cells *c, const panel *p, tone least, double level) {
    marching m = {context, scene, c, p, least, level, 2, GRAZE_OK};
    FREED(chain_segment, segments, NULL);
    size_t room = 0, count = 0, across = c->count[0] + 3, squares = across * (c->count[1] + 3);
    while ((double)m.parts * (double)c->count[0] < CONTOUR_FINENESS * p->width)
        m.parts *= 2;
    for (size_t k = 0; k < squares && !out->failed && !m.status; k++) {
        out->failed |= !array_reserve(&segments, &room, count + 2, sizeof *segments);
        if (!out->failed)
            count += march_square(segments + count, &m, k % across, k / across);
        m.status = m.status || k % across ? m.status : context_poll(context);
    }
    if (!out->failed && !m.status)
        chain_path(out, segments, count, 0);
    return m.status;
}
