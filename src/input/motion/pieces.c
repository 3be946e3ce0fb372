/* Motions from parsed JSON: pieces and keyframes, and the check that a piece is legal.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/motion/draft.h"

#include <stdio.h>
#include "base/context/scope.h"
#include "base/number/rational.h"

enum { NUMBER_SIZE = 60 };

static void number_text(char out[NUMBER_SIZE], const fmpq_t value) {
    char *text = rational_text(value);
    snprintf(out, NUMBER_SIZE, "%s", text != NULL ? text : "?");
    free(text);
}

static graze_status check_poles(draft_piece *piece, graze_context *context, const json *where) {
    int d = piece->map.dimension;
    for (int k = 0; k < d * (d + 1); k++)
        TRY(entry_no_root(context, where, fmpz_poly_q_denref(piece->map.entry[k]), piece->lo,
                          piece->hi, "the motion's matrix has a pole"));
    return GRAZE_OK;
}

static graze_status check_determinant(draft_piece *piece, graze_context *context,
                                      const json *where) {
    calculation c = {context, GRAZE_OK};
    LOCAL(fmpz_poly_q, determinant);
    affine_determinant(&c, determinant, &piece->map);
    TRY(json_at(context, c.status, where));
    return entry_no_root(context, where, fmpz_poly_q_numref(determinant), piece->lo, piece->hi,
                         "the determinant of the motion's linear part is zero");
}

static graze_status check_joint(const draft_piece *before, const draft_piece *after,
                                graze_context *context, const json *where) {
    int d = before->map.dimension;
    LOCAL_VEC(fmpq, zero, 4);
    fmpq *one = zero + 1, *end = zero + 2, *start = zero + 3;
    fmpq_one(one);
    for (int k = 0; k < d * (d + 1); k++) {
        quotient_at(end, before->map.entry[k], one);
        quotient_at(start, after->map.entry[k], zero);
        if (!fmpq_equal(end, start)) {
            char time[NUMBER_SIZE], from[NUMBER_SIZE], to[NUMBER_SIZE];
            number_text(time, after->lo);
            number_text(from, end);
            number_text(to, start);
            return json_fail(context, GRAZE_EILLEGAL, where,
                             "the motion jumps at t = %s: row %d, column %d of its matrix goes "
                             "from %s to %s",
                             time, k / (d + 1) + 1, k % (d + 1) + 1, from, to);
        }
    }
    return GRAZE_OK;
}

/* The map is illegal and the context has a message. Some entry has the same fault, since a pole of
 * a product is a pole of a factor, and a zero of its determinant one of a factor's determinant. The
 * transform is read once more to find this entry and name it in the message. */
static graze_status blame(affine *map, graze_context *context, const json *transform, stretch *part,
                          entry_fault fault) {
    part->fault = fault;
    TRY(transform_map(map, context, transform, part));
    return GRAZE_EILLEGAL;
}

static graze_status read_stretch(draft *out, graze_context *context, const json *transform,
                                 stretch *part) {
    draft_piece *piece;
    TRY(json_at(context, draft_append(&piece, context, out, 0), transform));
    fmpq_set(piece->lo, part->lo);
    fmpq_set(piece->hi, part->hi);
    TRY(json_at_last(context, transform_map(&piece->map, context, transform, part), transform));
    graze_status status = check_poles(piece, context, transform);
    if (status == GRAZE_EILLEGAL)
        return blame(&piece->map, context, transform, part, FAULT_POLE);
    status = check_determinant(piece, context, transform);
    if (status == GRAZE_EILLEGAL)
        return blame(&piece->map, context, transform, part, FAULT_SINGULAR);
    return status == GRAZE_OK && out->count > 1 ? check_joint(piece - 1, piece, context, transform)
                                                : status;
}

static graze_status read_transform(draft *out, graze_context *context, const json *transform,
                                   const fmpq_t lo, const fmpq_t hi) {
    ZEROED(cut_list, cuts);
    HELD(stretch, part, out->dimension);
    TRY(transform_cuts(&cuts, context, transform));
    for (size_t k = 0; k + 1 < cuts.count; k++) {
        stretch_set(&part, lo, hi, &cuts.place[k]);
        TRY(read_stretch(out, context, transform, &part));
    }
    return GRAZE_OK;
}

/* Read the interval of a piece, which must begin where the piece before it ends. */
static graze_status read_interval(fmpq_t lo, fmpq_t hi, graze_context *context, const json *value,
                                  const draft *before) {
    char first[NUMBER_SIZE], last[NUMBER_SIZE];
    TRY(json_array(context, value, 2));
    TRY(entry_number(lo, context, value->first));
    TRY(entry_number(hi, context, value->last));
    number_text(first, lo);
    if (fmpq_cmp(lo, hi) >= 0) {
        number_text(last, hi);
        return json_fail(context, GRAZE_EILLEGAL, value,
                         "the piece starts at %s and ends at %s; expected a later end", first,
                         last);
    }
    if (before->count > 0 && !fmpq_equal(lo, before->piece[before->count - 1].hi)) {
        number_text(last, before->piece[before->count - 1].hi);
        return json_fail(context, GRAZE_EILLEGAL, value,
                         "the piece starts at %s, but the one before it ends at %s", first, last);
    }
    return GRAZE_OK;
}

/* Read the line of a log; 0 if there is none. */
static graze_status read_row(unsigned long *out, graze_context *context, const json *value) {
    static const unsigned long most = 1000000000000000;
    *out = 0;
    if (value == NULL)
        return GRAZE_OK;
    LOCAL(fmpz, row);
    TRY(entry_integer(row, context, value));
    if (fmpz_sgn(row) <= 0 || fmpz_cmp_ui(row, most) > 0)
        return json_fail(context, GRAZE_EINPUT, value,
                         "expected the line of a log, an integer from 1 to 10^15");
    *out = fmpz_get_ui(row);
    return GRAZE_OK;
}

static graze_status read_one_piece(draft *out, graze_context *context, const json *item) {
    static const char *const names[] = {"t", "transform", "row"};
    const json *member[3];
    unsigned long row = 0;
    size_t first = out->count;
    TRY(json_members(member, context, item, names, 3));
    if (member[0] == NULL || member[1] == NULL)
        return json_fail(context, GRAZE_EINPUT, item, "the piece has no key %s",
                         names[member[0] != NULL]);
    TRY(read_row(&row, context, member[2]));
    LOCAL_VEC(fmpq, lo, 2);
    fmpq *hi = lo + 1;
    TRY(read_interval(lo, hi, context, member[0], out));
    TRY(read_transform(out, context, member[1], lo, hi));
    for (size_t k = first; k < out->count; k++)
        out->piece[k].row = row;
    return GRAZE_OK;
}

graze_status motion_read_pieces(draft *out, graze_context *context, const json *pieces) {
    TRY(json_array(context, pieces, 0));
    if (pieces->count == 0)
        return json_fail(context, GRAZE_EINPUT, pieces, "expected at least one piece");
    for (const json *item = pieces->first; item != NULL; item = item->next)
        TRY(read_one_piece(out, context, item));
    return GRAZE_OK;
}

/* ------------------------------------------------------------------------------------ keyframes */

enum { TIME, POSITION, ROTATION, ROW, FRAME_KEYS };
enum { FRAME_NUMBERS = 8 };

/* The numbers of a keyframe; those that are not given keep the values of keyframe_init. */
typedef struct keyframe {
    fmpq *time, *position;
    fmpq *rotation;    /* w, x, y, z; in E^2 x = y = 0 */
    int given;         /* bit k is set if the frame has member k */
    unsigned long row; /* 0: none is given */
} keyframe;

static void keyframe_init(keyframe *frame) {
    fmpq *n = _fmpq_vec_init(FRAME_NUMBERS);
    *frame = (keyframe){.time = n, .position = n + 1, .rotation = n + 4};
    fmpq_one(frame->rotation);
}

static void keyframe_clear(keyframe *frame) {
    _fmpq_vec_clear(frame->time, FRAME_NUMBERS);
}

/* Read an array of `count` numbers into every `step`th entry of `out`. */
static graze_status read_numbers(fmpq *out, graze_context *context, const json *value, size_t count,
                                 size_t step) {
    TRY(json_array(context, value, count));
    const json *item = value->first;
    for (size_t k = 0; k < count; k++, item = item->next)
        TRY(entry_number(out + k * step, context, item));
    return GRAZE_OK;
}

static graze_status read_keyframe(keyframe *frame, graze_context *context, const json *value,
                                  int dimension) {
    const char *const names[] = {"t", "position", dimension == 3 ? "quaternion" : "complex", "row"};
    const json *member[FRAME_KEYS];
    TRY(json_members(member, context, value, names, FRAME_KEYS));
    if (member[TIME] == NULL)
        return json_fail(context, GRAZE_EINPUT, value, "the frame has no key t");
    frame->given = (member[POSITION] != NULL) << POSITION | (member[ROTATION] != NULL) << ROTATION;
    TRY(read_row(&frame->row, context, member[ROW]));
    TRY(entry_number(frame->time, context, member[TIME]));
    if (member[POSITION] != NULL)
        TRY(read_numbers(frame->position, context, member[POSITION], (size_t)dimension, 1));
    if (member[ROTATION] != NULL)
        TRY(dimension == 3 ? read_numbers(frame->rotation, context, member[ROTATION], 4, 1)
                           : read_numbers(frame->rotation, context, member[ROTATION], 2, 3));
    return GRAZE_OK;
}

/* Set `out` to the linear polynomials with the values from[k] at 0 and to[k] at 1, all multiplied
 * by the least common denominator of these numbers. */
static void set_lines(fmpz_poly_struct *out, fmpz_t denominator, const fmpq *from, const fmpq *to,
                      int count) {
    LOCAL_VEC(fmpz, start, 3);
    fmpz *end = start + 1, *factor = start + 2;
    fmpz_one(denominator);
    for (int k = 0; k < count; k++) {
        fmpz_lcm(denominator, denominator, fmpq_denref(from + k));
        fmpz_lcm(denominator, denominator, fmpq_denref(to + k));
    }
    for (int k = 0; k < count; k++) {
        fmpz_divexact(factor, denominator, fmpq_denref(from + k));
        fmpz_mul(start, factor, fmpq_numref(from + k));
        fmpz_divexact(factor, denominator, fmpq_denref(to + k));
        fmpz_mul(end, factor, fmpq_numref(to + k));
        fmpz_sub(end, end, start);
        fmpz_poly_zero(&out[k]);
        fmpz_poly_set_coeff_fmpz(&out[k], 1, end);
        fmpz_poly_set_coeff_fmpz(&out[k], 0, start);
    }
}

/* Append the piece between two frames. No pole, no zero determinant and no jump can occur:
 * quaternion_rotation checks the rotation, and the rest is linear between the frames. */
static graze_status append_between(draft *out, graze_context *context, const json *where,
                                   const keyframe *from, const keyframe *to) {
    draft_piece *piece;
    TRY(json_at(context, draft_append(&piece, context, out, 1), where));
    fmpq_set(piece->lo, from->time);
    fmpq_set(piece->hi, to->time);
    piece->row = to->row;
    LOCAL_VEC(fmpz_poly, q, 4);
    LOCAL(fmpz, denominator);
    set_lines(q, denominator, from->rotation, to->rotation, 4);
    graze_status status =
        quaternion_rotation(&piece->frame, context, where, q, from->time, to->time);
    json_at_last(context, status, where);
    set_lines(piece->frame.shift, denominator, from->position, to->position, out->dimension);
    fmpz_poly_set_fmpz(piece->frame.v, denominator);
    return status;
}

static graze_status read_next_frame(draft *out, graze_context *context, const json *value,
                                    keyframe *before, keyframe *frame) {
    graze_status status = read_keyframe(frame, context, value, out->dimension);
    if (status != GRAZE_OK || value->index == 0)
        return status;
    if (frame->given != before->given)
        return json_fail(context, GRAZE_EINPUT, value,
                         "this frame differs from the one before it; expected position and "
                         "rotation in all frames or in none");
    if (fmpq_cmp(before->time, frame->time) >= 0) {
        char first[NUMBER_SIZE], last[NUMBER_SIZE];
        number_text(first, before->time);
        number_text(last, frame->time);
        return json_fail(context, GRAZE_EILLEGAL, value,
                         "the time %s follows %s; expected times that grow", last, first);
    }
    return append_between(out, context, value, before, frame);
}

graze_status motion_read_keyframes(draft *out, graze_context *context, const json *keyframes) {
    TRY(json_array(context, keyframes, 0));
    if (keyframes->count < 2)
        return json_fail(context, GRAZE_EINPUT, keyframes, "expected at least two frames, not %zu",
                         keyframes->count);
    HELD(keyframe, even);
    HELD(keyframe, odd);
    keyframe *const frame[2] = {&even, &odd};
    for (const json *item = keyframes->first; item != NULL; item = item->next)
        TRY(read_next_frame(out, context, item, frame[(item->index + 1) % 2],
                            frame[item->index % 2]));
    return GRAZE_OK;
}
