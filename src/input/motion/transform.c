/* Transforms of a motion file: JSON to affine maps over a stretch of a piece.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/motion/affine.h"

#include "base/context/array.h"
#include "base/context/scope.h"

enum { MATRIX, TRANSLATE, ROTATE, TURN, QUATERNION, SCALE, COMPOSE, KINDS, CENTER = KINDS, KEYS };

/* A transform's one kind, the value under its key, and its center or NULL. */
typedef struct form {
    int kind;
    const json *value, *center;
} form;

static graze_status read_form(form *out, graze_context *context, const json *transform) {
    static const char *const names[KEYS] = {
        [MATRIX] = "matrix",   [TRANSLATE] = "translate",   [ROTATE] = "rotate",
        [TURN] = "turn",       [QUATERNION] = "quaternion", [SCALE] = "scale",
        [COMPOSE] = "compose", [CENTER] = "center"};
    const json *member[KEYS];
    TRY(json_members(member, context, transform, names, KEYS));
    *out = (form){.kind = KINDS, .center = member[CENTER]};
    for (int kind = 0; kind < KINDS; kind++) {
        if (member[kind] != NULL && out->value != NULL)
            return json_fail(context, GRAZE_EINPUT, transform,
                             "%s and %s exclude each other; combine them by compose",
                             names[out->kind], names[kind]);
        if (member[kind] != NULL) {
            out->kind = kind;
            out->value = member[kind];
        }
    }
    if (out->value == NULL)
        return json_fail(
            context, GRAZE_EINPUT, transform,
            "no transform; expected one of matrix, translate, rotate, turn, quaternion, scale, "
            "compose");
    if (out->center != NULL && out->kind != QUATERNION && out->kind != SCALE)
        return json_fail(context, GRAZE_EINPUT, out->center,
                         "center stands beside quaternion or scale, or inside rotate or turn, not "
                         "beside %s",
                         names[out->kind]);
    return GRAZE_OK;
}

void cut_list_clear(cut_list *cuts) {
    free(cuts->place);
}

static int compare_places(const void *a, const void *b) {
    const cut_place *p = a, *q = b;
    unsigned __int128 left = (unsigned __int128)p->part * q->of;
    unsigned __int128 right = (unsigned __int128)q->part * p->of;
    return (left > right) - (left < right);
}

/* Add 0/n, 1/n, ..., n/n. */
static graze_status add_cuts(cut_list *cuts, graze_context *context, size_t n) {
    TRY(array_grow(context, &cuts->place, &cuts->capacity, cuts->count + n + 1, sizeof *cuts->place,
                   "the cuts of a piece"));
    for (size_t k = 0; k <= n; k++)
        cuts->place[cuts->count++] = (cut_place){k, n};
    cuts->count = array_sort_once(cuts->place, cuts->count, sizeof *cuts->place, compare_places);
    return GRAZE_OK;
}

/* Is 1/n among the sorted cuts? It then came from n or a multiple of n, and all k/n are there. */
static int has_cuts(const cut_list *cuts, size_t n) {
    const cut_place first = {1, n};
    return bsearch(&first, cuts->place, cuts->count, sizeof first, compare_places) != NULL;
}

static graze_status cut_turn(cut_list *cuts, graze_context *context, const json *turn) {
    unsigned long limit = context->limits[GRAZE_LIMIT_PIECES];
    LOCAL(fmpz, quarters);
    TRY(rotation_quarters(quarters, context, turn));
    fmpz_abs(quarters, quarters);
    if (fmpz_cmp_ui(quarters, limit) > 0)
        return json_at(context, context_limit(context, GRAZE_LIMIT_PIECES, "quarters"), turn);
    if (!fmpz_is_zero(quarters) && !has_cuts(cuts, fmpz_get_ui(quarters)))
        TRY(add_cuts(cuts, context, fmpz_get_ui(quarters)));
    if (cuts->count - 1 > limit)
        return json_at(context, context_limit(context, GRAZE_LIMIT_PIECES, "parts cut by turns"),
                       turn);
    return GRAZE_OK;
}

static graze_status collect_cuts(cut_list *cuts, graze_context *context, const json *transform) {
    form f;
    TRY(read_form(&f, context, transform));
    if (f.kind == TURN)
        return cut_turn(cuts, context, f.value);
    if (f.kind == COMPOSE) {
        TRY(json_array(context, f.value, 0));
        for (const json *step = f.value->first; step != NULL; step = step->next)
            TRY(collect_cuts(cuts, context, step));
    }
    return GRAZE_OK;
}

graze_status transform_cuts(cut_list *cuts, graze_context *context, const json *transform) {
    TRY(add_cuts(cuts, context, 1));
    return collect_cuts(cuts, context, transform);
}

/* Check row d + 1 of a matrix, if it is written out: it can only be 0 ... 0 1. */
static graze_status check_last_row(graze_context *context, const json *row, const stretch *part) {
    int d = part->dimension;
    TRY(json_array(context, row, (size_t)d + 1));
    LOCAL(fmpz_poly_q, entry);
    const json *item = row->first;
    for (int j = 0; j <= d; j++, item = item->next) {
        TRY(entry_function(entry, context, item, part));
        if (!(j < d ? fmpz_poly_q_is_zero(entry) : fmpz_poly_q_is_one(entry)))
            return json_fail(context, GRAZE_EINPUT, item,
                             "the last row of a matrix is 0 ... 0 1; expected %d here", j == d);
    }
    return GRAZE_OK;
}

static graze_status check_regular(affine *a, graze_context *context, const json *where,
                                  const stretch *part) {
    calculation c = {context, GRAZE_OK};
    LOCAL(fmpz_poly_q, determinant);
    affine_determinant(&c, determinant, a);
    TRY(c.status);
    return entry_no_root(context, where, fmpz_poly_q_numref(determinant), part->lo, part->hi,
                         "the determinant is zero");
}

static graze_status read_matrix(affine *out, graze_context *context, const json *value,
                                const stretch *part) {
    int d = part->dimension;
    TRY(json_array(context, value, 0));
    if (value->count != (size_t)d && value->count != (size_t)d + 1)
        return json_fail(context, GRAZE_EINPUT, value,
                         "expected a matrix of %d or %d rows, not %zu", d, d + 1, value->count);
    const json *row = value->first;
    for (int i = 0; i < d; i++, row = row->next)
        TRY(entry_vector(out->entry + i * (d + 1), context, row, (size_t)d + 1, part));
    if (row != NULL)
        TRY(check_last_row(context, row, part));
    return part->fault == FAULT_SINGULAR ? check_regular(out, context, value, part) : GRAZE_OK;
}

static graze_status read_translation(affine *out, graze_context *context, const json *value,
                                     const stretch *part) {
    int d = part->dimension;
    TRY(json_array(context, value, (size_t)d));
    const json *item = value->first;
    for (int i = 0; i < d; i++, item = item->next)
        TRY(entry_finite(affine_at(out, i, d), context, item, part));
    return GRAZE_OK;
}

static graze_status read_scale(affine *out, graze_context *context, const json *value,
                               const stretch *part) {
    int d = part->dimension;
    int each = value->kind == JSON_ARRAY;
    TRY(each ? json_array(context, value, (size_t)d) : GRAZE_OK);
    const json *item = each ? value->first : value;
    for (int i = 0; i < d; i++, item = each ? item->next : item) {
        fmpz_poly_q_struct *factor = affine_at(out, i, i);
        TRY(entry_finite(factor, context, item, part));
        if (part->fault == FAULT_SINGULAR)
            TRY(entry_no_root(context, item, fmpz_poly_q_numref(factor), part->lo, part->hi,
                              "the scale is zero"));
    }
    return GRAZE_OK;
}

/* A product of consecutive steps of compose. */
typedef struct run {
    size_t steps;
    affine map;
} run;

/* Join the last two runs into one. */
static void join_runs(calculation *c, run *runs, size_t *count, const json *item) {
    run *earlier = runs + *count - 2, *later = earlier + 1;
    affine_multiply(c, &earlier->map, &later->map, &earlier->map);
    if (c->status != GRAZE_OK)
        json_at(c->context, c->status, item);
    earlier->steps += later->steps;
    affine_clear(&later->map);
    --*count;
}

/* Runs with equal numbers of steps are joined, as in a binary counter: each of n steps then takes
 * part in about log n products instead of n, which matters if products grow long. */
static graze_status compose_runs(affine *out, graze_context *context, const json *value,
                                 const stretch *part, run *runs) {
    calculation c = {context, GRAZE_OK};
    size_t count = 0;
    for (const json *item = value->first; item != NULL && c.status == GRAZE_OK; item = item->next) {
        affine_init(&runs[count].map, part->dimension);
        runs[count].steps = 1;
        c.status = transform_map(&runs[count++].map, context, item, part);
        while (c.status == GRAZE_OK && count > 1 && runs[count - 2].steps == runs[count - 1].steps)
            join_runs(&c, runs, &count, item);
    }
    while (c.status == GRAZE_OK && count > 1)
        join_runs(&c, runs, &count, value->last);
    if (c.status == GRAZE_OK && count == 1)
        affine_set(out, &runs[0].map);
    while (count > 0)
        affine_clear(&runs[--count].map);
    return c.status;
}

static graze_status read_compose(affine *out, graze_context *context, const json *value,
                                 const stretch *part) {
    TRY(json_array(context, value, 0));
    /* The number of steps of each run is a power of two, and only the newest run may have as many
     * as another. */
    size_t most = 2;
    for (size_t n = value->count; n > 0; n /= 2)
        most++;
    FREED(run, runs, malloc(most * sizeof *runs));
    if (runs == NULL)
        return context_fail(context, GRAZE_ESYSTEM, "no memory for the steps of a transform");
    return compose_runs(out, context, value, part, runs);
}

graze_status transform_map(affine *out, graze_context *context, const json *transform,
                           const stretch *part) {
    static graze_status (*const read[KINDS])(affine *, graze_context *, const json *,
                                             const stretch *) = {[MATRIX] = read_matrix,
                                                                 [TRANSLATE] = read_translation,
                                                                 [ROTATE] = rotation_by_tangent,
                                                                 [TURN] = rotation_by_quarters,
                                                                 [QUATERNION] =
                                                                     rotation_by_quaternion,
                                                                 [SCALE] = read_scale,
                                                                 [COMPOSE] = read_compose};
    form f;
    TRY(read_form(&f, context, transform));
    affine_identity(out);
    TRY(read[f.kind](out, context, f.value, part));
    return f.center != NULL ? about_center(out, context, f.center, part) : GRAZE_OK;
}
