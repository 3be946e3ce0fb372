/* A mesh that is judged: any triangles, and the defects that keep them from bounding a solid.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_JUDGE_JUDGED_MESH_H
#define GRAZE_JUDGE_JUDGED_MESH_H

#include "graze/judge.h"
#include "input/solid/corners.h"
#include "input/solid/skin.h"
#include "input/validate/loose.h"

/** The mesh, immutable once made. Vertices at equal positions are one vertex. */
typedef struct judged_mesh {
    const soup *input; /* borrowed; E^3 */
    simplices cut;     /* its triangles but those without area */
    size_t flat_count; /* of triangles without area */
    loose_edges open;  /* the edges that forbid the next better rule */
    graze_mesh_rule rule;
    long least, most; /* of 0 and the winding numbers found beside triangles; GRAZE_MESH_WINDING */
    fmpq_t volume;    /* the integral of the winding number; set for GRAZE_MESH_WINDING, else 0 */
    double *low, *high; /* bounds of the coordinates, as in a solid */
    corners corners;    /* of the triangles, in doubles; `at` is NULL past their range */
    tree boxes;         /* empty if there are no triangles */
} judged_mesh;

/** The mesh's triangles as a skin, which borrows them. */
static inline skin judged_skin(const judged_mesh *m) {
    return (skin){m->input, &m->cut, m->low, m->high, &m->boxes};
}

/** Make a mesh from a soup, which may be empty. Facets with more than three corners are cut into
 * triangles as those of a solid are.
 * @param input of E^3, borrowed as long as the mesh lives
 * @param flags GRAZE_SOLID_TRIANGULATE: facets that are not planar are cut into fans
 * @return GRAZE_EILLEGAL a facet that is not planar or not simple; GRAZE_ELIMIT;
 * GRAZE_ECANCELED; GRAZE_ESYSTEM; GRAZE_EINTERNAL; judged_mesh_clear in any case */
graze_status judged_mesh_make(judged_mesh *out, graze_context *context, const soup *input,
                              unsigned flags);
void judged_mesh_clear(judged_mesh *m);

#endif
