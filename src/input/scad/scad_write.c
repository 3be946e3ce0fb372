/* Writes the nodes of OpenSCAD's `.csg` files as those of `.csg.json`.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Boolean operations commute with prisms and with revolution, where a point of space is in the
 * solid iff (distance from the axis, height) is in the outline: so nodes of the plane are written
 * where they stand, in the form of the extrusion around them.
 */
#include "input/scad/hull.h"

#include "base/context/scope.h"
#include "base/number/decimal.h"
#include "base/number/vector.h"

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

/* Write the rows of a map's matrix; within a prism the map keeps heights, and its shift is scaled
 * with the outline. */
static graze_status put_map_rows(scad_writer *w, const scad_place *p, const scad_map *m) {
    int d = w->dimension, flat = d == 3 && w->form == SCAD_PRISM;
    LOCAL_VEC(fmpq, row, 5);
    if (flat && !fmpq_equal(w->scale, w->scale + 1) &&
        !(fmpq_is_zero(m->linear + 1) && fmpq_is_zero(m->linear + 3)))
        return scad_fail(p, GRAZE_EINPUT,
                         "turned, and extruded with two scales; expected one scale for both axes");
    json_open(&w->json, "matrix", '[');
    for (int i = 0; i < d; i++) {
        vector_set(row, m->linear + 3 * i, d);
        fmpq_set(row + d, m->shift + i);
        if (flat && i < 2) {
            fmpq_sub_si(row + 2, w->scale + i, 1);
            fmpq_sub(row + 4, w->height + 1, w->height);
            fmpq_div(row + 2, row + 2, row + 4);
            fmpq_mul(row + 2, row + 2, row + 3);
            fmpq_submul(row + 3, row + 2, w->height);
        } else if (flat) {
            fmpq_one(row + 2);
        }
        json_point(&w->json, NULL, row, d + 1);
    }
    json_close(&w->json, ']');
    return GRAZE_OK;
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
        TRY(put_map_rows(w, p, &m));
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
static void put_wedge_side(scad_writer *w, const fmpq_t eighths, int right) {
    static const int corner[] = {1, 1, 0, -1, -1, -1, 0, 1};
    LOCAL_VEC(fmpq, x, 3);
    LOCAL_VEC(fmpz, turn, 2);
    fmpz_mul_2exp(turn, fmpq_denref(eighths), 3);
    fmpz_fdiv_r(turn + 1, fmpq_numref(eighths), turn);
    ulong count = fmpz_get_ui(turn), k = fmpz_get_ui(turn + 1);
    fmpq_one(x + 2);
    if (count > 8)
        scad_corner(x, k, count, x + 2);
    for (int i = 0; i < 2 && count == 8; i++)
        fmpq_set_si(x + i, corner[(k + 6 * (ulong)i) % 8], 1);
    fmpq_neg(x + right, x + right);
    json_form(json_begin(&w->json, NULL), "{\"halfspace\":{\"normal\":[%,%,\"0\"],\"offset\":0}}",
              x + 1, x);
}

/* Write the points between two directions about the z axis, `count` eighths from `from` on. */
static void put_wedge(scad_writer *w, const fmpq_t from, const fmpq_t count) {
    LOCAL(fmpq, to);
    int half = fmpq_cmp_si(count, 4);
    json_open(&w->json, NULL, '{');
    json_open(&w->json, half < 0 ? "intersection" : "union", '[');
    put_wedge_side(w, from, 0);
    fmpq_add(to, from, count);
    if (half != 0)
        put_wedge_side(w, to, 1);
    json_ends(&w->json, "]}");
}

/* Read an angle in eighths of a turn; `out` stays where none is given. Other parts of a turn are
 * taken where rotations near maps are. */
static graze_status read_eighths(fmpq_t out, scad_writer *w, const scad_place *p,
                                 const char *name) {
    field value;
    if (!scad_value(&value, p, name))
        return GRAZE_OK;
    TRY(scad_number(out, p, value));
    fmpz_mul_ui(fmpq_denref(out), fmpq_denref(out), 45);
    fmpq_canonicalise(out);
    int near = !fmpz_is_one(fmpq_denref(out));
    w->turned += (size_t)near;
    if ((near && !w->choice->near_rotation) || fmpz_bits(fmpq_denref(out)) > 50 ||
        fmpq_cmp_si(out, 8) > 0 || fmpq_cmp_si(out, -8) < 0)
        return scad_fail(p, GRAZE_EINPUT,
                         "only whole turns and eighths of a turn are taken; expected angle = 360, "
                         "or multiples of 45 for angle and start, or near_rotation: graze convert "
                         "--near-rotation takes other angles");
    return GRAZE_OK;
}

static graze_status write_revolution(scad_writer *w, const scad_place *p) {
    size_t sides, turned = w->turned;
    LOCAL_VEC(fmpq, angle, 2);
    fmpq *count = angle, *from = angle + 1;
    fmpq_set_si(count, 8, 1);
    TRY(scad_known(p, "angle start convexity"));
    TRY(scad_sides(&sides, w, p));
    if (sides > 0)
        return scad_fail(p, GRAZE_EINPUT,
                         "a turn of %zu sides is not taken; expected --smooth of at most as many",
                         sides);
    TRY(read_eighths(count, w, p, "angle"));
    int part = fmpq_cmp_si(count, 8) < 0 && fmpq_cmp_si(count, -8) > 0;
    if (part)
        TRY(read_eighths(from, w, p, "start"));
    int near = w->turned > turned;
    TRY(find_side(w, p));
    if (fmpq_sgn(count) < 0)
        fmpq_add(from, from, count);
    fmpq_add_si(from, from, fmpq_sgn(w->map) < 0 ? 4 : 0);
    fmpq_abs(count, count);
    if (part) {
        scad_open(w, p, "intersection", '[');
        put_wedge(w, from, count);
    }
    w->form = SCAD_REVOLVED;
    TRY(write_operands(w, p));
    w->form = SCAD_ITSELF;
    reset_map(w, 1);
    if (part)
        json_ends(&w->json, "]}");
    if (near) {
        fmpq_div_2exp(angle, w->reach, 59); /* the wedge's sides are within 2^-60 */
        fmpq_add(w->moved, w->moved, angle);
    }
    return GRAZE_OK;
}

/* Read how an extrusion moves an outline to its top, and how it scales it. */
static graze_status read_extrusion(fmpq *along, scad_writer *w, const scad_place *p) {
    LOCAL_VEC(fmpq, twist, 2);
    fmpq *height = twist + 1;
    field value;
    TRY(scad_known(p, "height center convexity twist slices segments scale v"));
    TRY(scad_size(height, p, "height"));
    if (scad_value(&value, p, "twist"))
        TRY(scad_number(twist, p, value));
    if (scad_value(&value, p, "scale")) {
        int both = *value.start != '[';
        TRY(both ? scad_number(w->scale, p, value) : scad_vector(w->scale, p, value, 2));
        if (both)
            fmpq_set(w->scale + 1, w->scale);
    }
    if (!fmpq_is_zero(twist) || fmpq_sgn(w->scale) < 0 || fmpq_sgn(w->scale + 1) < 0)
        return scad_fail(p, GRAZE_EINPUT, "expected no twist, and a scale that is not negative");
    fmpq_one(along + 2);
    if (scad_value(&value, p, "v"))
        TRY(scad_vector(along, p, value, 3));
    for (int i = 0; i < 3; i++)
        fmpq_mul(along + i, along + i, height);
    return fmpq_sgn(along + 2) > 0 ? GRAZE_OK
                                   : scad_fail(p, GRAZE_EINPUT, "expected a v that leads upwards");
}

static graze_status write_prism(scad_writer *w, const scad_place *p) {
    LOCAL_VEC(fmpq, frame, 14);
    fmpq *along = frame + 6, *far = frame + 12, *most = frame + 13, *high = w->height + 1;
    TRY(read_extrusion(along, w, p));
    scad_hold(far, along, 3);
    fmpq_set(high, along + 2);
    int sheared = !fmpq_is_zero(along) || !fmpq_is_zero(along + 1);
    fmpq_one(frame);
    fmpq_one(frame + 4);
    for (int i = 0; i < 3; i++)
        fmpq_div(along + i, along + i, high);
    if (scad_flag(p, "center")) {
        fmpq_div_2exp(high, high, 1);
        fmpq_neg(w->height, high);
    }
    if (sheared)
        scad_put_frame(w, p, frame);
    w->form = SCAD_PRISM;
    TRY(write_operands(w, p));
    w->form = SCAD_ITSELF;
    if (sheared)
        json_ends(&w->json, "}}");
    fmpq_one(most);
    scad_hold(most, w->scale, 1);
    scad_hold(most, w->scale + 1, 1);
    fmpq_mul(w->moved, w->moved, most);
    fmpq_mul(w->reach, w->reach, most);
    fmpq_add(w->reach, w->reach, far);
    fmpq_zero(w->height);
    for (int i = 0; i < 2; i++)
        fmpq_one(w->scale + i);
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
    if (role < SCAD_HULL)
        return write_operands(w, &p);
    TRY(w->file->node[node].dimension == 3 ? scad_write_body(w, &p) : scad_write_outline(w, &p));
    return context_work(w->context, 16);
}

/* As scad_writer.part. Of the writer around it only what is counted changes. */
static graze_status write_part(text *out, scad_writer *around, size_t node, int inner) {
    LOCAL_VEC(fmpq, v, 12);
    scad_writer w = *around;
    w.json = (json_writer){.out = out};
    w.line = 1;
    w.key = "solid";
    w.dimension = inner ? 2 : w.file->node[node].dimension;
    w.form = SCAD_ITSELF;
    w.height = v;
    w.map = v + 4;
    w.reach = v + 10;
    w.moved = v + 11;
    w.scale = v + 2;
    for (int i = 0; i < 2; i++)
        fmpq_one(w.scale + i);
    w.turned = w.round = w.sided = 0;
    reset_map(&w, 1);
    json_open(&w.json, NULL, '{');
    json_count(&w.json, "dimension", (unsigned long)w.dimension);
    TRY(inner ? write_operands(&w, &(scad_place){w.file, w.context, node}) : write_node(&w, node));
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
                    w->sided, w->file->nothing.parts);
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

static void put_note(text *note, const scad_nothing *n, const char *what) {
    if (n->parts)
        text_format(note, "%sparts that are %s: %zu, in line %zu the first",
                    note->length > 0 ? "; " : "", what, n->parts, n->first);
}

graze_status scad_write(text *out, text *report, text *note, graze_context *context,
                        const char *source, const char *bytes, size_t length,
                        const scad_choice *choice) {
    ZEROED(scad, file);
    LOCAL(fmpq, moved);
    TRY(scad_parse(&file, context, source, bytes, length));
    scad_writer w = {
        .file = &file, .context = context, .choice = choice, .moved = moved, .part = write_part};
    TRY(write_part(out, &w, file.root, 0));
    text_put(out, "\n");
    put_report(report, &w);
    put_note(note, &file.nothing, "empty, of size zero or by a singular map");
    put_note(note, &file.mixed, "of another dimension than those before them, taken as empty");
    return GRAZE_OK;
}
