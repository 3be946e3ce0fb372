/* Writes the nodes of OpenSCAD's `.csg` files as those of `.csg.json`.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Boolean operations commute with prisms and with revolution, where a point of space is in the
 * solid iff (distance from the axis, height) is in the outline: so nodes of the plane are written
 * where they stand, in the form of the extrusion around them.
 */
#include "input/scad/scad.h"

#include <flint/fmpq_vec.h>
#include <stdlib.h>
#include <string.h>
#include "base/context/scope.h"
#include "base/number/decimal.h"
#include "base/number/vector.h"
#include "input/scad/arguments.h"
#include "input/scad/writer.h"

static graze_status write_node(scad_writer *w, size_t node);

/* The next child of an operation behind `child`, or from the first if `child` is 0, that is not
 * empty; 0 if there is none. */
static size_t operand_after(const scad *file, size_t node, size_t child) {
    do
        child = child ? scad_next(file, child) : scad_first(file, node);
    while (child && file->node[child].empty);
    return child;
}

/* Write the children of an operation; a single child is written without the operation. */
static graze_status write_operands(scad_writer *w, const scad_place *p) {
    static const char *const keys[] = {
        [SCAD_DIFFERENCE] = "difference", [SCAD_INTERSECTION] = "intersection"};
    scad_role role = p->file->node[p->node].role;
    size_t child = operand_after(p->file, p->node, 0);
    if (!operand_after(p->file, p->node, child))
        return write_node(w, child);
    LOCAL_VEC(fmpq, most, 2);
    scad_open(w, p, role <= SCAD_INTERSECTION && keys[role] ? keys[role] : "union", '[');
    for (; child; child = operand_after(p->file, p->node, child)) {
        TRY(write_node(w, child));
        if (fmpq_cmp(w->reach, most) > 0)
            fmpq_set(most, w->reach);
        if (fmpq_cmp(w->moved, most + 1) > 0)
            fmpq_set(most + 1, w->moved);
    }
    json_ends(&w->json, "]}");
    fmpq_swap(w->reach, most);
    fmpq_swap(w->moved, most + 1);
    return GRAZE_OK;
}

/* Write the rows of a map's matrix; within a prism the map keeps heights. */
static void put_map_rows(scad_writer *w, const scad_map *m) {
    int d = w->dimension, flat = d == 3 && w->form == SCAD_PRISM;
    LOCAL_VEC(fmpq, row, 4);
    json_open(&w->json, "matrix", '[');
    for (int i = 0; i < d; i++) {
        vector_set(row, m->linear + 3 * i, d);
        fmpq_set(row + d, m->shift + i);
        if (flat && i == 2)
            fmpq_one(row + 2);
        json_point(&w->json, NULL, row, d + 1);
    }
    json_close(&w->json, ']');
}

static graze_status write_mapped(scad_writer *w, const scad_place *p) {
    LOCAL_VEC(fmpq, inner, 6);
    fmpq *outer = w->map;
    int turned;
    HELD(scad_map, m);
    TRY(scad_map_read(&m, w, p, &turned));
    w->turned += (size_t)turned;
    if (w->form == SCAD_REVOLVED) {
        scad_compose(inner, outer, &m);
        w->map = inner;
        TRY(write_operands(w, p));
        w->map = outer;
    } else {
        scad_open(w, p, "affine", '{');
        put_map_rows(w, &m);
        w->key = "of";
        TRY(write_operands(w, p));
        json_ends(&w->json, "}}");
    }
    if (w->choice->near_rotation)
        scad_map_bounds(w, &m);
    return GRAZE_OK;
}

/* Set the writer's map to the identity, or for sign -1 to the reflection that keeps heights. */
static void reset_map(scad_writer *w, int sign) {
    for (int k = 0; k < 6; k++)
        fmpq_set_si(w->map + k, k == 0 ? sign : k == 4, 1);
}

/* Find an interval that holds the first coordinates of an outline after the writer's map. */
static graze_status find_extent(fmpq *out, scad_writer *w, size_t node) {
    scad_place p = {w->file, w->context, node};
    scad_role role = w->file->node[node].role;
    if (role >= SCAD_HULL) {
        scad_writer before = *w;
        graze_status found = scad_outline_extent(out, w, &p);
        w->turned = before.turned;
        w->round = before.round;
        w->sided = before.sided;
        return found;
    }
    LOCAL_VEC(fmpq, v, 8);
    fmpq *inner = v, *next = v + 6, *outer = w->map;
    size_t c = 0;
    int first = 1, turned;
    HELD(scad_map, m);
    if (role == SCAD_MAP) {
        TRY(scad_map_read(&m, w, &p, &turned));
        scad_compose(inner, outer, &m);
        w->map = inner;
    }
    for (; (first || role != SCAD_DIFFERENCE) && (c = operand_after(w->file, node, c)); first = 0) {
        TRY(find_extent(next, w, c));
        for (int k = 0; k < 2; k++)
            if (first || (fmpq_cmp(next + k, out + k) < 0) == ((role == SCAD_INTERSECTION) == k))
                fmpq_set(out + k, next + k);
    }
    w->map = outer;
    return GRAZE_OK;
}

/* Set the writer's map to one that brings an outline to the right of the axis; refuse an outline on
 * both sides. */
static graze_status find_side(scad_writer *w, const scad_place *p) {
    LOCAL_VEC(fmpq, extent, 2);
    reset_map(w, 1);
    TRY(find_extent(extent, w, p->node));
    if (fmpq_sgn(extent) < 0 && fmpq_sgn(extent + 1) > 0)
        return scad_fail(p, GRAZE_EILLEGAL,
                         "the outline is on both sides of the axis; expected x of one sign");
    reset_map(w, fmpq_sgn(extent) < 0 ? -1 : 1);
    return GRAZE_OK;
}

/* Write the half-space on the left of a direction, in eighths of a turn, or on its right. */
static void put_wedge_side(scad_writer *w, int direction, int right) {
    static const int x[] = {1, 1, 0, -1, -1, -1, 0, 1};
    int sign = right ? -1 : 1;
    text_format(json_begin(&w->json, NULL),
                "{\"halfspace\":{\"normal\":[\"%d\",\"%d\",\"0\"],\"offset\":0}}",
                sign * x[(direction + 6) % 8], -sign * x[direction % 8]);
}

/* Write the points between two directions about the z axis, `count` eighths from `from` on. */
static void put_wedge(scad_writer *w, int from, int count) {
    json_open(&w->json, NULL, '{');
    json_open(&w->json, count < 4 ? "intersection" : "union", '[');
    put_wedge_side(w, from, 0);
    if (count != 4)
        put_wedge_side(w, from + count, 1);
    json_ends(&w->json, "]}");
}

/* Read an angle in eighths of a turn; `out` stays where none is given. */
static graze_status read_eighths(int *out, const scad_place *p, const char *name) {
    field value;
    LOCAL(fmpq, angle);
    if (!scad_value(&value, p, name))
        return GRAZE_OK;
    TRY(scad_number(angle, p, value));
    fmpz_mul_ui(fmpq_denref(angle), fmpq_denref(angle), 45);
    fmpq_canonicalise(angle);
    if (!fmpz_is_one(fmpq_denref(angle)) || fmpz_cmp_si(fmpq_numref(angle), 8) > 0 ||
        fmpz_cmp_si(fmpq_numref(angle), -8) < 0)
        return scad_fail(p, GRAZE_EINPUT,
                         "only whole turns and eighths of a turn are taken; expected angle = 360, "
                         "or multiples of 45 for angle and start");
    *out = (int)fmpz_get_si(fmpq_numref(angle));
    return GRAZE_OK;
}

static graze_status write_revolution(scad_writer *w, const scad_place *p) {
    size_t sides;
    int count = 8, from = 0;
    TRY(scad_known(p, "angle start convexity"));
    TRY(scad_sides(&sides, w, p));
    if (sides > 0)
        return scad_fail(p, GRAZE_EINPUT,
                         "a turn of %zu sides is not taken; expected --smooth of at most as many",
                         sides);
    TRY(read_eighths(&count, p, "angle"));
    if (count % 8)
        TRY(read_eighths(&from, p, "start"));
    TRY(find_side(w, p));
    from += count < 0 ? count + 16 : 8;
    from += fmpq_sgn(w->map) < 0 ? 4 : 0;
    count = abs(count);
    if (count < 8) {
        scad_open(w, p, "intersection", '[');
        put_wedge(w, from, count);
    }
    w->form = SCAD_REVOLVED;
    TRY(write_operands(w, p));
    w->form = SCAD_ITSELF;
    reset_map(w, 1);
    if (count < 8)
        json_ends(&w->json, "]}");
    return GRAZE_OK;
}

/* Refuse an extrusion that is no prism over its outline. */
static graze_status check_straight(const scad_place *p) {
    LOCAL_VEC(fmpq, v, 3);
    fmpq *twist = v, *scale = v + 1;
    field value;
    fmpq_one(scale);
    fmpq_one(scale + 1);
    if (scad_value(&value, p, "twist"))
        TRY(scad_number(twist, p, value));
    if (scad_value(&value, p, "scale"))
        TRY(scad_vector(scale, p, value, 2));
    if (!(fmpq_is_zero(twist) && fmpq_is_one(scale) && fmpq_is_one(scale + 1)))
        return scad_fail(p, GRAZE_EINPUT,
                         "only prisms are taken; expected no twist and a scale of 1");
    return GRAZE_OK;
}

static graze_status write_prism(scad_writer *w, const scad_place *p) {
    fmpq *high = w->height + 1;
    TRY(scad_known(p, "height center convexity twist slices segments scale"));
    TRY(check_straight(p));
    TRY(scad_size(high, p, "height"));
    if (scad_flag(p, "center")) {
        fmpq_div_2exp(high, high, 1);
        fmpq_neg(w->height, high);
    }
    w->form = SCAD_PRISM;
    TRY(write_operands(w, p));
    w->form = SCAD_ITSELF;
    fmpq_add(w->reach, w->reach, high);
    fmpq_zero(w->height);
    return GRAZE_OK;
}

/* Count a part that could be round. */
static graze_status count_sides(scad_writer *w, const scad_place *p) {
    scad_role role = p->file->node[p->node].role;
    size_t sides;
    if (role != SCAD_SPHERE && role != SCAD_CYLINDER && role != SCAD_CIRCLE &&
        role != SCAD_REVOLUTION)
        return GRAZE_OK;
    TRY(scad_sides(&sides, w, p));
    *(sides > 0 ? &w->sided : &w->round) += 1;
    return GRAZE_OK;
}

static graze_status write_node(scad_writer *w, size_t node) {
    scad_place p = {w->file, w->context, node};
    fmpq_zero(w->reach);
    fmpq_zero(w->moved);
    TRY(count_sides(w, &p));
    scad_role role = w->file->node[node].role;
    if (role == SCAD_MAP)
        return write_mapped(w, &p);
    if (role == SCAD_EXTRUSION)
        return write_prism(w, &p);
    if (role == SCAD_REVOLUTION)
        return write_revolution(w, &p);
    int hull = role == SCAD_HULL || role == SCAD_MINKOWSKI;
    if (role < SCAD_CUBE && !hull)
        return write_operands(w, &p);
    TRY(w->file->node[node].dimension == 3 ? scad_write_body(w, &p) : scad_write_outline(w, &p));
    return context_work(w->context, 16);
}

/* As scad_writer.part. Of the writer around it only what is counted changes. */
static graze_status write_part(text *out, scad_writer *around, size_t node) {
    LOCAL_VEC(fmpq, v, 10);
    scad_writer w = *around;
    w.json = (json_writer){.out = out};
    w.line = 1;
    w.key = "solid";
    w.dimension = w.file->node[node].dimension;
    w.form = SCAD_ITSELF;
    w.height = v;
    w.map = v + 2;
    w.reach = v + 8;
    w.moved = v + 9;
    w.turned = w.round = w.sided = 0;
    reset_map(&w, 1);
    json_open(&w.json, NULL, '{');
    json_count(&w.json, "dimension", (unsigned long)w.dimension);
    TRY(write_node(&w, node));
    json_close(&w.json, '}');
    fmpq_add(around->moved, around->moved, w.moved);
    around->turned += w.turned;
    around->round += w.round;
    around->sided += w.sided;
    return GRAZE_OK;
}

/* Report what is round, and the rotations that were taken. */
static void put_report(text *report, const scad_writer *w) {
    if (w->choice->smooth)
        text_format(report, "taken as round: %zu, with sides: %zu, as empty: %zu\n", w->round,
                    w->sided, w->file->nothing);
    if (!w->choice->near_rotation)
        return;
    LOCAL(fmpq, factor);
    fmpq_set_si(factor, 101, 100); /* rounding to three digits takes away at most 0.5 % */
    fmpq_mul(w->moved, w->moved, factor);
    text_put(report, "maps taken as rotations: ");
    text_count(report, w->turned);
    text_put(report, "; no point moves by more than ");
    text_owned(report, decimal_of_rational(NULL, w->moved, 3));
    text_put(report, "\n");
}

graze_status scad_write(text *out, text *report, text *note, graze_context *context,
                        const char *source, const char *bytes, size_t length,
                        const scad_choice *choice) {
    ZEROED(scad, file);
    LOCAL(fmpq, moved);
    TRY(scad_parse(&file, context, source, bytes, length));
    scad_writer w = {
        .file = &file, .context = context, .choice = choice, .moved = moved, .part = write_part};
    TRY(write_part(out, &w, file.root));
    text_put(out, "\n");
    put_report(report, &w);
    if (file.nothing)
        text_format(
            note,
            "parts that are empty, of size zero or by a singular map: %zu, in line %zu the first",
            file.nothing, file.first_nothing);
    return GRAZE_OK;
}
