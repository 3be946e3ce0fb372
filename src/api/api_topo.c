/* The public functions of positions relative to the closed sweep and the regularised unsweep.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "api/api.h"

#include "questions/topo/topo.h"

struct graze_topology {
    topo_finding inner;
    int dimension;
};

typedef graze_status (*decider)(topo_finding *, graze_context *, const graze_scene *, const fmpq *,
                                const graze_trace *);

/* Check the arguments and answer `question`, topo_decide or topo_regular. */
static graze_status decide(graze_topology **out, graze_context *context, const char *function,
                           decider question, const graze_scene *scene, graze_rationals point,
                           const graze_trace *trace) {
    EMPTY(out);
    GIVEN_TO(function, out, context, scene, point, trace);
    if (question == topo_regular && scene->options.operation == GRAZE_SWEEP)
        return api_misuse(context, function, "the scene is a sweep; expected an unsweep");
    TRY(api_takes(context, function, scene->solid));
    IN_ENVIRONMENT();
    LOCAL_VEC(fmpq, p, scene->motion->dimension);
    TRY(api_point(p, context, scene, point));
    CREATE(out, made, graze_topology_destroy,
           (made->dimension = scene->motion->dimension, finding_init(&made->inner),
            question(&made->inner, context, scene, p, trace)));
}

graze_status graze_trace_topo(graze_topology **out, graze_context *context,
                              const graze_scene *scene, graze_rationals point,
                              const graze_trace *trace) {
    return decide(out, context, "graze_trace_topo", topo_decide, scene, point, trace);
}

graze_status graze_trace_regular(graze_topology **out, graze_context *context,
                                 const graze_scene *scene, graze_rationals point,
                                 const graze_trace *trace) {
    return decide(out, context, "graze_trace_regular", topo_regular, scene, point, trace);
}

DESTROYER(graze_topology, finding_clear(&of->inner))
FACT(graze_topo, graze_topology_position, graze_topology, of->inner.position, GRAZE_TOPO_NONE)
FACT(graze_topo_level, graze_topology_level, graze_topology, of->inner.level, GRAZE_LEVEL_NONE)
FACT(const char *, graze_topology_reason, graze_topology, of->inner.reason, "")

int graze_topology_witness(mpq_t *out, const graze_topology *topology) {
    if (!out || !topology || !topology->inner.has_witness)
        return 0;
    api_point_out(out, topology->inner.witness, topology->dimension);
    return 1;
}

/* Hand integers to the caller as rationals. */
static void integers_out(mpq_t *out, const fmpz *v, int count) {
    fmpq value = {0, 1};
    for (int k = 0; k < count; k++) {
        fmpz_set(&value.num, v + k);
        fmpq_get_mpq(out[k], &value);
    }
    fmpz_clear(&value.num);
}

static int has_witness_of(const graze_topology *topology, topo_witness kind) {
    return topology && topology->inner.has_witness && finding_witness(&topology->inner) == kind;
}

int graze_topology_ray(mpq_t *direction, mpq_t epsilon, const graze_topology *topology) {
    if (!direction || !epsilon || !has_witness_of(topology, WITNESS_RAY))
        return 0;
    integers_out(direction, topology->inner.direction, topology->dimension);
    fmpq_get_mpq(epsilon, &topology->inner.reach);
    return 1;
}

int graze_topology_path(mpq_t *direction, mpq_t *normal, mpq_t z, size_t *order, mpq_t epsilon,
                        const graze_topology *topology) {
    if (!direction || !normal || !z || !order || !epsilon ||
        !has_witness_of(topology, WITNESS_PATH))
        return 0;
    integers_out(direction, topology->inner.open, topology->dimension);
    integers_out(normal, topology->inner.across, topology->dimension);
    fmpq_get_mpq(z, &topology->inner.lift);
    *order = (size_t)topology->inner.order;
    fmpq_get_mpq(epsilon, &topology->inner.reach);
    return 1;
}

int graze_topology_square(mpq_t *along, mpq_t rho, const graze_topology *topology) {
    if (!along || !rho || !has_witness_of(topology, WITNESS_SQUARE))
        return 0;
    for (int k = 0; k < 2; k++)
        integers_out(along + k * topology->dimension, topology->inner.along[k],
                     topology->dimension);
    fmpq_get_mpq(rho, &topology->inner.reach);
    return 1;
}
