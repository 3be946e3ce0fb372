/* Curves in several surfaces, as paths of vector fields.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Let v be a field of polynomials whose derivative of each of some surfaces is a combination of
 * these surfaces. Where v is not 0 at the point, its path through the point lies in all of them,
 * and the rank of their gradients is constant on it (proofs/flows.md C121). The coefficients of v
 * and of the combinations solve a linear system of integers, whatever the time.
 */
#include "base/context/scope.h"
#include "decide/curved/arrangement.h"

/* Degrees of v: axes of revolution have 1, pipes that meet in a circle 3, and 5 is that of the
 * cross product of two gradients of degree 3, divided by a plane in which they are parallel. */
enum { FLOW_DEGREE = 5, LOW_ORDER = 4, AXES = 3 };

/* Most products of words to solve a system with: about a second, which nothing interrupts. */
enum { SYSTEM_WORK = 1 << 27 };

/* The number of monomials in x, y, z of at most this degree. */
static slong monomials(int degree) {
    return (slong)(degree + 1) * (degree + 2) * (degree + 3) / 6;
}

/* The number of a monomial: by its degree, then by its degree in y and z together, then in z. */
static slong monomial_place(const int p[3]) {
    int rest = p[1] + p[2];
    return monomials(p[0] + rest - 1) + rest * (rest + 1) / 2 + p[2];
}

static void next_power(int p[3]) {
    int rest = p[1] + p[2];
    if (p[1] > 0) {
        p[1]--;
        p[2]++;
    } else {
        p[1] = p[0] > 0 ? rest + 1 : 0;
        p[0] = p[0] > 0 ? p[0] - 1 : rest + 1;
        p[2] = 0;
    }
}

/* Put the product of a monomial and a surface's derivative along `axis`, or for AXES the surface's
 * polynomial itself, into a column. */
static void put_product(fmpz_mat_t system, slong row, slong column, const csg_surface *s, int axis,
                        const int q[3]) {
    for (size_t t = 0; t < s->count; t++) {
        int p[3];
        ulong factor = axis < AXES ? s->power[t][axis] : 1;
        for (int i = 0; i < AXES && factor; i++)
            p[i] = s->power[t][i] + q[i] - (i == axis);
        if (factor)
            fmpz_mul_ui(fmpz_mat_entry(system, row + monomial_place(p), column), s->coefficient + t,
                        factor);
    }
}

/* One equation for each surface: its derivative along v plus a combination of all surfaces is 0. */
static void put_system(fmpz_mat_t system, const csg_surface *const *of, int count, int degree) {
    slong row = 0, column = 0;
    for (int i = 0; i < count; row += monomials(of[i++]->degree - 1 + degree)) {
        slong at = 0;
        for (int axis = 0; axis < AXES; axis++)
            for (int q[3] = {0}; q[0] + q[1] + q[2] <= degree; next_power(q))
                put_product(system, row, at++, of[i], axis, q);
        column = i == 0 ? at : column;
        for (int j = 0; j < count; j++)
            for (int q[3] = {0}; q[0] + q[1] + q[2] < of[i]->degree - of[j]->degree + degree;
                 next_power(q))
                put_product(system, row, column++, of[j], AXES, q);
    }
}

/* The monomials of a degree, and of lower ones, at the point, times one power of the denominator.
 */
static value *monomials_at(sign_germ *g, int degree) {
    value *out = field_vector(g->f, (size_t)monomials(degree)), *next = out;
    HELD(taylor_point, at, g->f, g->c, degree);
    for (int q[3] = {0}; !g->f->status && next < out + monomials(degree); next_power(q)) {
        fmpq_poly_set(next, taylor_power(&at, AXES, degree - q[0] - q[1] - q[2]));
        for (int i = 0; i < AXES; i++)
            field_mul(next, g->f, next, taylor_power(&at, i, q[i]));
        next++;
    }
    return out;
}

/* 1 if one of the fields in the columns of a matrix is not 0 at the point. */
static int moves_point(sign_germ *g, const fmpz_mat_t fields, slong count, int degree) {
    slong n = monomials(degree);
    value *at = monomials_at(g, degree);
    LOCAL_VEC(fmpq_poly, sum, 2);
    int moves = 0;
    for (slong k = 0; k < AXES * count && at && !moves; k++) {
        fmpq_poly_zero(sum);
        for (slong q = 0; q < n; q++) {
            fmpq_poly_scalar_mul_fmpz(sum + 1, at + q,
                                      fmpz_mat_entry(fields, k % AXES * n + q, k / AXES));
            fmpq_poly_add(sum, sum, sum + 1);
        }
        moves = field_sign(g->f, sum) != 0;
    }
    field_vector_clear(at, (size_t)n);
    return moves;
}

/* 1 if a field of a degree moves the point along a curve in all of some surfaces. */
static int has_flow(sign_germ *g, const csg_surface *const *of, int count, int degree) {
    slong rows = 0, columns = AXES * monomials(degree);
    for (int i = 0; i < count; i++) {
        rows += monomials(of[i]->degree - 1 + degree);
        for (int j = 0; j < count; j++)
            columns += monomials(of[i]->degree - 1 + degree - of[j]->degree);
    }
    LOCAL(fmpz_mat, system, rows, columns);
    LOCAL(fmpz_mat, fields, columns, columns);
    put_system(system, of, count, degree);
    slong words = FLINT_ABS(fmpz_mat_max_bits(system)) / FLINT_BITS + 1;
    slong work = columns * columns * columns * words;
    if (work <= SYSTEM_WORK)
        field_charge(g->f, (ulong)work, (ulong)work / 8);
    return work <= SYSTEM_WORK && !g->f->status &&
           moves_point(g, fields, fmpz_mat_nullspace(fields, system), degree);
}

/* Is the trajectory itself a curve in all members? It is along a gap, where they vanish on it. */
static int is_slide(const sign_germ *g) {
    const fmpz_poly_struct *x = g->c->x, *w = x + g->dimension;
    int moves = 0;
    if (!fmpq_poly_is_zero(g->f->modulus))
        return 0;
    LOCAL(fmpz_poly, one);
    LOCAL(fmpz_poly, other);
    for (int i = 0; i < g->dimension && !moves; i++) {
        if (fmpz_poly_is_zero(x + i))
            continue;
        fmpz_poly_scalar_mul_fmpz(one, x + i, fmpz_poly_lead(w));
        fmpz_poly_scalar_mul_fmpz(other, w, fmpz_poly_lead(x + i));
        moves = !fmpz_poly_equal(one, other);
    }
    return moves;
}

static int is_shared(sign_germ *g, unsigned members) {
    const csg_surface *of[CSG_FREE_MOST];
    int count = 0, moves = 0;
    for (int k = 0; k < g->count; k++)
        if (members >> k & 1)
            of[count++] = g->surface[k];
    for (int degree = 1; degree <= FLOW_DEGREE && !moves && !g->f->status; degree += 2)
        moves = has_flow(g, of, count, degree);
    return moves;
}

int flow_first(int *order, sign_germ *g, probe *p, unsigned members, const taylor *of, int most) {
    int low = most < LOW_ORDER ? most : LOW_ORDER;
    int slide = is_slide(g), sign = slide ? 0 : probe_first(order, p, g->f, of, low);
    if (slide || (!sign && low < most && g->dimension == AXES && is_shared(g, members)))
        *order = most + 1;
    else if (!sign && low < most)
        sign = probe_first(order, p, g->f, of, most);
    return sign;
}
