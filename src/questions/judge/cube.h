/* Cubes of space and what is certain of them. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_JUDGE_CUBE_H
#define GRAZE_JUDGE_CUBE_H

#include <stdint.h>

/** Kinds of a closed cube: all of its points are in the sweep, all are out, undecided, or flat,
 * where the mesh is the sweep's boundary (questions/judge/flat_cube.h). A cut cube has the flags of
 * all cubes below it. */
enum { CUBE_IN = 1, CUBE_OUT = 2, CUBE_BAND = 4, CUBE_FLAT = 8 };

/** A cube with exact centre and half side. */
typedef struct cube {
    double centre[3], half;
    uint32_t parent, child; /* the first of 8; 0: not cut */
    unsigned char kind, level;
    unsigned char beside; /* the sweep's boundary may meet its surface, and is the mesh there */
} cube;

/** Half the diagonal of a cube, rounded up. */
static inline double cube_radius(const cube *c) {
    return c->half * 0x1.bb67ae8584cabp+0; /* the root of 3, and a little more */
}

#endif
