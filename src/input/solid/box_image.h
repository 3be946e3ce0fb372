/* The image of a box under an affine map in doubles. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_SOLID_BOX_IMAGE_H
#define GRAZE_SOLID_BOX_IMAGE_H

#include "input/solid/tree.h"

/** A box of centre c and half sides h has its image in the box of centre A c + b and half sides
 * |A| h, widened by far more than what rounding takes (proofs/filter.md C34). Of NaN nothing is
 * left out by comparisons that are false for it.
 * @param entry d*(d+1) entries, row by row, each within 2^-48 of its size of the exact one */
void box_image(box *out, const double *entry, int d, const box *of);

#endif
