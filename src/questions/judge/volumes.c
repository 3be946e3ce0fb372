/* A cube that the mesh misses is inside or outside the mesh; other cubes are cut down to the width
 * wanted. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/judge/cube.h"

#include <math.h>
#include "base/context/scope.h"
#include "base/number/rounding.h"
#include "questions/judge/open_search.h"

/* Bounds: of the doublings of the root until it holds the mesh, and of the levels of cubes. */
enum { DOUBLINGS = 60, LEVELS = DOUBLINGS + 256 };

/* Volumes are counted in parts of cubes, 2^-PART_BITS each. */
enum { PART_BITS = 20, WHOLE = 1 << PART_BITS };

/* Counts of parts of cubes. Relative to the mesh a cube is MESH_IN, MESH_OUT, or MESH_UNTOLD if the
 * mesh may meet it. */
typedef struct measuring {
    suprema *s;
    int has_inside;
    fmpq_t flat;                           /* volume inside the mesh in cubes of kind CUBE_FLAT */
    size_t count[VOLUME_COUNT][2][LEVELS]; /* by level, for bounds below and above */
} measuring;

static int meets_below(const judged_mesh *m, const cube_span *c, uint32_t node) {
    const tree_node *here = &m->boxes.node[node];
    if (!box_meets(&here->box, &c->space))
        return 0;
    if (here->child)
        return meets_below(m, c, here->child) || meets_below(m, c, here->child + 1);
    return chord_meets(&c->shape, &c->all, m->corners.at + (size_t)here->simplex * 9,
                       m->corners.error) != CHORD_MISSES;
}

/* Is the mesh certain to miss a closed cube? */
static int mesh_misses_cube(const judged_mesh *m, const cube *c) {
    cube_span here;
    cube_span_set(&here, c, m);
    return !m->boxes.node_count || !meets_below(m, &here, 0);
}

static mesh_place place_of_cube(const measuring *r, const cube *c) {
    LOCAL_VEC(fmpq, point, 3);
    long winding;
    for (int i = 0; i < 3; i++)
        (void)rational_from_double(point + i, NULL, c->centre[i]);
    return judged_place(&winding, r->s->mesh, point);
}

static void count_cube(measuring *r, const cube *c, int level, mesh_place mesh,
                       const cube_slab *slab) {
    double share[2] = {c->kind == CUBE_IN, c->kind != CUBE_OUT};
    size_t(*count)[2][LEVELS] = r->count;
    if (slab)
        slab_shares(share, slab, c);
    size_t low = (size_t)floor(share[0] * WHOLE), high = (size_t)ceil(share[1] * WHOLE);
    level += DOUBLINGS;
    count[IN_SWEEP][0][level] += low;
    count[IN_SWEEP][1][level] += high;
    count[MISSING][0][level] += mesh == MESH_OUT ? low : 0;
    count[MISSING][1][level] += mesh != MESH_IN ? high : 0;
    count[EXCESS][0][level] += mesh == MESH_IN ? WHOLE - high : 0;
    count[EXCESS][1][level] += mesh != MESH_OUT ? WHOLE - low : 0;
}

/* `slab`: that of a cube which holds this one, or NULL. */
static graze_status measure_cube(measuring *r, const cube *c, int level, mesh_place mesh,
                                 const cube_slab *slab) {
    suprema *s = r->s;
    s->space.seen += MEASURED;
    if (c->slab)
        slab = &s->slab[c->slab - 1];
    uint32_t child = slab ? 0 : c->child;
    if (c->beside)
        mesh = c->kind == CUBE_IN ? MESH_IN : MESH_OUT;
    if (r->has_inside && mesh == MESH_UNTOLD && mesh_misses_cube(s->mesh, c))
        mesh = place_of_cube(r, c);
    int cut = r->has_inside && mesh == MESH_UNTOLD && cube_radius(c) > s->within &&
              level < CUBE_LEVELS && !suprema_is_over(s);
    if (c->kind == CUBE_FLAT && !child)
        return flat_volume(r->flat, s->context, c, s->mesh);
    if (!child && !cut) {
        count_cube(r, c, level, mesh, slab);
        return GRAZE_OK;
    }
    for (int k = 0; k < 8; k++) {
        cube part = cube_part(c, k);
        part.kind = c->kind;
        TRY(measure_cube(r, child ? &s->space.item[child + (uint32_t)k] : &part, level + 1, mesh,
                         slab));
    }
    return context_poll(s->context);
}

/* Measure the space outside the root that the mesh reaches: the root is doubled towards the mesh,
 * and each time the seven new cubes are measured. has_inside becomes 0 if the mesh is too far away.
 */
static graze_status measure_around(measuring *r) {
    const box *reach = &r->s->mesh->boxes.node[0].box;
    cube last = r->s->space.item[0];
    for (int level = 0; level > -DOUBLINGS; level--) {
        double to[3], past = 0;
        for (int i = 0; i < 3; i++) {
            double below = last.centre[i] - last.half - reach->low[i];
            double above = reach->high[i] - last.centre[i] - last.half;
            to[i] = above > below ? last.half : -last.half;
            past = larger(past, larger(above, below));
        }
        if (!(past > 0))
            return GRAZE_OK;
        for (int k = 1; k < 8; k++) {
            cube part = {.half = last.half, .kind = CUBE_OUT};
            for (int i = 0; i < 3; i++)
                part.centre[i] = last.centre[i] + (k >> i & 1 ? 2 * to[i] : 0);
            TRY(measure_cube(r, &part, level, MESH_UNTOLD, NULL));
        }
        for (int i = 0; i < 3; i++)
            last.centre[i] += to[i];
        last.half *= 2;
    }
    r->has_inside = 0;
    return GRAZE_OK;
}

/* Add the volumes of the cubes of all levels; `root` is the volume of the root. */
static void add_volumes(fmpq_t sum, const fmpq_t root, const size_t *count) {
    LOCAL(fmpq, term);
    LOCAL(fmpz, number);
    for (int level = 0; level < LEVELS; level++) {
        fmpz_set_ui(number, count[level]);
        fmpq_mul_fmpz(term, root, number);
        fmpq_mul_2exp(term, term, 3 * DOUBLINGS);
        fmpq_div_2exp(term, term, 3 * (ulong)level + PART_BITS);
        fmpq_add(sum, sum, term);
    }
}

graze_status volumes_find(suprema *s) {
    measuring r = {.s = s, .has_inside = s->mesh->rule != GRAZE_MESH_NONE};
    fmpq_init(r.flat);
    graze_status status = measure_cube(&r, &s->space.item[0], 0, MESH_UNTOLD, NULL);
    if (!status && r.has_inside && s->mesh->boxes.node_count)
        status = measure_around(&r);
    s->has_difference = r.has_inside;
    LOCAL(fmpq, root);
    (void)rational_from_double(root, NULL, 2 * s->space.item[0].half);
    fmpq_pow_si(root, root, 3);
    for (int k = 0; k < VOLUME_COUNT; k++)
        for (int side = 0; side < 2; side++)
            add_volumes(s->volume + 2 * k + side, root, r.count[k][side]);
    for (int side = 0; side < 2; side++)
        fmpq_add(s->volume + 2 * IN_SWEEP + side, s->volume + 2 * IN_SWEEP + side, r.flat);
    fmpq_clear(r.flat);
    return status;
}
