/* The public functions of boundaries by sampling.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "api/api.h"

#include "base/context/team.h"
#include "questions/boundary/boundary.h"

/* Take the caller's box over as rationals; without a box nothing is set. */
static graze_status take_box(fmpq *low, fmpq *high, graze_context *context, int dimension,
                             const graze_boundary_options *o) {
    for (int k = 0; o->low && k < dimension; k++) {
        graze_status status = api_rational(low + k, context, o->low[k]);
        if (!status)
            status = api_rational(high + k, context, o->high[k]);
        TRY(api_coordinate(context, status, NULL, 0, (size_t)k));
    }
    return GRAZE_OK;
}

graze_status graze_boundary_create(graze_boundary **out, graze_context *context,
                                   const graze_scene *scene,
                                   const graze_boundary_options *options) {
    EMPTY(out);
    REFUSED(!out || !context || !scene || !options, "no argument may be NULL");
    graze_boundary_options o;
    TRY(api_options(&o, sizeof o, context, "graze_boundary_create", options));
    REFUSED(!o.low != !o.high, "low and high must both be given or both be NULL");
    REFUSED(o.depth > BOUNDARY_DEPTH || o.coarse > o.depth,
            "the depth is at most 19, and the coarse level at most the depth");
    REFUSED(o.middles && o.sharp, "middles and sharp must not both be given");
    REFUSED(o.threads < 0 || o.threads > TEAM_MOST, "the threads are 0 to 1024");
    TRY(api_takes(context, "graze_boundary_create", scene->solid));
    IN_ENVIRONMENT();
    LOCAL_VEC(fmpq, low, 3);
    LOCAL_VEC(fmpq, high, 3);
    TRY(take_box(low, high, context, scene->motion->dimension, &o));
    CREATE(out, made, graze_boundary_destroy,
           boundary_make(made, context, scene, &o, o.low ? low : NULL, o.low ? high : NULL));
}

DESTROYER(graze_boundary, boundary_clear(of))

graze_boundary_summary graze_boundary_summarize(const graze_boundary *b) {
    graze_boundary_summary out = {0};
    if (!b)
        return out;
    out.points = b->points.count;
    out.cells = b->leaf_count;
    out.vertices = bisect_count(b);
    out.faces = b->face_count;
    out.in = b->known[GRAZE_IN];
    out.on = b->known[GRAZE_ON];
    out.out = b->known[GRAZE_OUT];
    out.contacts = b->asked;
    out.contacts_on = b->contact_count;
    out.missed = b->missed;
    out.level = b->reached;
    out.complete = b->complete;
    out.closed = b->closed;
    for (int t = 0; t < b->threads; t++)
        out.bisected += b->askers[t].asked;
    out.exact = b->exact;
    out.features = b->feature_count;
    return out;
}

graze_pmc graze_boundary_point(mpq_t *point, const graze_boundary *b, size_t index) {
    if (!point || !b || index >= b->points.count)
        return GRAZE_PMC_NONE;
    LOCAL_VEC(fmpq, at, b->dimension);
    lattice_point(at, b, b->points.key[index]);
    api_point_out(point, at, b->dimension);
    return (graze_pmc)b->points.value[index];
}

graze_boundary_cell graze_boundary_cell_at(const graze_boundary *b, size_t index) {
    graze_boundary_cell out = {0};
    if (!b || index >= b->leaf_count)
        return out;
    const sample_cell *c = b->cells + b->leaves[index];
    int mixed = 0;
    out.level = c->level;
    for (unsigned k = 0; k < 1u << b->dimension; k++) {
        out.corners[k] = number_index_find(&b->points, sample_cell_corner(b, c, k));
        graze_pmc pmc = (graze_pmc)b->points.value[out.corners[k]];
        mixed |= k > 0 && pmc != out.pmc;
        out.pmc = pmc;
    }
    out.pmc = mixed ? GRAZE_PMC_NONE : out.pmc;
    out.contact = sample_cell_has_contact(b, c);
    return out;
}

void graze_boundary_vertex(mpq_t *point, const graze_boundary *b, size_t index) {
    if (!point || !b || index >= bisect_count(b))
        return;
    LOCAL_VEC(fmpq, at, b->dimension);
    bisect_vertex(at, b, index);
    api_point_out(point, at, b->dimension);
}

void graze_boundary_vertex_between(mpq_t *outside, mpq_t *inside, const graze_boundary *b,
                                   size_t index) {
    if (!outside || !inside || !b || index >= bisect_count(b))
        return;
    LOCAL_VEC(fmpq, at, 2 * b->dimension);
    bisect_between(at, at + b->dimension, b, index);
    api_point_out(outside, at, b->dimension);
    api_point_out(inside, at + b->dimension, b->dimension);
}

const size_t *graze_boundary_face(const graze_boundary *b, size_t index) {
    return b && index < b->face_count ? b->corners + index * (size_t)b->dimension : NULL;
}
