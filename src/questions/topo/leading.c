/* Each cell of the arrangement is asked about, once for each ray in its closure.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A cell of full dimension that is not covered proves a boundary point. An interior point is proved
 * if each cell is covered with a neighbourhood, or all full cells around it lie in exact closed
 * cones.
 */
#include "questions/topo/eliminate.h"

#include "base/context/scope.h"

/* Kinds of evidence for `interior`: open cones; exact closed cones too; ways along edges too. */
enum { BY_FIRST_ORDER, BY_CLOSED_CONES, BY_EDGES, BY_COUNT };

typedef struct leading_maker {
    topo_finding *out;
    graze_context *context;
    const graze_scene *scene;
    const fmpq *point;
    germ_list *germs;
    borders *borders;
    int is_interior[BY_COUNT]; /* 1: proved for all cells so far, by this kind of evidence and the
                                  kinds before it */
    direction_span open;       /* E^3: span of the directions without a covered neighbourhood */
} leading_maker;

/* Take the point of a ray at its reach as the witness, if the reach is found and the point is out.
 */
static graze_status try_witness(leading_maker *m, const fmpz *direction) {
    slong d = m->borders->dimension;
    topo_finding *out = m->out;
    int found = 0;
    TRY(ray_find_reach(&found, &out->reach, m->context, m->scene, m->point, direction));
    if (!found)
        return GRAZE_OK;
    for (slong k = 0; k < d; k++) {
        fmpq_mul_fmpz(out->witness + k, &out->reach, direction + k);
        fmpq_add(out->witness + k, m->point + k, out->witness + k);
    }
    _fmpz_vec_set(out->direction, direction, d);
    return beyond_closed(&out->has_witness, m->context, m->scene, out->witness);
}

/* Round a direction to entries of about `bits` bits; many bits leave it unchanged. */
static void round_direction(fmpz *out, const fmpz *direction, slong d, slong bits) {
    slong drop = FLINT_ABS(_fmpz_vec_max_bits(direction, d)) - bits;
    for (slong k = 0; k < d; k++)
        if (drop > 0)
            fmpz_tdiv_q_2exp(out + k, direction + k, (ulong)drop);
        else
            fmpz_set(out + k, direction + k);
    direction_reduce(out, d);
}

/* Tilt a direction a little, so that facets are seldom parallel to it. */
static void tilt_direction(fmpz *direction, slong d) {
    static const slong askew[3] = {3, -5, 7}, many = 32;
    for (slong k = 0; k < d; k++) {
        fmpz_mul_si(direction + k, direction + k, many);
        fmpz_add_si(direction + k, direction + k, askew[k]);
    }
    direction_reduce(direction, d);
}

/* Try a direction for a witness if it is not covered. */
static graze_status try_direction(leading_maker *m, const fmpz *direction) {
    germ_cover cover = {0, 0, 0, 1};
    if (!_fmpz_vec_is_zero(direction, m->borders->dimension))
        TRY(germs_cover(&cover, m->germs, m->context, direction));
    return cover.covered ? GRAZE_OK : try_witness(m, direction);
}

/* Decide `boundary`: the direction is not covered, so points near enough on its ray are out. For a
 * witness with short numbers, coarse roundings of the direction are tried first, each followed by a
 * direction beside it. */
static graze_status set_boundary(leading_maker *m, const fmpz *direction) {
    static const slong bits[] = {2, 4, 8, 16, 64, WORD_MAX};
    slong d = m->borders->dimension;
    topo_finding *out = m->out;
    LOCAL_VEC(fmpz, simple, d);
    for (size_t k = 0; k < sizeof bits / sizeof *bits && !out->has_witness; k++) {
        round_direction(simple, direction, d, bits[k]);
        TRY(try_direction(m, simple));
        if (out->has_witness)
            break;
        tilt_direction(simple, d);
        TRY(try_direction(m, simple));
    }
    if (out->has_witness)
        finding_set(out, GRAZE_TOPO_BOUNDARY, GRAZE_LEVEL_FIRST_ORDER);
    else
        finding_undecided(out, "no witness of the boundary is found");
    return GRAZE_OK;
}

/* Keep the first open direction. */
static void keep_open_direction(topo_finding *out, const fmpz *direction, int d) {
    if (!out->has_open)
        _fmpz_vec_set(out->open, direction, d);
    out->has_open = 1;
}

/* In E^3: add a direction without a covered neighbourhood to the span of such directions. */
static void note_open(leading_maker *m, const fmpz *direction) {
    if (m->borders->dimension == 3)
        direction_span_add(&m->open, direction);
}

/* Take a cell's cover into `is_interior`; returns 0 if the cell has no covered neighbourhood.
 * @param all_exact 1: all full cells around this cell lie in exact closed cones */
static int note_cell(leading_maker *m, const germ_cover *cell, int all_exact) {
    for (int by = 0; by < BY_COUNT; by++)
        m->is_interior[by] =
            m->is_interior[by] && (cell->open || (by == BY_EDGES && cell->edge_way) ||
                                   (by >= BY_CLOSED_CONES && all_exact));
    return cell->open || cell->edge_way || all_exact;
}

/* Take a cell of dimension 2 beside a ray. If the cell has no covered neighbourhood, the ray and a
 * direction in the cell, which span the cell's plane, are noted as open. */
static void note_between(leading_maker *m, const fmpz *ray, const fmpz *direction,
                         const germ_cover *cell, int all_exact) {
    if (note_cell(m, cell, all_exact))
        return;
    note_open(m, ray);
    note_open(m, direction);
}

/* Take a cell of full dimension into account; `*here` becomes its cover. */
static graze_status look_at_full(germ_cover *here, leading_maker *m, const fmpz *direction) {
    TRY(germs_cover(here, m->germs, m->context, direction));
    if (!here->covered && m->germs->bounded)
        TRY(set_boundary(m, direction));
    else if (!here->covered)
        keep_open_direction(m->out, direction, m->borders->dimension);
    if (!note_cell(m, here, here->exact))
        m->open.rank = 3;
    return GRAZE_OK;
}

/* Take into account the cells around ray r: those of full dimension, in E^3 also those of dimension
 * 2 between these, and the ray itself. */
static graze_status look_around(leading_maker *m, size_t r) {
    int d = m->borders->dimension, all_exact = 1;
    size_t step = d == 3 ? 2 : 1;
    const fmpz *around = m->borders->ray + r * (size_t)d;
    germ_cover ray, last, first = {0, 0, 0, 0}, here = first, between = first;
    HELD(ray_cells, cells, m->borders, r);
    TRY(germs_cover(&ray, m->germs, m->context, around));
    for (size_t k = 0; k < cells.count && m->out->position == GRAZE_TOPO_NONE; k += step) {
        const fmpz *cell = cells.item + k * (size_t)d;
        last = here;
        TRY(look_at_full(&here, m, cell));
        if (d == 3 && k > 0)
            note_between(m, around, cell - d, &between, last.exact && here.exact);
        if (d == 3)
            TRY(germs_cover(&between, m->germs, m->context, cell + d));
        all_exact = all_exact && here.exact;
        first = k == 0 ? here : first;
    }
    if (d == 3)
        note_between(m, around, cells.item + (cells.count - 1) * 3, &between,
                     here.exact && first.exact);
    if (!note_cell(m, &ray, all_exact))
        note_open(m, around);
    return GRAZE_OK;
}

/* Ask whether leading terms cover the plane of the open directions from both sides; if not, keep
 * the plane and a gap. */
static graze_status look_at_second_order(int *covers, leading_maker *m) {
    topo_finding *out = m->out;
    HELD(plane_gap, gap);
    direction_reduce(m->open.basis + 6, 3);
    TRY(second_covers(covers, &gap, m->germs, m->context, m->point, m->open.basis + 6));
    if (!*covers && !out->has_open) {
        _fmpz_vec_set(out->across, m->open.basis + 6, 3);
        out->has_across = 1;
        out->order = gap.order;
        fmpq_set(&out->lift, &gap.lift);
        if (gap.order)
            keep_open_direction(out, gap.along, 3);
    }
    return GRAZE_OK;
}

/* Take the cells around all rays, until one decides the point or nothing more can be decided. */
static graze_status look_at_rays(leading_maker *m) {
    m->open.rank = m->out->has_open = 0;
    for (int by = 0; by < BY_COUNT; by++)
        m->is_interior[by] = 1;
    for (size_t r = 0; r < m->borders->ray_count && m->out->position == GRAZE_TOPO_NONE &&
                       (m->germs->bounded || m->is_interior[BY_EDGES] ||
                        (m->borders->dimension == 3 && m->open.rank < 3));
         r++)
        TRY(look_around(m, r));
    return GRAZE_OK;
}

static graze_status look_at_all(leading_maker *m) {
    static const graze_topo_level level[] = {GRAZE_LEVEL_FIRST_ORDER, GRAZE_LEVEL_CLOSED_CONES,
                                             GRAZE_LEVEL_EDGES};
    int by_second = 0;
    TRY(look_at_rays(m));
    if (m->out->position == GRAZE_TOPO_NONE && !m->is_interior[BY_CLOSED_CONES]) {
        /* All cells again, with ways along edges, which are costly. */
        for (size_t k = 0; k < m->germs->count; k++)
            if (!m->germs->item[k].root)
                TRY(edge_ways_find(&m->germs->item[k], m->context));
        TRY(look_at_rays(m));
    }
    if (m->out->position != GRAZE_TOPO_NONE)
        return GRAZE_OK;
    for (int by = BY_EDGES; by >= 0; by--)
        if (m->is_interior[by])
            finding_set(m->out, GRAZE_TOPO_INTERIOR, level[by]);
    if (m->open.rank == 2)
        TRY(look_at_second_order(&by_second, m));
    if (by_second)
        finding_set(m->out, GRAZE_TOPO_INTERIOR, GRAZE_LEVEL_LEADING_TERMS);
    else if (!m->is_interior[BY_EDGES])
        finding_undecided(m->out, m->germs->bounded
                                      ? "to first order the contacts close around the point, and "
                                        "what is left is thinner than every cone"
                                      : m->germs->reason);
    return GRAZE_OK;
}

graze_status leading_decide(topo_finding *out, graze_context *context, const graze_scene *scene,
                            const plane_list *planes, const fmpq *point) {
    int refused = 0;
    HELD(germ_list, germs);
    HELD(borders, b, scene->motion->dimension);
    LOCAL_VEC(fmpz, open, 9);
    leading_maker m = {.out = out,
                       .context = context,
                       .scene = scene,
                       .point = point,
                       .germs = &germs,
                       .borders = &b,
                       .open.basis = open};
    TRY(germs_find(&germs, context, scene, planes, point));
    TRY(borders_find(&b, &refused, context, &germs));
    if (!refused)
        return look_at_all(&m);
    finding_undecided(out, "more planes border what the contacts cover than are looked at");
    return GRAZE_OK;
}
