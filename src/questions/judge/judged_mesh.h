/* A mesh that is judged: triangles of which nothing is assumed, and what they lack.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_JUDGE_JUDGED_MESH_H
#define GRAZE_JUDGE_JUDGED_MESH_H

#include "graze/judge.h"
#include "input/solid/corners.h"
#include "input/solid/skin.h"
#include "input/validate/loose.h"

/** Immutable once made. Positions count, not vertex numbers: equal vertices are one. */
typedef struct judged_mesh {
    const soup *input; /* borrowed; E^3 */
    simplices cut;     /* triangles; those without area are left out, and counted */
    size_t flat_count;
    loose_edges open; /* the edges that forbid the next better rule */
    graze_mesh_rule rule;
    long least, most;   /* winding numbers found beside triangles, and 0; GRAZE_MESH_WINDING */
    fmpq_t volume;      /* the integral of the winding number; set for GRAZE_MESH_WINDING, else 0 */
    double *low, *high; /* bounds of the coordinates, as in a solid */
    corners corners;    /* of the triangles, in doubles; `at` is NULL past their range */
    tree boxes;         /* none where there are no triangles */
} judged_mesh;

/** The mesh's triangles, as searches take them; borrowed. */
static inline skin judged_skin(const judged_mesh *m) {
    return (skin){m->input, &m->cut, m->low, m->high, &m->boxes};
}

/**
 * Take a mesh's triangles. Facets of more corners are cut as the validation cuts those of a solid;
 * a mesh may be empty.
 * @param input of E^3, borrowed as long as the mesh lives
 * @param flags GRAZE_SOLID_TRIANGULATE: facets that are not planar are cut into fans
 * @return GRAZE_EILLEGAL a facet that is not planar or not simple; GRAZE_ELIMIT;
 * GRAZE_ECANCELED; GRAZE_ESYSTEM; GRAZE_EINTERNAL; judged_mesh_clear in any case
 */
graze_status judged_mesh_make(judged_mesh *out, graze_context *context, const soup *input,
                              unsigned flags);
void judged_mesh_clear(judged_mesh *m);

#endif
