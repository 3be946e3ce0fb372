/* Central arrangements over an ordered field.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * With the coordinate planes the arrangement is essential, so each closed cell is spanned by rays
 * in which d - 1 planes meet, and the sum of the rays in a closed cell with interior points is one
 * of these. A pattern of the members alone is a union of such cells.
 */
#include "base/context/scope.h"
#include "decide/curved/arrangement.h"

void field_dot(value *out, moment_field *f, const value *a, const value *b, int dimension) {
    fmpq_poly_zero(out);
    for (int i = 0; i < dimension; i++)
        field_addmul(out, f, a + i, b + i);
}

void field_cross(value *out, moment_field *f, const value *a, const value *b) {
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        field_mul(out + i, f, a + j, b + k);
        field_submul(out + i, f, a + k, b + j);
    }
}

/* Note the signs of the members' gradients along the ray behind the last one. */
static void mark_ray(arrangement *a, moment_field *f, const value *normal, uint32_t mask) {
    int r = a->ray_count, d = a->dimension;
    LOCAL(fmpq_poly, product);
    a->positive[r] = a->negative[r] = 0;
    for (int k = 0; k < a->count; k++) {
        if (!(mask >> k & 1))
            continue;
        field_dot(product, f, normal + k * d, a->ray + r * d, d);
        int sign = field_sign(f, product);
        a->positive[r] |= (uint32_t)(sign > 0) << k;
        a->negative[r] |= (uint32_t)(sign < 0) << k;
    }
}

/* Keep the ray behind the last one, if it is not zero, and its opposite. */
static void keep_ray(arrangement *a, moment_field *f, const value *normal, uint32_t mask) {
    int r = a->ray_count, d = a->dimension, any = 0;
    for (int i = 0; i < d && !any; i++)
        any = field_sign(f, a->ray + r * d + i) != 0;
    if (!any)
        return;
    mark_ray(a, f, normal, mask);
    for (int i = 0; i < d; i++)
        fmpq_poly_neg(a->ray + (r + 1) * d + i, a->ray + r * d + i);
    a->positive[r + 1] = a->negative[r];
    a->negative[r + 1] = a->positive[r];
    a->ray_count += 2;
}

void arrangement_init(arrangement *a, moment_field *f, const taylor *member, int count,
                      uint32_t mask) {
    int d = member[0].dimension, planes = count + d;
    *a = (arrangement){.dimension = d, .count = count};
    a->ray = field_vector(f, (size_t)(ARRANGEMENT_RAYS * d));
    LOCAL_VEC(fmpq_poly, normal, planes * d);
    for (int k = 0; k < planes; k++)
        for (int i = 0; i < d; i++)
            if (k < count)
                fmpq_poly_set(normal + k * d + i, taylor_gradient(&member[k], i));
            else
                fmpq_poly_set_si(normal + k * d + i, k - count == i);
    for (int k = 0; k < planes && a->ray; k++) {
        if (k < count && !(mask >> k & 1))
            continue;
        value *ray = a->ray + a->ray_count * d;
        if (d == 2) {
            fmpq_poly_neg(ray, normal + k * d + 1);
            fmpq_poly_set(ray + 1, normal + k * d);
            keep_ray(a, f, normal, mask);
        }
        for (int m = 0; m < k && d == 3; m++) {
            if (m < count && !(mask >> m & 1))
                continue;
            field_cross(a->ray + a->ray_count * d, f, normal + k * d, normal + m * d);
            keep_ray(a, f, normal, mask);
        }
    }
}

void arrangement_clear(arrangement *a) {
    field_vector_clear(a->ray, (size_t)(ARRANGEMENT_RAYS * a->dimension));
}

int arrangement_in_cell(const arrangement *a, int ray, uint32_t mask, unsigned pattern) {
    return !(a->positive[ray] & mask & pattern) && !(a->negative[ray] & mask & ~pattern);
}

int arrangement_has(const arrangement *a, uint32_t mask, unsigned pattern) {
    uint32_t strict = 0;
    for (int r = 0; r < a->ray_count; r++)
        if (arrangement_in_cell(a, r, mask, pattern))
            strict |= a->positive[r] | a->negative[r];
    return (strict & mask) == mask;
}
