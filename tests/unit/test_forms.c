/* Forms of simplices (input/solid/solid.h, input/solid/solid.h, input/solid/solid.h) against their
 * definition: signs at known points, normalisation, planes in common; and the location that rests
 * on them, against the definition of a box. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <flint/fmpq_vec.h>
#include <flint/fmpz_vec.h>
#include "../lib/random.h"
#include "base/number/vector.h"
#include "input/solid/solid.h"
#include "input/validate/validate.h"
#include "fixture.h"

/* Integers, decimals, doubles, long ratios, and coordinates that agree with one another. */
static void draw_coordinate(fmpq_t out) {
    static const ulong denominator[] = {1, 1, 10, 1000, 7, 3037000499};
    fmpq_set_si(out, (slong)draw_below(21) - 10, denominator[draw_below(6)]);
    if (draw_below(4) == 0)
        fmpq_div_2exp(out, out, draw_below(120));
    if (draw_below(8) == 0)
        for (int k = 0; k < 12; k++) {
            fmpz_mul_ui(fmpq_denref(out), fmpq_denref(out), 1000003);
            fmpz_add_ui(fmpq_numref(out), fmpq_numref(out), draw_below(1000));
        }
    fmpq_canonicalise(out);
}

/* The value of a form at a rational point, by the definition. */
static void evaluate(fmpq_t out, const fmpz *form, const fmpq *x, int d) {
    fmpq_t term;
    fmpq_init(term);
    fmpq_set_fmpz(out, form + d);
    for (int i = 0; i < d; i++) {
        fmpq_mul_fmpz(term, x + i, form + i);
        fmpq_add(out, out, term);
    }
    fmpq_clear(term);
}

static int sign_at(const fmpz *form, const fmpq *x, int d) {
    fmpq_t value;
    fmpq_init(value);
    evaluate(value, form, x, d);
    int sign = fmpq_sgn(value);
    fmpq_clear(value);
    return sign;
}

static void assert_coprime(const fmpz *form, int d) {
    fmpz_t content;
    fmpz_init(content);
    _fmpz_vec_content(content, form, d + 1);
    assert_true(fmpz_is_one(content));
    fmpz_clear(content);
}

/* out += normal of the simplex, which points to its outer side by its orientation: d = 3 the cross
 * product of two edges, d = 2 the edge turned to the right. */
static void add_normal(fmpq *out, const fmpq *const *v, int d) {
    fmpq *e = _fmpq_vec_init(6);
    fmpq_t t;
    fmpq_init(t);
    for (int k = 1; k < d; k++)
        for (int i = 0; i < d; i++)
            fmpq_sub(e + 3 * (k - 1) + i, v[k] + i, v[0] + i);
    if (d == 2) {
        fmpq_add(out, out, e + 1);
        fmpq_sub(out + 1, out + 1, e);
    }
    for (int i = 0; d == 3 && i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        fmpq_mul(t, e + j, e + 3 + k);
        fmpq_add(out + i, out + i, t);
        fmpq_mul(t, e + k, e + 3 + j);
        fmpq_sub(out + i, out + i, t);
    }
    fmpq_clear(t);
    _fmpq_vec_clear(e, 6);
}

static int degenerate(const fmpq *const *v, int d) {
    fmpq *n = _fmpq_vec_init(3);
    add_normal(n, v, d);
    int zero = 1;
    for (int i = 0; i < 3; i++)
        zero = zero && fmpq_is_zero(n + i);
    _fmpq_vec_clear(n, 3);
    return zero;
}

/* A point of the plane with barycentric coordinates drawn from -3 to 3, and their signs. */
static void draw_in_plane(fmpq *x, int *sign, const fmpq *const *v, int d) {
    fmpq_t share, term;
    fmpq_init(share);
    fmpq_init(term);
    slong part[3] = {0, 0, 0}, sum = 0;
    while (sum == 0) {
        sum = 0;
        for (int k = 0; k < d; k++) {
            part[k] = (slong)draw_below(7) - 3;
            sum += part[k];
        }
    }
    for (int i = 0; i < d; i++)
        fmpq_zero(x + i);
    for (int k = 0; k < d; k++) {
        fmpq_set_si(share, sum < 0 ? -part[k] : part[k], (ulong)labs(sum));
        sign[k] = fmpq_sgn(share);
        for (int i = 0; i < d; i++) {
            fmpq_mul(term, share, v[k] + i);
            fmpq_add(x + i, x + i, term);
        }
    }
    fmpq_clear(share);
    fmpq_clear(term);
}

static void check_plane(const fmpz *plane, int facing, const fmpq *const *v, int d) {
    int first = 0;
    while (fmpz_is_zero(plane + first))
        first++;
    assert_true(first < d);
    assert_int_equal(fmpz_sgn(plane + first), 1);
    assert_coprime(plane, d);
    fmpq *outside = _fmpq_vec_init(d < 3 ? 3 : d);
    for (int i = 0; i < d; i++)
        fmpq_set(outside + i, v[0] + i);
    add_normal(outside, v, d);
    assert_int_equal(sign_at(plane, outside, d), facing);
    _fmpq_vec_clear(outside, d < 3 ? 3 : d);
    for (int k = 0; k < d; k++)
        assert_int_equal(sign_at(plane, v[k], d), 0);
}

/* Side k is opposite to vertex (k + 2) % 3 (d = 2: k is the vertex itself, opposite to the other),
 * and its form has the sign of that vertex's barycentric coordinate everywhere in the plane. */
static void check_sides(const fmpz *plane, const fmpq *const *v, int d) {
    fmpz *side = _fmpz_vec_init(d + 1);
    fmpq *x = _fmpq_vec_init(d);
    int first = 0, sign[3];
    while (fmpz_is_zero(plane + first))
        first++;
    for (int k = 0; k < d; k++) {
        form_of_side(side, v, plane, k, d);
        assert_coprime(side, d);
        assert_true(fmpz_is_zero(side + first));
        for (int n = 0; n < 6; n++) {
            draw_in_plane(x, sign, v, d);
            assert_int_equal(sign_at(side, x, d), sign[d == 3 ? (k + 2) % 3 : 1 - k]);
        }
    }
    _fmpz_vec_clear(side, d + 1);
    _fmpq_vec_clear(x, d);
}

static void forms_by_definition(void **state) {
    (void)state;
    for (int round = 0; round < 4000; round++) {
        int d = 2 + round % 2;
        fmpq *x = _fmpq_vec_init(9);
        fmpz *plane = _fmpz_vec_init(d + 1), *turned = _fmpz_vec_init(d + 1);
        const fmpq *v[3] = {x, x + d, x + 2 * d}, *back[3] = {v[1], v[0], v[2]};
        for (int k = 0; k < 9; k++)
            draw_coordinate(x + k);
        if (draw_below(3) == 0) /* a plane along an axis */
            for (int k = 1; k < d; k++)
                fmpq_set(x + k * d + (int)(draw_below(2)), x + (int)(draw_below(2)));
        if (!degenerate(v, d)) {
            int facing = form_of_plane(plane, v, d);
            check_plane(plane, facing, v, d);
            check_sides(plane, v, d);
            assert_int_equal(form_of_plane(turned, back, d), -facing);
            assert_int_equal(form_compare(plane, turned, d), 0);
        }
        _fmpq_vec_clear(x, 9);
        _fmpz_vec_clear(plane, d + 1);
        _fmpz_vec_clear(turned, d + 1);
    }
}

/* A box from (0, 0, 0) to (1, 1, 1) / 3 in n x n squares a side, each of two triangles or one
 * square: 6 planes. */
static graze_solid *box_of_squares(int n, int squares) {
    size_t count = 0, corners = 0, *size = malloc(12 * (size_t)(n * n) * sizeof *size);
    size_t *index = malloc(36 * (size_t)(n * n) * sizeof *index);
    mpq_t *x = malloc(3 * (size_t)(24 * n * n) * sizeof *x);
    size_t vertices = 0;
    for (int side = 0; side < 6; side++)
        for (int cell = 0; cell < n * n; cell++) {
            int axis = side / 2, high = side % 2;
            for (int c = 0; c < 4; c++, vertices++) {
                int u = cell % n + (c == 1 || c == 2), w = cell / n + (c >= 2), at[3];
                at[axis] = high * n;
                at[(axis + 1) % 3] = high ? u : w;
                at[(axis + 2) % 3] = high ? w : u;
                for (int i = 0; i < 3; i++) {
                    mpq_init(x[3 * vertices + (size_t)i]);
                    mpq_set_ui(x[3 * vertices + (size_t)i], (unsigned long)at[i],
                               3 * (unsigned long)n);
                    mpq_canonicalize(x[3 * vertices + (size_t)i]);
                }
            }
            size_t first = vertices - 4;
            static const size_t whole[] = {0, 1, 2, 3}, halves[] = {0, 1, 2, 0, 2, 3};
            for (int k = 0; k < (squares ? 4 : 6); k++)
                index[corners++] = first + (squares ? whole[k] : halves[k]);
            for (int k = 0; k < (squares ? 1 : 2); k++)
                size[count++] = squares ? 4 : 3;
        }
    graze_solid *solid = NULL;
    graze_status status =
        graze_solid_from_arrays(&solid, context, 3, x, vertices, size, count, index, 0);
    if (status)
        fail_msg("%s", graze_context_message(context));
    for (size_t k = 0; k < 3 * vertices; k++)
        mpq_clear(x[k]);
    free(x);
    free(size);
    free(index);
    return solid;
}

/* Faces of the box lie in 6 planes, n n squares in each, whichever way they are cut. */
static void planes_in_common(void **state) {
    (void)state;
    for (int squares = 0; squares < 2; squares++) {
        graze_solid *solid = box_of_squares(4, squares);
        size_t n = solid->cut.count;
        plane_list planes;
        assert_int_equal(n, 6 * 16 * 2);
        assert_int_equal(planes_find(&planes, NULL, solid, NULL, n), 0);
        assert_int_equal(planes.count, 6);
        fmpz *form = _fmpz_vec_init(4);
        for (size_t p = 0; p < planes.count; p++) {
            assert_int_equal(planes.start[p + 1] - planes.start[p], 32);
            for (size_t k = planes.start[p]; k < planes.start[p + 1]; k++) {
                assert_true(k == planes.start[p] || planes.order[k - 1] < planes.order[k]);
                int facing = solid_plane(form, solid, planes.order[k]);
                assert_int_equal(form_compare(form, planes.form + 4 * p, 3), 0);
                assert_int_equal(facing, fmpz_is_zero(form + 3) ? -1 : 1);
            }
        }
        planes_clear(&planes);
        uint32_t some[] = {7, 7, 0, 191, 7};
        assert_int_equal(planes_find(&planes, NULL, solid, some, 5), 0);
        assert_int_equal(planes.count, solid->cut.item[7].facet / (squares ? 16 : 32) ? 3 : 2);
        assert_int_equal(planes.start[planes.count], 5);
        planes_clear(&planes);
        _fmpz_vec_clear(form, 4);
        graze_solid_destroy(solid);
    }
}

/* Forms from a memory are those made without it, for simplices of two solids, one with more than it
 * has places for, asked for in any order. */
static void forms_remembered(void **state) {
    (void)state;
    graze_solid *solid[] = {box_of_squares(4, 1), box_of_squares(14, 0)};
    form_memory memory = {0, NULL};
    fmpz *told = _fmpz_vec_init(4), *plane = _fmpz_vec_init(4), *side = _fmpz_vec_init(4);
    for (int round = 0; round < 20000; round++) {
        /* Some rounds with one solid, then some with the other. */
        const graze_solid *of = solid[round / 2000 % 2];
        uint32_t simplex = (uint32_t)draw_below(of->cut.count);
        int k = (int)draw_below(3);
        solid_plane(plane, of, simplex);
        if (draw_below(2)) {
            known_plane(told, &memory, of, simplex);
            assert_int_equal(form_compare(told, plane, 3), 0);
        } else {
            solid_side(side, of, simplex, plane, k);
            const fmpz *form = known_side(told, &memory, of, simplex, plane, k);
            assert_int_equal(form_compare(form, side, 3), 0);
        }
    }
    form_memory_clear(&memory);
    _fmpz_vec_clear(told, 4);
    _fmpz_vec_clear(plane, 4);
    _fmpz_vec_clear(side, 4);
    for (int k = 0; k < 2; k++)
        graze_solid_destroy(solid[k]);
}

/* Every point of a lattice that holds the corners, the edges and the diagonals of the squares, and
 * points a little beside it: inside, outside and on the boundary are told by the coordinates. */
static void location_in_box(void **state) {
    (void)state;
    static const slong beside[] = {0, 1, -1};
    for (int squares = 0; squares < 2; squares++) {
        graze_solid *solid = box_of_squares(3, squares);
        fmpz *x = _fmpz_vec_init(4);
        for (int round = 0; round < 4000; round++) {
            int inside = 1, on = 1;
            unsigned bits = 1 + (unsigned)draw_below(90);
            /* In units of 1/18, displaced by 2^-bits of that: the box is [0, 6]^3. */
            fmpz_set_ui(x + 3, 18);
            fmpz_mul_2exp(x + 3, x + 3, bits);
            for (int i = 0; i < 3; i++) {
                slong k = (slong)draw_below(9) - 1, off = beside[draw_below(3)];
                fmpz_set_si(x + i, k);
                fmpz_mul_2exp(x + i, x + i, bits);
                fmpz_add_si(x + i, x + i, off);
                int low = k > 0 || (k == 0 && off >= 0), high = k < 6 || (k == 6 && off <= 0);
                on = on && low && high;
                inside = inside && low && high && !(off == 0 && (k == 0 || k == 6));
            }
            graze_state expected = inside ? GRAZE_STATE_I : on ? GRAZE_STATE_B : GRAZE_STATE_O;
            if (solid_locate(solid, x) != expected) {
                _fmpz_vec_print(x, 4);
                fail_msg("state %d expected", (int)expected);
            }
        }
        _fmpz_vec_clear(x, 4);
        graze_solid_destroy(solid);
    }
}

/* (q - p) x (r - p) of rationals, by the definition. */
static void cross_by_definition(void **state) {
    (void)state;
    fmpq *x = _fmpq_vec_init(9), *e = _fmpq_vec_init(4);
    fmpq_t expected, found;
    fmpq_init(expected);
    fmpq_init(found);
    for (int round = 0; round < 3000; round++) {
        int i = (int)draw_below(3), j = (i + 1 + (int)draw_below(2)) % 3;
        for (int k = 0; k < 9; k++)
            draw_coordinate(x + k);
        fmpq_sub(e, x + 3 + i, x + i);
        fmpq_sub(e + 1, x + 6 + j, x + j);
        fmpq_sub(e + 2, x + 3 + j, x + j);
        fmpq_sub(e + 3, x + 6 + i, x + i);
        fmpq_mul(expected, e, e + 1);
        fmpq_submul(expected, e + 2, e + 3);
        cross_rationals(found, x, x + 3, x + 6, i, j);
        assert_true(fmpq_is_canonical(found));
        assert_true(fmpq_equal(found, expected));
    }
    fmpq_clear(expected);
    fmpq_clear(found);
    _fmpq_vec_clear(x, 9);
    _fmpq_vec_clear(e, 4);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cross_by_definition), cmocka_unit_test(forms_by_definition),
        cmocka_unit_test(planes_in_common),    cmocka_unit_test(forms_remembered),
        cmocka_unit_test(location_in_box),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
