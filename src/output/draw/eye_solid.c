/* Cells of a lattice, with a vertex in each that the boundary meets: the place nearest to the
 * tangent planes at the cell's crossed sides, so that sharp edges stay sharp (dual contouring; Ju,
 * Losasso, Schaefer, Warren 2002). Four cells around a crossed side make two triangles.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/draw/panel.h"

#include <math.h>
#include "base/context/array.h"
#include "base/context/scope.h"

/* CELLS along a side of the lattice; TIMES_HALVED of a cell's side to find its crossing. */
enum { CELLS = 64, ALONG = CELLS + 1, TIMES_HALVED = 12 };
/* Weight of the middle of a vertex's crossings, against weight 1 of each tangent plane. */
static const double held = 1e-2;

/* The crossings of a cell, in coordinates from its low corner in units of the lattice. */
typedef struct crossings {
    double count, middle[3], square[6], right[3]; /* square: xx, xy, xz, yy, yz, zz */
    unsigned char cell[3];
} crossings;

typedef struct surface_maker {
    graze_context *context;
    eye_field field;
    graze_solid *out;
    double low[3], step[3];
    unsigned char *inside; /* by corner */
    uint32_t *vertex;      /* by cell: its number + 1 */
    crossings *met;        /* by vertex */
    size_t count, room, item_room;
} surface_maker;

/* The place of lattice coordinates. Lattice corners are a little off the ends of the box. */
static void place_in_lattice(double out[3], const surface_maker *m, const double at[3]) {
    for (int k = 0; k < 3; k++)
        out[k] = m->low[k] + (at[k] - .37) * m->step[k];
}

static size_t cell_index(const size_t at[3]) {
    return (at[2] * ALONG + at[1]) * ALONG + at[0];
}

static int holds_in(surface_maker *m, const double at[3]) {
    double place[3];
    place_in_lattice(place, m, at);
    return eye_field_holds(&m->field, place);
}

/* Corners at the lattice's border lie outside the box, so that sides there are never crossed. */
static graze_status mark_corners(surface_maker *m) {
    const size_t corners = (size_t)ALONG * ALONG * ALONG;
    size_t at[3];
    TRY(MAKE_ARRAY(m->context, m->inside, corners, "a picture of the solid"));
    TRY(MAKE_ARRAY(m->context, m->vertex, corners, "a picture of the solid"));
    for (at[2] = 1; at[2] < ALONG - 1; at[2]++)
        for (at[1] = 1; at[1] < ALONG - 1; at[1]++) {
            for (at[0] = 1; at[0] < ALONG - 1; at[0]++)
                m->inside[cell_index(at)] =
                    holds_in(m, (double[]){(double)at[0], (double)at[1], (double)at[2]});
            TRY(context_poll(m->context));
        }
    return GRAZE_OK;
}

/* Find the place at which a side along `axis` is crossed, and the boundary's normal at this place,
 * both in units of the lattice. */
static void cross_side(double place[3], double normal[3], surface_maker *m, const size_t at[3],
                       int axis) {
    double from[3], to[3], ends[2][3], length = 0;
    for (int k = 0; k < 3; k++)
        from[k] = to[k] = place[k] = (double)at[k];
    to[axis] += 1;
    for (int k = 0; k < TIMES_HALVED; k++) {
        place[axis] = (from[axis] + to[axis]) / 2;
        int same = holds_in(m, place) == m->inside[cell_index(at)];
        (same ? from : to)[axis] = place[axis];
    }
    place_in_lattice(ends[0], m, from);
    place_in_lattice(ends[1], m, to);
    eye_field_normal(normal, &m->field, ends[0], ends[1], m->step[axis] / 256);
    for (int k = 0; k < 3; k++) {
        normal[k] *= m->step[k]; /* a covector */
        length += normal[k] * normal[k];
    }
    for (int k = 0; k < 3 && length > 0; k++)
        normal[k] /= sqrt(length);
}

/* Add a crossing to a cell; the first crossing gives the cell its vertex. */
static graze_status add_crossing(uint32_t *vertex, surface_maker *m, const size_t cell[3],
                                 const double place[3], const double normal[3]) {
    uint32_t *known = &m->vertex[cell_index(cell)];
    if (!*known) {
        TRY(ARRAY_GROW(m->context, m->met, m->room, m->count + 1, "a surface for the eye"));
        m->met[m->count] = (crossings){
            .cell = {(unsigned char)cell[0], (unsigned char)cell[1], (unsigned char)cell[2]}};
        *known = (uint32_t)++m->count;
    }
    crossings *met = &m->met[*known - 1];
    double off = 0;
    met->count++;
    for (int i = 0, n = 0; i < 3; i++) {
        double own = place[i] - (double)cell[i];
        met->middle[i] += own;
        off += normal[i] * own;
        for (int j = i; j < 3; j++)
            met->square[n++] += normal[i] * normal[j];
    }
    for (int i = 0; i < 3; i++)
        met->right[i] += off * normal[i];
    *vertex = *known - 1;
    return GRAZE_OK;
}

/* Add the two triangles around a crossed side. */
static graze_status add_side(surface_maker *m, const size_t at[3], int axis) {
    static const unsigned char turn[4][2] = {{1, 1}, {0, 1}, {0, 0}, {1, 0}};
    int u = (axis + 1) % 3, v = (axis + 2) % 3;
    simplices *cut = &m->out->cut;
    double place[3], normal[3];
    uint32_t corner[4];
    cross_side(place, normal, m, at, axis);
    TRY(ARRAY_GROW(m->context, cut->item, m->item_room, cut->count + 2, "a surface for the eye"));
    for (int k = 0; k < 4; k++) {
        size_t cell[3] = {at[0], at[1], at[2]};
        cell[u] -= turn[k][0];
        cell[v] -= turn[k][1];
        TRY(add_crossing(&corner[k], m, cell, place, normal));
    }
    int outwards = m->inside[cell_index(at)], b = outwards ? 1 : 3, d = outwards ? 3 : 1;
    cut->item[cut->count++] = (simplex){.vertex = {corner[0], corner[b], corner[2]}};
    cut->item[cut->count++] = (simplex){.vertex = {corner[0], corner[2], corner[d]}};
    return GRAZE_OK;
}

static graze_status add_crossed_sides(surface_maker *m) {
    size_t at[3];
    for (at[2] = 0; at[2] < ALONG; at[2]++)
        for (at[1] = 0; at[1] < ALONG; at[1]++) {
            for (at[0] = 0; at[0] < ALONG; at[0]++)
                for (int axis = 0; axis < 3; axis++) {
                    size_t next[3] = {at[0], at[1], at[2]};
                    if (++next[axis] < ALONG &&
                        m->inside[cell_index(at)] != m->inside[cell_index(next)])
                        TRY(add_side(m, at, axis));
                }
            TRY(context_poll(m->context));
        }
    return GRAZE_OK;
}

/* Find the place in the cell nearest to the tangent planes: (A + held I) x = b, by Cramer's rule.
 */
static void solve_cell(double out[3], const crossings *met) {
    const double *s = met->square;
    double more = held * met->count, right[3];
    for (int k = 0; k < 3; k++)
        right[k] = met->right[k] + held * met->middle[k];
    double a = s[0] + more, b = s[1], c = s[2], d = s[3] + more, e = s[4], f = s[5] + more;
    double inverse[3][3] = {{d * f - e * e, c * e - b * f, b * e - c * d},
                            {c * e - b * f, a * f - c * c, b * c - a * e},
                            {b * e - c * d, b * c - a * e, a * d - b * b}};
    double whole = a * inverse[0][0] + b * inverse[0][1] + c * inverse[0][2];
    for (int i = 0; i < 3; i++) {
        double sum = 0;
        for (int j = 0; j < 3; j++)
            sum += inverse[i][j] * right[j];
        out[i] = fmin(fmax(sum / whole, 0), 1);
    }
}

static graze_status put_cell_vertices(surface_maker *m) {
    graze_solid *out = m->out;
    TRY(MAKE_ARRAY(m->context, out->low, (m->count + 1) * 3, "a picture of the solid"));
    for (size_t k = 0; k < m->count; k++) {
        double at[3];
        solve_cell(at, &m->met[k]);
        for (int i = 0; i < 3; i++)
            at[i] += (double)m->met[k].cell[i];
        place_in_lattice(out->low + 3 * k, m, at);
    }
    out->input.vertex_count = m->count;
    return GRAZE_OK;
}

static graze_status surface_make(graze_solid *out, graze_context *context, const csg *solid) {
    surface_maker m = {.context = context, .out = out};
    for (int k = 0; k < 3; k++) {
        double high = fmpq_get_d(&solid->box.high[k]);
        m.low[k] = fmpq_get_d(&solid->box.low[k]);
        m.step[k] = (high - m.low[k]) / (CELLS - 1);
    }
    graze_status status = eye_field_make(&m.field, context, solid);
    if (!status)
        status = mark_corners(&m);
    if (!status)
        status = add_crossed_sides(&m);
    if (!status)
        status = put_cell_vertices(&m);
    eye_field_clear(&m.field);
    free(m.inside);
    free(m.vertex);
    free(m.met);
    return status;
}

graze_status eye_solid_make(graze_solid *out, graze_context *context, const csg *solid) {
    *out = (graze_solid){.input = {.dimension = solid->dimension}};
    return (solid->dimension == 2 ? eye_outline_make : surface_make)(out, context, solid);
}

void eye_solid_clear(graze_solid *made) {
    free(made->low);
    free(made->cut.item);
    made->low = NULL;
    made->cut.item = NULL;
}
