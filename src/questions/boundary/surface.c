/* The surface between `out` and the rest, through one point of each edge between them.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Each cell of the level reached is cut into d! simplices along the diagonal from its lowest to its
 * highest corner, alike in all cells, so that neighbours share the cuts of their common side. Each
 * edge of a simplex from a corner that is out to one that is not has a point of the boundary. One
 * such point on each of these edges gives one segment (d = 2), with `out` on its right, or one or
 * two triangles (d = 3), with `out` on their outer side. Here vertices are the middles of edges;
 * bisect.c moves them along the edges.
 */
#include "questions/boundary/sampling.h"

#include "base/context/array.h"
#include "base/context/scope.h"

/* A simplex's corners; those that are out come last. */
typedef struct corner_simplex {
    uint32_t at[4][3];
    int corners, rest; /* number of corners, and of those that are not out */
} corner_simplex;

static graze_status vertex(size_t *out, graze_context *context, struct graze_boundary *b,
                           const uint32_t at[3]) {
    uint64_t key = lattice_key(at);
    *out = number_index_find(&b->vertices, key);
    if (*out < b->vertices.count || number_index_add(&b->vertices, key, 0))
        return GRAZE_OK;
    return context_fail(context, GRAZE_ESYSTEM, "out of memory for the surface");
}

static int64_t from(const uint32_t a[3], const uint32_t b[3], int k) {
    return (int64_t)b[k] - (int64_t)a[k];
}

/* The side of a face on which `out` lies, as a sign; never 0. Differences within one cell have
 * at most 20 bits. */
static int face_side(uint32_t (*face)[3], const uint32_t out[3], int dimension) {
    const uint32_t *a = face[0], *b = face[1];
    int64_t value;
    if (dimension == 2) {
        value = from(a, b, 0) * from(a, out, 1) - from(a, b, 1) * from(a, out, 0);
    } else {
        const uint32_t *c = face[2];
        value = 0;
        for (int k = 0; k < 3; k++) {
            int i = (k + 1) % 3, j = (k + 2) % 3;
            value +=
                from(a, out, k) * (from(a, b, i) * from(a, c, j) - from(a, b, j) * from(a, c, i));
        }
    }
    return value > 0 ? 1 : -1;
}

/* Add a face of d points, turned so that the point `out` lies on the side of its normal (d = 3), or
 * on its right (d = 2). */
static graze_status add_face(graze_context *context, struct graze_boundary *b, uint32_t (*face)[3],
                             const uint32_t out[3]) {
    size_t d = (size_t)b->dimension, index[3];
    TRY(ARRAY_GROW(context, b->corners, b->corner_capacity, (b->face_count + 1) * d,
                   "the cells of a boundary"));
    for (size_t k = 0; k < d; k++)
        TRY(vertex(index + k, context, b, face[k]));
    int turned = face_side(face, out, b->dimension) != (d == 2 ? -1 : 1);
    size_t *to = b->corners + b->face_count++ * d;
    for (size_t k = 0; k < d; k++)
        to[k] = index[turned ? d - 1 - k : k];
    return GRAZE_OK;
}

static void middle(uint32_t out[3], const corner_simplex *s, int i, int j) {
    for (int k = 0; k < 3; k++)
        out[k] = (s->at[i][k] + s->at[j][k]) / 2;
}

/* Add the faces of one simplex: if r of its corners are not out, their vertices are r (d + 1 - r)
 * middles. */
static graze_status add_faces(graze_context *context, struct graze_boundary *b,
                              const corner_simplex *s) {
    uint32_t point[4][3];
    const uint32_t *out = s->at[s->corners - 1];
    if (s->rest == 0 || s->rest == s->corners)
        return GRAZE_OK;
    if (s->rest == 2 && s->corners == 4) {
        static const int cycle[4][2] = {{0, 2}, {0, 3}, {1, 3}, {1, 2}};
        for (int k = 0; k < 4; k++)
            middle(point[k], s, cycle[k][0], cycle[k][1]);
        TRY(add_face(context, b, point, out));
        for (int k = 0; k < 3; k++) /* the other triangle: 0, 2, 3 */
            point[1][k] = point[0][k];
        return add_face(context, b, point + 1, out);
    }
    int alone = s->rest == 1 ? 0 : s->corners - 1, used = 0;
    for (int k = 0; k < s->corners; k++)
        if (k != alone)
            middle(point[used++], s, alone, k);
    return add_face(context, b, point, out);
}

/* Add the faces of the simplex whose corners go from the cell's lowest to its highest one along the
 * axes in the order `order`. */
static graze_status cut_simplex(graze_context *context, struct graze_boundary *b,
                                const sample_cell *c, const int order[3]) {
    corner_simplex s = {.corners = b->dimension + 1};
    unsigned corner = 0;
    int last = s.corners;
    for (int k = 0; k <= b->dimension; k++) {
        uint64_t key = sample_cell_corner(b, c, corner);
        uint32_t *to = s.at[lattice_known(b, key) == GRAZE_OUT ? --last : s.rest++];
        for (int i = 0; i < 3; i++)
            to[i] = key_coordinate(key, i);
        corner |= k < b->dimension ? 1u << order[k] : 0;
    }
    return add_faces(context, b, &s);
}

/* Has the cell, whose corners are out and not out, a corner on the border of the box that is not
 * out? Then the surface ends there.
 */
static int ends_at_border(const struct graze_boundary *b, const sample_cell *c) {
    uint32_t last = 1u << (b->depth + 1);
    for (unsigned k = 0; k < 1u << b->dimension; k++) {
        uint64_t key = sample_cell_corner(b, c, k);
        for (int i = 0; i < b->dimension; i++) {
            uint32_t at = key_coordinate(key, i);
            if ((at == 0 || at == last) && lattice_known(b, key) != GRAZE_OUT)
                return 1;
        }
    }
    return 0;
}

graze_status boundary_surface(graze_context *context, struct graze_boundary *b) {
    static const int orders[6][3] = {{0, 1, 2}, {1, 0, 2}, {0, 2, 1},
                                     {2, 0, 1}, {1, 2, 0}, {2, 1, 0}};
    int simplices = b->dimension == 2 ? 2 : 6;
    b->closed = 1;
    for (size_t i = 0; i < b->cell_count; i++) {
        const sample_cell *c = b->cells + i;
        if (c->level != b->reached)
            continue;
        if (!sample_cell_mixed(b, c, 0, 0)) {
            b->missed += (unsigned long)sample_cell_has_contact(b, c);
            continue;
        }
        b->closed &= !ends_at_border(b, c);
        if (b->sharp) { /* the faces that are added next belong to the cell's patch */
            TRY(ARRAY_GROW(context, b->patches, b->patch_capacity, b->patch_count + 1,
                           "the cells of a boundary"));
            b->patches[b->patch_count++] = (cell_faces){i, b->face_count};
        }
        for (int k = 0; k < simplices; k++)
            TRY(cut_simplex(context, b, c, orders[k]));
    }
    return GRAZE_OK;
}
