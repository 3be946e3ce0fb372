/* The public function of tools, cylinders, balls and boxes.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "api/api.h"

#include "input/convert/convert.h"

/* Take a number over and check that its sign is at least `least`; NULL gives 0. */
static graze_status take_number(fmpq_t out, graze_context *context, mpq_srcptr value, int least,
                                const char *name) {
    TRY(value ? api_rational(out, context, value) : GRAZE_OK);
    if (fmpq_sgn(out) < least)
        return context_fail(context, GRAZE_EUSE, "%s: expected a number %s", name,
                            least ? "above 0" : "from 0 up");
    return GRAZE_OK;
}

/* Hand over the texts that the caller asked for; after a failure none. */
static graze_status finish_shape(char **const to[3], graze_context *context, text *made,
                                 graze_status status) {
    for (int k = 0; k < 3; k++)
        if (to[k] && !status)
            status = text_finish(to[k], context, made + k);
        else
            text_clear(made + k);
    for (int k = 0; k < 3 && status; k++)
        if (to[k]) {
            free(*to[k]);
            *to[k] = NULL;
        }
    return status;
}

/* Make the tool of a shape that is not a box. */
static graze_status take_tool(tool *s, graze_context *context, const graze_shape *given) {
    int ball = given->kind == GRAZE_SHAPE_BALL, cutter = given->kind == GRAZE_SHAPE_CUTTER;
    LOCAL_VEC(fmpq, n, TOOL_NUMBERS);
    TRY(take_number(n + TOOL_DIAMETER, context, given->diameter, 1, "diameter"));
    if (!ball)
        TRY(take_number(n + TOOL_LENGTH, context, given->length, 1, "length"));
    if (cutter)
        TRY(take_number(n + TOOL_CORNER, context, given->corner, 0, "corner"));
    if (cutter && given->taper)
        TRY(api_rational(n + TOOL_TAPER, context, given->taper));
    return tool_take(s, context, n, ball);
}

static graze_status make_round(text *made, graze_context *context, const graze_shape *given,
                               const fmpq *at, mpq_srcptr tolerance) {
    tool_pair pair = {.stretch = {{0, 1}}};
    LOCAL_VEC(fmpq, goal, 3);
    fmpq *square = goal + 1, *one = goal + 2;
    HELD(tool, s);
    fmpq_one(one);
    TRY(take_number(goal, context, tolerance, 1, "tolerance"));
    TRY(take_tool(&s, context, given));
    TRY(tool_fit(&pair, square, context, &s, goal));
    tool_write(made, &pair.in, &pair, one, at);
    tool_write(made + 1, &pair.out, &pair, pair.stretch, at);
    tool_report(made + 2, &pair, square);
    tool_pair_clear(&pair);
    return GRAZE_OK;
}

static graze_status take_sides(fmpq *size, graze_context *context, const graze_shape *given) {
    for (int k = 0; k < 3; k++)
        TRY(take_number(size + k, context, given->box[k], 1, "a side of the box"));
    return GRAZE_OK;
}

static graze_status make_box(text *made, graze_context *context, const graze_shape *given,
                             const fmpq *at) {
    LOCAL_VEC(fmpq, size, 3);
    TRY(take_sides(size, context, given));
    for (int k = 0; k < 2; k++)
        tool_write_box(made + k, size, at);
    text_put(made + 2, "exact: 8 vertices, 6 facets\n");
    return GRAZE_OK;
}

/* Check what every shape needs, and initialise three texts and the shape's place; the caller clears
 * them. */
static graze_status begin_shape(fmpq *at, text *made, graze_context *context, const char *name,
                                const graze_shape *shape) {
    int ball = shape->kind == GRAZE_SHAPE_BALL, box = shape->kind == GRAZE_SHAPE_BOX;
    for (int k = 0; k < 3; k++)
        text_init(made + k);
    if (shape->kind > GRAZE_SHAPE_CUTTER)
        return api_misuse(context, name, "the kind is not a graze_shape_kind");
    if (box ? !shape->box : !shape->diameter || (!ball && !shape->length))
        return api_misuse(context, name, "a box has three sides, other shapes diameter and length");
    for (int k = 0; k < 3 && shape->at; k++)
        TRY(api_rational(at + k, context, shape->at[k]));
    return GRAZE_OK;
}

graze_status graze_solid_write_shape(char **inside, char **outside, char **report,
                                     graze_context *context, const graze_shape *shape,
                                     mpq_srcptr tolerance) {
    char **const to[3] = {inside, outside, report};
    EMPTY(inside);
    EMPTY(outside);
    EMPTY(report);
    PUBLIC(context, shape);
    int box = shape->kind == GRAZE_SHAPE_BOX;
    REFUSED(!box && !tolerance, "a shape that is no box needs a tolerance");
    LOCAL_VEC(fmpq, at, 3);
    text made[3];
    graze_status status = begin_shape(at, made, context, __func__, shape);
    if (!status)
        status = box ? make_box(made, context, shape, at)
                     : make_round(made, context, shape, at, tolerance);
    return finish_shape(to, context, made, status);
}

/* Write the node of a shape, and report what is not exact in it. */
static graze_status write_body(text *made, text *report, graze_context *context,
                               const graze_shape *given) {
    LOCAL_VEC(fmpq, size, 3);
    HELD(tool, s);
    int box = given->kind == GRAZE_SHAPE_BOX;
    TRY(box ? take_sides(size, context, given) : take_tool(&s, context, given));
    if (box)
        tool_csg_write_box(made, size);
    else
        tool_csg_write(made, &s);
    text_put(report, fmpq_equal(s.low + 1, s.high + 1)
                         ? "exact\n"
                         : "exact but for the taper, which is less by at most 1e-9 degrees\n");
    return GRAZE_OK;
}

graze_status graze_solid_write_exact_shape(char **out, char **report, graze_context *context,
                                           const graze_shape *shape) {
    char **const to[3] = {out, NULL, report};
    EMPTY(report);
    PUBLIC_OUT(out, context, shape);
    LOCAL_VEC(fmpq, at, 3);
    text made[3];
    graze_status status = begin_shape(at, made, context, __func__, shape);
    int still = fmpq_is_zero(at) && fmpq_is_zero(at + 1) && fmpq_is_zero(at + 2);
    const fmpq *moved = still ? NULL : at;
    tool_csg_begin(made, moved);
    if (!status)
        status = write_body(made, made + 2, context, shape);
    tool_csg_end(made, moved);
    return finish_shape(to, context, made, status);
}
