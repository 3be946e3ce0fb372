/* Balls and capsules among the nodes of a curved solid.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <flint/fmpq_vec.h>
#include <stdlib.h>
#include "base/context/array.h"
#include "base/context/scope.h"
#include "input/csg/csg_reader.h"

/* Set the factor by which a node's frame multiplies all lengths; 0 if it is no rational number, or
 * if there is none. */
static int frame_factor(fmpq_t out, const csg_reader *r) {
    int d = r->dimension;
    LOCAL_VEC(fmpq, sum, 2);
    for (int i = 0; i < d; i++)
        for (int j = i; j < d; j++) {
            fmpq_zero(sum);
            for (int k = 0; k < d; k++)
                fmpq_addmul(sum, fmpq_mat_entry(r->place, k, i), fmpq_mat_entry(r->place, k, j));
            if (i == 0 && j == 0)
                fmpq_set(sum + 1, sum);
            else if (i == j ? !fmpq_equal(sum, sum + 1) : !fmpq_is_zero(sum))
                return 0;
        }
    fmpz_sqrt(fmpq_numref(out), fmpq_numref(sum + 1));
    fmpz_sqrt(fmpq_denref(out), fmpq_denref(sum + 1));
    fmpq_mul(sum, out, out);
    return fmpq_equal(sum, sum + 1);
}

graze_status csg_note_round(csg_reader *r, const fmpq *point, const fmpq *axis,
                            const fmpq_t radius) {
    csg *out = r->build.out;
    int d = r->dimension;
    LOCAL(fmpq, factor);
    out->not_round |= !frame_factor(factor, r);
    TRY(array_grow(r->build.context, &out->round, &out->round_capacity, out->round_count + 1,
                   sizeof *out->round, "balls and capsules"));
    csg_round *made = &out->round[out->round_count++];
    fmpq_init(made->radius);
    fmpq_mul(made->radius, factor, radius);
    made->ends = axis ? 2 : 1;
    for (int k = 0; k < 6; k++)
        fmpq_init(&made->end[k]);
    for (int k = 0; k < made->ends; k++)
        for (int i = 0; i < d; i++) {
            fmpq *x = &made->end[k * d + i];
            _fmpq_vec_dot(x, fmpq_mat_entry(r->place, i, 0), point, d);
            fmpq_add(x, x, fmpq_mat_entry(r->place, i, d));
            if (k == 1) {
                _fmpq_vec_dot(factor, fmpq_mat_entry(r->place, i, 0), axis, d);
                fmpq_add(x, x, factor);
            }
        }
    return GRAZE_OK;
}
