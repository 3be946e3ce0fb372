/* Mends a mesh, step by step.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/mend/mesh.h"

#include "base/context/scope.h"

/* Make a solid of the mesh as it is now. */
static graze_status try_mesh(graze_solid **out, const mesh *m, unsigned flags) {
    soup input;
    if (!m->now.of.cycle_count)
        return context_fail(m->context, GRAZE_EILLEGAL,
                            "no facet has an area; expected a closed boundary");
    TRY(mesh_soup(&input, m, NULL, 0, NULL));
    return solid_create(out, m->context, &input, flags);
}

static graze_status mend_mesh(graze_solid **out, mesh *m, unsigned flags, const fmpq *weld) {
    TRY(clean_vertices(m));
    if (weld)
        TRY(weld_vertices(m, weld));
    TRY(clean_facets(m));
    TRY(split_edges(m));
    graze_status status = try_mesh(out, m, flags);
    if (status != GRAZE_EILLEGAL || !m->now.of.cycle_count)
        return status;
    if (!weld)
        TRY(weld_advise(m));
    TRY(orient_facets(m, flags));
    return try_mesh(out, m, flags);
}

graze_status mend_solid(graze_solid **out, text *report, graze_context *context, soup *input,
                        unsigned flags, const fmpq *weld) {
    mesh m;
    *out = NULL;
    graze_status status = mesh_init(&m, context, input);
    if (!status)
        status = mend_mesh(out, &m, flags, weld);
    text_bytes(report, m.report.data ? m.report.data : "", m.report.length);
    report->failed |= m.report.failed;
    mesh_clear(&m);
    soup_clear(input);
    return status;
}
