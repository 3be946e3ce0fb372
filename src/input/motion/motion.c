/* Checked motions: freed, and the values of their point maps.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/motion/motion.h"

#include <flint/fmpq_mat.h>
#include <stdlib.h>

void point_map_init(point_map *map, int dimension) {
    map->dimension = dimension;
    fmpz_poly_init(map->weight);
    for (int k = 0; k < POINT_MAP_ENTRIES; k++) {
        fmpz_poly_init(&map->entry[k]);
    }
}

void point_map_clear(point_map *map) {
    fmpz_poly_clear(map->weight);
    for (int k = 0; k < POINT_MAP_ENTRIES; k++) {
        fmpz_poly_clear(&map->entry[k]);
    }
}

int affine_orientation(const fmpq *map, int d) {
    fmpq_mat_t linear;
    fmpq_t determinant;
    fmpq_mat_init(linear, d, d);
    fmpq_init(determinant);
    for (int i = 0; i < d; i++)
        for (int j = 0; j < d; j++)
            fmpq_set(fmpq_mat_entry(linear, i, j), map + i * (d + 1) + j);
    fmpq_mat_det(determinant, linear);
    int sign = fmpq_sgn(determinant);
    fmpq_mat_clear(linear);
    fmpq_clear(determinant);
    return sign;
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

void point_map_at(fmpq *out, const point_map *map, const fmpq_t u) {
    fmpq_t weight;
    fmpq_init(weight);
    fmpz_poly_evaluate_fmpq(weight, map->weight, u);
    for (int k = 0; k < map->dimension * (map->dimension + 1); k++) {
        fmpz_poly_evaluate_fmpq(&out[k], &map->entry[k], u);
        fmpq_div(&out[k], &out[k], weight);
    }
    fmpq_clear(weight);
}
