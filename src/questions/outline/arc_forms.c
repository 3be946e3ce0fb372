/* Forms: equations of curves as integer polynomials in two coordinates.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "questions/outline/arcs.h"

#include <flint/fmpq_vec.h>
#include "base/context/scope.h"

void form_pullback(fmpz_poly_t out, const fmpz_mpoly_t form, slong degree,
                   const fmpz_poly_struct *x, const fmpz_mpoly_ctx_t ring) {
    LOCAL_VEC(fmpz_poly, power, 3 * (degree + 1));
    LOCAL(fmpz_poly, term);
    LOCAL(fmpz, c);
    for (slong k = 0; k < 3 * (degree + 1); k++)
        if (k % (degree + 1) == 0)
            fmpz_poly_one(power + k);
        else
            fmpz_poly_mul(power + k, power + k - 1, x + k / (degree + 1));
    fmpz_poly_zero(out);
    for (slong k = 0; k < fmpz_mpoly_length(form, ring); k++) {
        ulong e[FORM_VARIABLES];
        fmpz_mpoly_get_term_exp_ui(e, form, k, ring);
        fmpz_mpoly_get_term_coeff_fmpz(c, form, k, ring);
        fmpz_poly_mul(term, power + e[0], power + degree + 1 + e[1]);
        fmpz_poly_mul(term, term, power + 2 * (degree + 1) + degree - (slong)(e[0] + e[1]));
        fmpz_poly_scalar_addmul_fmpz(out, term, c);
    }
}

void form_on_line(fmpz_poly_t out, const graze_outline *o, const outline_equation *e,
                  const fmpq *point, int axis) {
    LOCAL_VEC(fmpz_poly, x, 3);
    LOCAL_VEC(fmpz, v, 3);
    _fmpq_vec_get_fmpz_vec_fmpz(v, v + 2, point, 2);
    for (int i = 0; i < 3; i++)
        fmpz_poly_set_fmpz(x + i, v + i);
    fmpz_poly_set_coeff_fmpz(x + axis, 1, v + 2);
    form_pullback(out, e->form, e->degree, x, o->ring_of_forms);
}

graze_status form_eliminate(fmpz_mpoly_t out, graze_context *context, const fmpz_mpoly_t a,
                            const fmpz_mpoly_t b, int variable, const fmpz_mpoly_ctx_t ring) {
    if (fmpz_mpoly_degree_si(a, variable, ring) == 0)
        fmpz_mpoly_set(out, a, ring);
    else if (fmpz_mpoly_degree_si(b, variable, ring) == 0)
        fmpz_mpoly_set(out, b, ring);
    else if (!fmpz_mpoly_resultant(out, a, b, variable, ring))
        return context_fail(context, GRAZE_EINTERNAL, "a resultant of curves is not found");
    return context_poll(context);
}
