/* Numbers and linear forms of the nodes of a curved solid.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/csg/csg_reader.h"

#include "base/context/scope.h"
#include "base/number/rational.h"

void csg_reader_init(csg_reader *r, graze_context *context, csg *out, int dimension) {
    *out = (csg){.dimension = dimension};
    csg_box_init(&out->box);
    r->context = context;
    r->out = out;
    r->dimension = dimension;
    fmpq_mpoly_ctx_init(r->ring, dimension, ORD_LEX);
    fmpq_mat_init(r->place, r->dimension + 1, r->dimension + 1);
    fmpq_mat_one(r->place);
    csg_box_init(&r->box);
    r->cut = _fmpq_vec_init(4 * CSG_CUTS_MOST);
    r->cuts = 0;
    r->cut_work = CSG_CUT_WORK;
    for (int k = 0; k < 10; k++)
        fmpq_mpoly_init(&r->poly[k], r->ring);
    r->coordinate = r->poly;
    r->from = r->poly + 3;
    r->square = r->poly + 6;
    r->along = r->poly + 7;
    r->f = r->poly + 8;
    r->term = r->poly + 9;
    for (int i = 0; i < dimension; i++)
        fmpq_mpoly_gen(&r->coordinate[i], i, r->ring);
}

void csg_reader_clear(csg_reader *r) {
    fmpq_mat_clear(r->place);
    csg_box_clear(&r->box);
    _fmpq_vec_clear(r->cut, 4 * CSG_CUTS_MOST);
    for (int k = 0; k < 10; k++)
        fmpq_mpoly_clear(&r->poly[k], r->ring);
    fmpq_mpoly_ctx_clear(r->ring);
}

enum { DIGITS_A_LIMB = 20 }; /* at least the decimal digits of a limb */

/* Whether an integer has more digits than the limit allows; fmpz_sizeinbase may be one too large.
 */
static int has_many_digits(const graze_context *context, const fmpz_t value) {
    size_t digits = context->limits[GRAZE_LIMIT_DIGITS];
    return (size_t)fmpz_size(value) > digits / DIGITS_A_LIMB &&
           fmpz_sizeinbase(value, 10) - 1 > digits;
}

int csg_is_long(const graze_context *context, const fmpq_t value) {
    return has_many_digits(context, fmpq_numref(value)) ||
           has_many_digits(context, fmpq_denref(value));
}

graze_status csg_read_members(const json **out, csg_reader *r, const json *value,
                              const char *const *names, size_t count, size_t needed) {
    graze_status status = json_members(out, r->context, value, names, count);
    for (size_t k = 0; k < needed && !status; k++)
        if (!out[k])
            status = json_fail(r->context, GRAZE_EINPUT, value, "the key %s is missing", names[k]);
    return status;
}

graze_status csg_in_space(csg_reader *r, const json *value) {
    return r->dimension == 3 ? GRAZE_OK
                             : json_fail(r->context, GRAZE_EINPUT, value,
                                         "this primitive is one of space; expected dimension 3");
}

graze_status csg_read_number(fmpq_t out, csg_reader *r, const json *value) {
    graze_context *context = r->context;
    int written = value->kind == JSON_NUMBER || value->kind == JSON_STRING;
    if (!written || !rational_is_token(value->text, value->length))
        return entry_number(out, context, value);
    graze_status status = rational_parse(out, context, value->text, value->length);
    return status ? json_at(context, status, value) : GRAZE_OK;
}

graze_status csg_read_vector(fmpq *out, csg_reader *r, const json *value, size_t count) {
    TRY(json_array(r->context, value, count));
    const json *item = value->first;
    for (size_t k = 0; k < count; k++, item = item->next)
        TRY(csg_read_number(out + k, r, item));
    return GRAZE_OK;
}

void csg_linear_form(fmpq_mpoly_t out, csg_reader *r, const fmpq *factor,
                     const fmpq_mpoly_struct *x, const fmpq_t constant) {
    fmpq_mpoly_zero(out, r->ring);
    for (int i = 0; i < r->dimension; i++) {
        fmpq_mpoly_scalar_mul_fmpq(r->term, x + i, factor + i, r->ring);
        fmpq_mpoly_add(out, out, r->term, r->ring);
    }
    fmpq_mpoly_sub_fmpq(out, out, constant, r->ring);
}

graze_status csg_add_side(size_t *node, csg_reader *r, int other) {
    if (other)
        fmpq_mpoly_neg(r->f, r->f, r->ring);
    return csg_add_sign(node, r, r->f);
}
