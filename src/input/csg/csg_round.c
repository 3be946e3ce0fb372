/* Balls and capsules among the nodes of a curved solid.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/context/array.h"
#include "base/context/scope.h"
#include "base/number/vector.h"
#include "input/csg/csg_reader.h"

int csg_similar(fmpq_t square, const fmpq *matrix, int d, int width) {
    LOCAL_VEC(fmpq, v, 9);
    int similar = 1;
    fmpq_zero(square);
    for (int i = 0; i < d; i++)
        for (int j = 0; j < d; j++) {
            _fmpq_vec_dot(v + 3 * i + j, matrix + width * i, matrix + width * j, d);
            similar = similar && (i == j ? fmpq_equal(v + 4 * i, v) : fmpq_is_zero(v + 3 * i + j));
        }
    for (int i = 0; i < d; i++)
        fmpq_add(square, square, v + 4 * i);
    fmpq_div_fmpz(square, square, (fmpz[1]){d});
    return similar;
}

int csg_scale(fmpq_t out, const fmpq *matrix, int d, int width) {
    LOCAL_VEC(fmpq, v, 2);
    int similar = csg_similar(v, matrix, d, width);
    csg_upper_root(out, v);
    fmpq_mul(v + 1, out, out);
    return similar && fmpq_equal(v + 1, v);
}

graze_status csg_note_round(csg_reader *r, const fmpq *point, const fmpq *axis,
                            const fmpq_t radius) {
    csg *out = r->out;
    int d = r->dimension;
    LOCAL(fmpq, factor);
    out->not_round |= !csg_scale(factor, fmpq_mat_entry(r->place, 0, 0), d, d + 1);
    TRY(array_grow(r->context, &out->round, &out->round_capacity, out->round_count + 1,
                   sizeof *out->round, "balls and capsules"));
    csg_round *made = &out->round[out->round_count++];
    fmpq_init(made->radius);
    fmpq_mul(made->radius, factor, radius);
    made->ends = axis ? 2 : 1;
    made->end = _fmpq_vec_init(6);
    vector_image(made->end, r->place, point, d);
    if (axis) {
        LOCAL_VEC(fmpq, other, d);
        vector_add(other, point, axis, d);
        vector_image(made->end + d, r->place, other, d);
    }
    return GRAZE_OK;
}
