/* Plane and side forms from rational vertices.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "solid/forms.h"

#include <flint/fmpq_vec.h>
#include <flint/fmpz_vec.h>

/* Make coprime integers of d + 1 rationals, keeping the sign. */
static void to_integers(fmpz *out, const fmpq *c, int dimension) {
    fmpz_t common, content;
    fmpz_init_set_ui(common, 1);
    fmpz_init(content);
    for (int i = 0; i <= dimension; i++)
        fmpz_lcm(common, common, fmpq_denref(c + i));
    for (int i = 0; i <= dimension; i++) {
        fmpz_divexact(out + i, common, fmpq_denref(c + i));
        fmpz_mul(out + i, out + i, fmpq_numref(c + i));
    }
    _fmpz_vec_content(content, out, dimension + 1);
    if (!fmpz_is_zero(content))
        _fmpz_vec_scalar_divexact_fmpz(out, out, dimension + 1, content);
    fmpz_clear(common);
    fmpz_clear(content);
}

/* out = (q_i - p_i)(r_j - p_j) - (q_j - p_j)(r_i - p_i). */
static void cross(fmpq_t out, const fmpq *p, const fmpq *q, const fmpq *r, int i, int j) {
    fmpq_t a, b;
    fmpq_init(a);
    fmpq_init(b);
    fmpq_sub(a, q + i, p + i);
    fmpq_sub(b, r + j, p + j);
    fmpq_mul(out, a, b);
    fmpq_sub(a, q + j, p + j);
    fmpq_sub(b, r + i, p + i);
    fmpq_submul(out, a, b);
    fmpq_clear(a);
    fmpq_clear(b);
}

/* c[d] = -(c[0] p_0 + ...), so that the form vanishes at p. */
static void pass_through(fmpq *c, const fmpq *p, int dimension) {
    fmpq_zero(c + dimension);
    for (int i = 0; i < dimension; i++)
        fmpq_submul(c + dimension, c + i, p + i);
}

void form_of_plane(fmpz *out, const fmpq *const *vertex, int dimension) {
    fmpq *c = _fmpq_vec_init(4);
    if (dimension == 3) {
        for (int i = 0; i < 3; i++)
            cross(c + i, vertex[0], vertex[1], vertex[2], (i + 1) % 3, (i + 2) % 3);
    } else {
        fmpq_sub(c, vertex[1] + 1, vertex[0] + 1);
        fmpq_sub(c + 1, vertex[0], vertex[1]);
    }
    pass_through(c, vertex[0], dimension);
    to_integers(out, c, dimension);
    _fmpq_vec_clear(c, 4);
}

void form_of_side(fmpz *out, const fmpq *const *vertex, const fmpz *plane, int k, int dimension) {
    int dropped = 0;
    while (fmpz_is_zero(plane + dropped))
        dropped++;
    fmpq *c = _fmpq_vec_init(4);
    const fmpq *p = vertex[k], *q = vertex[(k + 1) % dimension];
    int i = (dropped + 1) % dimension, j = (dropped + 2) % dimension;
    if (dimension == 3) {
        fmpq_sub(c + i, p + j, q + j);
        fmpq_sub(c + j, q + i, p + i);
        fmpq_t opposite;
        fmpq_init(opposite);
        cross(opposite, p, q, vertex[(k + 2) % 3], i, j);
        if (fmpq_sgn(opposite) < 0) {
            fmpq_neg(c + i, c + i);
            fmpq_neg(c + j, c + j);
        }
        fmpq_clear(opposite);
    } else {
        fmpq_sub(c + i, q + i, p + i);
    }
    pass_through(c, p, dimension);
    to_integers(out, c, dimension);
    _fmpq_vec_clear(c, 4);
}
