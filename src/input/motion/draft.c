/* Motions in the making: pieces with rational functions as entries, not yet point maps.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/motion/draft.h"

#include "base/context/array.h"
#include "base/context/scope.h"

void draft_init(draft *d, int dimension) {
    *d = (draft){.dimension = dimension};
}

static void clear_map(draft_piece *piece) {
    if (piece->rigid)
        common_map_clear(&piece->frame);
    else
        affine_clear(&piece->map);
}

void draft_clear(draft *d) {
    for (size_t k = 0; k < d->count; k++) {
        fmpq_clear(d->piece[k].lo);
        fmpq_clear(d->piece[k].hi);
        clear_map(&d->piece[k]);
    }
    free(d->piece);
    *d = (draft){.dimension = d->dimension};
}

graze_status draft_append(draft_piece **out, graze_context *context, draft *d, int rigid) {
    if (d->count >= context->limits[GRAZE_LIMIT_PIECES])
        return context_limit(context, GRAZE_LIMIT_PIECES, "pieces of a motion");
    TRY(context_poll(context));
    TRY(array_grow(context, &d->piece, &d->capacity, d->count + 1, sizeof *d->piece,
                   "the pieces of a motion"));
    draft_piece *piece = *out = &d->piece[d->count++];
    fmpq_init(piece->lo);
    fmpq_init(piece->hi);
    piece->row = 0;
    piece->rigid = rigid;
    if (rigid) {
        common_map_init(&piece->frame);
        piece->frame.dimension = d->dimension;
    } else {
        affine_init(&piece->map, d->dimension);
    }
    return GRAZE_OK;
}

graze_status draft_spread(draft *d, graze_context *context) {
    calculation c = {context, GRAZE_OK};
    for (size_t k = 0; k < d->count && c.status == GRAZE_OK; k++) {
        draft_piece *piece = &d->piece[k];
        if (piece->rigid) {
            affine map;
            affine_init(&map, d->dimension);
            common_map_to_affine(&c, &map, &piece->frame);
            common_map_clear(&piece->frame);
            piece->map = map;
            piece->rigid = 0;
        }
    }
    return c.status;
}

/* The share (t - lo) / (hi - lo) of a time in an interval. */
static void interval_share(fmpq_t out, const fmpq_t t, const fmpq_t lo, const fmpq_t hi) {
    LOCAL(fmpq, span);
    fmpq_sub(span, hi, lo);
    fmpq_sub(out, t, lo);
    fmpq_div(out, out, span);
}

/* Set `out` to a piece's map over [lo, hi], with a parameter that runs from 0 to 1 there. */
static void cut_map(calculation *c, affine *out, const draft_piece *piece, const fmpq_t lo,
                    const fmpq_t hi) {
    LOCAL_VEC(fmpq, low, 2);
    fmpq *high = low + 1;
    interval_share(low, lo, piece->lo, piece->hi);
    interval_share(high, hi, piece->lo, piece->hi);
    if (fmpq_is_zero(low) && fmpq_is_one(high))
        affine_set(out, &piece->map);
    else
        affine_substitute(c, out, &piece->map, low, high);
}

/* Append the piece frame^-1 moving over [lo, hi], which lies in both pieces. */
static graze_status relative_piece(draft *out, graze_context *context, const draft_piece *moving,
                                   const draft_piece *frame, const fmpq_t lo, const fmpq_t hi) {
    draft_piece *piece;
    TRY(draft_append(&piece, context, out, 0));
    calculation c = {context, GRAZE_OK};
    HELD(common_map, common);
    HELD(affine, part, out->dimension);
    HELD(affine, inverse, out->dimension);
    fmpq_set(piece->lo, lo);
    fmpq_set(piece->hi, hi);
    piece->row = moving->row ? moving->row : frame->row;
    cut_map(&c, &part, frame, lo, hi);
    if (c.status == GRAZE_OK) {
        common_map_from_affine(&c, &common, &part);
        affine_inverse(&c, &inverse, &part, common_map_is_orthogonal(&c, &common));
        cut_map(&c, &part, moving, lo, hi);
        affine_multiply(&c, &piece->map, &inverse, &part);
    }
    return c.status;
}

graze_status draft_relative(draft *out, graze_context *context, const draft *moving,
                            const draft *frame) {
    const fmpq *a_lo = moving->piece[0].lo, *b_lo = frame->piece[0].lo;
    LOCAL(fmpq, lo);
    fmpq_set(lo, fmpq_cmp(a_lo, b_lo) > 0 ? a_lo : b_lo);
    for (size_t m = 0, f = 0; m < moving->count && f < frame->count;) {
        const draft_piece *a = &moving->piece[m], *b = &frame->piece[f];
        int order = fmpq_cmp(a->hi, b->hi);
        const fmpq *hi = order <= 0 ? a->hi : b->hi;
        TRY(relative_piece(out, context, a, b, lo, hi));
        fmpq_set(lo, hi);
        m += order <= 0;
        f += order >= 0;
    }
    return GRAZE_OK;
}

graze_status draft_follow(draft *out, graze_context *context, const draft *next, slong from,
                          affine *end) {
    calculation c = {context, GRAZE_OK};
    const fmpq *first = next->piece[0].lo, *last_hi = next->piece[next->count - 1].hi;
    LOCAL(fmpq, one);
    HELD(affine, last, out->dimension);
    fmpq_one(one);
    for (size_t k = 0; k < next->count && c.status == GRAZE_OK; k++) {
        const draft_piece *piece = &next->piece[k];
        draft_piece *copy;
        TRY(draft_append(&copy, context, out, 0));
        interval_share(copy->lo, piece->lo, first, last_hi);
        fmpq_add_si(copy->lo, copy->lo, from);
        interval_share(copy->hi, piece->hi, first, last_hi);
        fmpq_add_si(copy->hi, copy->hi, from);
        copy->row = piece->row;
        affine_multiply(&c, &copy->map, &piece->map, end);
    }
    affine_at_time(&last, &next->piece[next->count - 1].map, one);
    affine_multiply(&c, end, &last, end);
    return c.status;
}

/* Set `out` to the point map of the inverse of a, computed with quotients. */
static void invert_quotients(calculation *c, point_map *out, const affine *a) {
    HELD(affine, inverse, a->dimension);
    HELD(common_map, common);
    affine_inverse(c, &inverse, a, 0);
    common_map_from_affine(c, &common, &inverse);
    common_map_forward(c, out, &common);
}

static void finish_map(calculation *c, motion_piece *out, const affine *map) {
    HELD(common_map, common);
    common_map_from_affine(c, &common, map);
    common_map_forward(c, &out->forward, &common);
    if (common_map_is_orthogonal(c, &common))
        common_map_backward(c, &out->inverse, &common);
    else if (c->status == GRAZE_OK)
        invert_quotients(c, &out->inverse, map);
}

static graze_status finish_piece(motion_piece *out, graze_context *context,
                                 const draft_piece *piece) {
    calculation c = {context, GRAZE_OK};
    fmpq_set(out->lo, piece->lo);
    fmpq_set(out->hi, piece->hi);
    out->row = piece->row;
    if (piece->rigid) {
        common_map_forward(&c, &out->forward, &piece->frame);
        common_map_backward(&c, &out->inverse, &piece->frame);
    } else {
        finish_map(&c, out, &piece->map);
    }
    return c.status;
}

graze_status draft_finish(graze_motion **out, graze_context *context, const draft *d) {
    *out = NULL;
    graze_motion *motion = calloc(1, sizeof *motion);
    motion_piece *piece = calloc(d->count, sizeof *piece);
    if (motion == NULL || piece == NULL) {
        free(motion);
        free(piece);
        return context_fail(context, GRAZE_ESYSTEM, "no memory for a motion");
    }
    motion->dimension = d->dimension;
    motion->piece = piece;
    graze_status status = GRAZE_OK;
    while (motion->piece_count < d->count && status == GRAZE_OK) {
        motion_piece *next = &piece[motion->piece_count];
        fmpq_init(next->lo);
        fmpq_init(next->hi);
        point_map_init(&next->forward, d->dimension);
        point_map_init(&next->inverse, d->dimension);
        status = context_poll(context);
        if (status == GRAZE_OK)
            status = finish_piece(next, context, &d->piece[motion->piece_count]);
        motion->has_rows |= next->row > 0;
        motion->piece_count++;
    }
    if (status != GRAZE_OK) {
        motion_destroy(motion);
        return status;
    }
    *out = motion;
    return GRAZE_OK;
}

/* Append a piece, with the forward map's entries as quotients. */
static graze_status add_copy(draft *out, graze_context *context, const motion_piece *piece) {
    draft_piece *made;
    TRY(draft_append(&made, context, out, 0));
    for (int k = 0; k < out->dimension * (out->dimension + 1); k++) {
        fmpz_poly_set(fmpz_poly_q_numref(made->map.entry[k]), &piece->forward.entry[k]);
        fmpz_poly_set(fmpz_poly_q_denref(made->map.entry[k]), piece->forward.weight);
        quotient_reduce(made->map.entry[k]);
    }
    fmpq_set(made->lo, piece->lo);
    fmpq_set(made->hi, piece->hi);
    made->row = piece->row;
    return GRAZE_OK;
}

/* Append the pieces of a motion that run within the times of another one. */
static graze_status copy_common(draft *out, graze_context *context, const graze_motion *motion,
                                const graze_motion *other) {
    const fmpq *lo = other->piece[0].lo, *hi = other->piece[other->piece_count - 1].hi;
    for (size_t k = 0; k < motion->piece_count; k++)
        if (fmpq_cmp(motion->piece[k].lo, hi) < 0 && fmpq_cmp(motion->piece[k].hi, lo) > 0)
            TRY(add_copy(out, context, &motion->piece[k]));
    return GRAZE_OK;
}

graze_status motion_relative(graze_motion **out, graze_context *context, const graze_motion *moving,
                             const graze_motion *frame) {
    *out = NULL;
    if (moving->dimension != frame->dimension)
        return context_fail(context, GRAZE_EILLEGAL,
                            "the motions have dimensions %d and %d; expected one dimension",
                            moving->dimension, frame->dimension);
    HELD(draft, a, moving->dimension);
    HELD(draft, b, moving->dimension);
    HELD(draft, relative, moving->dimension);
    TRY(copy_common(&a, context, moving, frame));
    if (a.count == 0)
        return context_fail(context, GRAZE_EILLEGAL,
                            "the motions have no interval of time in common");
    TRY(copy_common(&b, context, frame, moving));
    TRY(draft_relative(&relative, context, &a, &b));
    return draft_finish(out, context, &relative);
}
