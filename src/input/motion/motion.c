/* Checked motions: how they are freed, and the values of their point maps.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/motion/motion.h"

#include "base/context/scope.h"

void point_map_init(point_map *map, int dimension) {
    map->dimension = dimension;
    fmpz_poly_init(map->weight);
    for (int k = 0; k < POINT_MAP_ENTRIES; k++)
        fmpz_poly_init(&map->entry[k]);
}

void point_map_clear(point_map *map) {
    fmpz_poly_clear(map->weight);
    for (int k = 0; k < POINT_MAP_ENTRIES; k++)
        fmpz_poly_clear(&map->entry[k]);
}

void point_map_set(point_map *out, const point_map *map) {
    out->dimension = map->dimension;
    fmpz_poly_set(out->weight, map->weight);
    for (int k = 0; k < POINT_MAP_ENTRIES; k++)
        fmpz_poly_set(&out->entry[k], &map->entry[k]);
}

int affine_orientation(const fmpq *map, int d) {
    LOCAL(fmpq_mat, linear, d, d);
    LOCAL(fmpq, determinant);
    for (int i = 0; i < d; i++)
        for (int j = 0; j < d; j++)
            fmpq_set(fmpq_mat_entry(linear, i, j), map + i * (d + 1) + j);
    fmpq_mat_det(determinant, linear);
    return fmpq_sgn(determinant);
}

void affine_image(fmpq *out, const fmpq *map, const fmpq *point, int d) {
    for (int i = 0; i < d; i++) {
        fmpq_set(out + i, map + i * (d + 1) + d);
        for (int j = 0; j < d; j++)
            fmpq_addmul(out + i, map + i * (d + 1) + j, point + j);
    }
}

void motion_destroy(graze_motion *motion) {
    for (size_t k = 0; k < motion->piece_count; k++) {
        fmpq_clear(motion->piece[k].lo);
        fmpq_clear(motion->piece[k].hi);
        point_map_clear(&motion->piece[k].forward);
        point_map_clear(&motion->piece[k].inverse);
    }
    free(motion->piece);
    free(motion);
}

const point_map *motion_tracing(const motion_piece *piece, graze_operation operation) {
    return operation == GRAZE_UNSWEEP ? &piece->forward : &piece->inverse;
}

const point_map *motion_placing(const motion_piece *piece, graze_operation operation) {
    return operation == GRAZE_UNSWEEP ? &piece->inverse : &piece->forward;
}

void motion_time_at(fmpq_t t, const motion_piece *piece, const fmpq_t u) {
    LOCAL(fmpq, width);
    fmpq_sub(width, piece->hi, piece->lo);
    fmpq_mul(t, u, width);
    fmpq_add(t, t, piece->lo);
}

void motion_parameter_at(fmpq_t u, const motion_piece *piece, const fmpq_t t) {
    LOCAL(fmpq, width);
    fmpq_sub(width, piece->hi, piece->lo);
    fmpq_sub(u, t, piece->lo);
    fmpq_div(u, u, width);
}

void point_map_at(fmpq *out, const point_map *map, const fmpq_t u) {
    LOCAL(fmpq, weight);
    fmpz_poly_evaluate_fmpq(weight, map->weight, u);
    for (int k = 0; k < map->dimension * (map->dimension + 1); k++) {
        fmpz_poly_evaluate_fmpq(&out[k], &map->entry[k], u);
        fmpq_div(&out[k], &out[k], weight);
    }
}

int point_map_scale(fmpz_poly_t out, const point_map *map) {
    int d = map->dimension;
    LOCAL(fmpz_poly, sum);
    LOCAL(fmpz_poly, term);
    for (int i = 0; i < d; i++)
        for (int j = i; j < d; j++) {
            fmpz_poly_zero(sum);
            for (int k = 0; k < d; k++) {
                fmpz_poly_mul(term, &map->entry[k * (d + 1) + i], &map->entry[k * (d + 1) + j]);
                fmpz_poly_add(sum, sum, term);
            }
            if (i == 0 && j == 0)
                fmpz_poly_set(out, sum);
            else if (i == j ? !fmpz_poly_equal(sum, out) : !fmpz_poly_is_zero(sum))
                return 0;
        }
    return 1;
}
