/* Finds the rule that gives a mesh an inside, and the volume of the mesh.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/judge/open_search.h"

#include "base/context/scope.h"
#include "base/number/vector.h"

/* Add six times the signed volume of the tetrahedron of the origin and a triangle. */
static void add_tetrahedron(fmpq_t sum, const skin *s, size_t simplex) {
    const fmpq *p[3];
    LOCAL_VEC(fmpq, normal, 4);
    skin_vertices(p, s, simplex);
    vector_cross(normal, p[1], p[2]);
    _fmpq_vec_dot(normal + 3, p[0], normal, 3);
    fmpq_add(sum, sum, normal + 3);
}

/* Add tetrahedra by halves: sums of few terms have short denominators. */
static void add_tetrahedra(fmpq_t sum, const skin *s, size_t first, size_t count) {
    if (count <= 1) {
        if (count)
            add_tetrahedron(sum, s, first);
        return;
    }
    LOCAL(fmpq, half);
    add_tetrahedra(sum, s, first, count / 2);
    add_tetrahedra(half, s, first + count / 2, count - count / 2);
    fmpq_add(sum, sum, half);
}

graze_status judged_mesh_make(judged_mesh *out, graze_context *context, const soup *input,
                              unsigned flags) {
    memset(out, 0, sizeof *out);
    out->input = input;
    fmpq_init(out->volume);
    TRY(validate_loose(&out->cut, &out->open, &out->flat_count, context, input, flags));
    TRY(skin_bounds(&out->low, &out->high, context, input));
    skin bare = judged_skin(out);
    TRY(skin_tree(&out->boxes, context, &bare));
    TRY(corners_make(&out->corners, context, input, &out->cut, out->low, out->high));
    out->rule = out->open.odd_count          ? GRAZE_MESH_NONE
                : out->open.unbalanced_count ? GRAZE_MESH_PARITY
                                             : GRAZE_MESH_WINDING;
    if (out->rule == GRAZE_MESH_WINDING) {
        /* The integral of the winding number is the sum of the signed tetrahedra that the origin
         * makes with the triangles (proofs/mesh.md C115). */
        skin all = judged_skin(out);
        add_tetrahedra(out->volume, &all, 0, out->cut.count);
        fmpq_div_fmpz(out->volume, out->volume, (fmpz[]){6});
    }
    return context_poll(context);
}

void judged_mesh_clear(judged_mesh *m) {
    simplices_clear(&m->cut);
    corners_clear(&m->corners);
    tree_clear(&m->boxes);
    free(m->low);
    free(m->high);
    fmpq_clear(m->volume);
}
