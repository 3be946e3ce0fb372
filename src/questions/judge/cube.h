/* Cubes of space and what is certain of them. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_JUDGE_CUBE_H
#define GRAZE_JUDGE_CUBE_H

#include <stdint.h>

/** Certain of all points of a closed cube; of one that is cut, which of them are below. In
 * a flat one the mesh is the boundary, which cuts it (questions/judge/flat_cube.h). */
enum { CUBE_IN = 1, CUBE_OUT = 2, CUBE_BAND = 4, CUBE_FLAT = 8 };

/** Centre and half a side are exact. */
typedef struct cube {
    double centre[3], half;
    uint32_t parent, child; /* the first of 8; 0: not cut */
    unsigned char kind, level;
    unsigned char beside; /* its border may hold the boundary, which is the mesh there */
} cube;

/** Half the diagonal of a cube, rounded up. */
static inline double cube_radius(const cube *c) {
    return c->half * 0x1.bb67ae8584cabp+0; /* the root of 3, and a little more */
}

#endif
