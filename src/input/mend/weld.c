/* Welds vertices that lie near each other.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Vertices that stay are further than the distance from each other. They lie in a hash table of
 * cells as wide as the distance, so that those within the distance of a point are in the point's
 * cell or a neighbour of it.
 */
#include <math.h>
#include "base/context/scope.h"
#include "base/context/slots.h"
#include "base/number/vector.h"
#include "input/mend/mesh.h"

enum { ENDS_COMPARED = 4096 }; /* each end is compared with all others */

typedef struct welder {
    mesh *m;
    const fmpq *distance;
    fmpq *square;  /* of the distance */
    fmpq *largest; /* largest square of a displacement */
    fmpq *nearest, *length;
    fmpz cell[3];
    slots table;
    uint32_t *stays; /* the vertex of each number in the table */
    uint32_t *to;    /* by vertex: the vertex that takes its place */
    unsigned char *used;
    few welded;
} welder;

static graze_status welder_init(welder *w, mesh *m, const fmpq_t distance) {
    size_t n = m->input->vertex_count;
    fmpq *number = _fmpq_vec_init(4);
    *w = (welder){.m = m,
                  .distance = distance,
                  .square = number,
                  .largest = number + 1,
                  .nearest = number + 2,
                  .length = number + 3};
    fmpq_mul(w->square, distance, distance);
    TRY(MAKE_ARRAY(m->context, w->stays, n + 1, "%zu vertices", n));
    TRY(MAKE_ARRAY(m->context, w->to, n + 1, "%zu vertices", n));
    return MAKE_ARRAY(m->context, w->used, n + 1, "%zu vertices", n);
}

static void welder_clear(welder *w) {
    _fmpq_vec_clear(w->square, 4);
    for (int k = 0; k < 3; k++)
        fmpz_clear(w->cell + k);
    slots_clear(&w->table);
    free(w->stays);
    free(w->to);
    free(w->used);
}

static void find_cell(welder *w, const fmpq *p) {
    for (int k = 0; k < 3; k++) {
        fmpq_div(w->length, p + k, w->distance);
        fmpz_fdiv_q(w->cell + k, fmpq_numref(w->length), fmpq_denref(w->length));
    }
}

/* The hash of the cell that is x, y, z cells beside the welder's cell. */
static uint64_t cell_hash(const welder *w, int x, int y, int z) {
    static const ulong prime = (1UL << 61) - 1;
    const int step[3] = {x, y, z};
    uint64_t hash = 0;
    for (int k = 0; k < 3; k++) {
        ulong rest = fmpz_fdiv_ui(w->cell + k, prime) + prime + (ulong)(slong)step[k];
        hash = slots_mix(hash ^ (rest % prime));
    }
    return hash;
}

static void square_of_distance(fmpq_t out, const fmpq *p, const fmpq *q) {
    LOCAL_VEC(fmpq, way, 3);
    vector_sub(way, p, q, 3);
    _fmpq_vec_dot(out, way, way, 3);
}

/* Let the nearest staying vertex of a cell take the place of v, if it is nearer than those of other
 * cells; of two at one distance the smaller number counts. */
static void look_into_cell(welder *w, uint64_t hash, uint32_t v) {
    size_t at = 0, number;
    while ((number = slots_next(&w->table, hash, &at)) != SLOTS_NONE) {
        uint32_t other = w->stays[number];
        square_of_distance(w->length, mesh_point(w->m, v), mesh_point(w->m, other));
        int nearer = fmpq_cmp(w->length, w->nearest);
        if (nearer < 0 || (!nearer && (w->to[v] == v || other < w->to[v]))) {
            fmpq_swap(w->nearest, w->length);
            w->to[v] = other;
        }
    }
}

static graze_status weld_vertex(welder *w, uint32_t v) {
    find_cell(w, mesh_point(w->m, v));
    fmpq_set(w->nearest, w->square);
    w->to[v] = v;
    for (int k = 0; k < 27; k++)
        look_into_cell(w, cell_hash(w, k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1), v);
    if (w->to[v] != v) {
        few_add(&w->welded, "%u with %u", v, w->to[v]);
        if (fmpq_cmp(w->nearest, w->largest) > 0)
            fmpq_swap(w->nearest, w->largest);
        return GRAZE_OK;
    }
    w->stays[w->table.count] = v;
    return slots_add(&w->table, cell_hash(w, 0, 0, 0))
               ? GRAZE_OK
               : context_fail(w->m->context, GRAZE_ESYSTEM, "out of memory for vertices");
}

/* Report the welded vertices, and that the solid is changed, and by how much. */
static void report_welded(welder *w) {
    char digits[64];
    if (!w->welded.count)
        return;
    LOCAL_MPFR(bound, 53);
    fmpq_get_mpfr(bound, w->largest, MPFR_RNDU);
    mpfr_sqrt(bound, bound, MPFR_RNDU);
    mpfr_snprintf(digits, sizeof digits, "%.2RUe", bound);
    few_report(&w->welded, w->m, "welded", "vertices with one near them");
    text_format(&w->m->report, "the solid is changed: vertices moved by at most %s\n", digits);
}

graze_status weld_vertices(mesh *m, const fmpq_t distance) {
    welder w;
    size_t n = m->input->vertex_count;
    graze_status status = welder_init(&w, m, distance);
    for (size_t k = 0; k < m->now.of.index_count && !status; k++)
        w.used[m->now.of.index[k]] = 1;
    for (uint32_t v = 0; v < n && !status; v++) {
        status = v % 1024 ? GRAZE_OK : context_poll(m->context);
        if (!status && w.used[v])
            status = weld_vertex(&w, v);
    }
    for (size_t k = 0; k < m->now.of.index_count && !status; k++)
        m->now.of.index[k] = w.to[m->now.of.index[k]];
    report_welded(&w);
    welder_clear(&w);
    return status;
}

static double end_distance(const double *p, const double *q) {
    return hypot(hypot(p[0] - q[0], p[1] - q[1]), p[2] - q[2]);
}

/* The largest of all distances from an end to the nearest other one, and of all distances. */
static graze_status measure_ends(double *furthest, double *extent, graze_context *context,
                                 const double *at, size_t count) {
    *furthest = *extent = 0;
    for (size_t k = 0; k < count; k++) {
        double nearest = INFINITY;
        for (size_t j = 0; j < count; j++) {
            double distance = end_distance(at + 3 * k, at + 3 * j);
            nearest = j == k ? nearest : fmin(nearest, distance);
            *extent = fmax(*extent, distance);
        }
        *furthest = fmax(*furthest, nearest);
        TRY(context_poll(context));
    }
    return GRAZE_OK;
}

graze_status weld_advise(mesh *m) {
    uint32_t *end = NULL;
    size_t count = 0;
    double furthest = 0, extent = 0;
    graze_status status = split_open_ends(&end, &count, m);
    double *at = status || count > ENDS_COMPARED ? NULL : malloc((3 * count + 1) * sizeof *at);
    for (size_t k = 0; at && k < 3 * count; k++)
        at[k] = fmpq_get_d(mesh_point(m, end[k / 3]) + k % 3);
    m->report.failed |= !status && count <= ENDS_COMPARED && !at;
    if (at)
        status = measure_ends(&furthest, &extent, m->context, at, count);
    if (furthest > 0 && furthest * 1000 < extent)
        text_format(&m->report,
                    "left %zu ends of open edges, each within about %.2g of another one: a weld "
                    "of %.1e may close the surface\n",
                    count, furthest, 1.1 * furthest);
    free(at);
    free(end);
    return status;
}
