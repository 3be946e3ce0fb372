/* Boxes around images of boxes. SPDX-License-Identifier: GPL-3.0-or-later */
#include "input/solid/solid.h"

void box_image(box *out, const double *entry, int d, const box *of) {
    for (int i = 0; i < 3; i++)
        out->low[i] = out->high[i] = 0;
    for (int i = 0; i < d; i++) {
        const double *row = entry + i * (d + 1);
        double centre = row[d], half = 0, size = fabs(row[d]);
        for (int j = 0; j < d; j++) {
            centre += row[j] * (0.5 * of->low[j] + 0.5 * of->high[j]);
            half += fabs(row[j]) * (0.5 * of->high[j] - 0.5 * of->low[j]);
            size += fabs(row[j]) * (fabs(of->low[j]) + fabs(of->high[j]));
        }
        half += 0x1p-40 * size + 0x1p-900;
        out->low[i] = centre - half;
        out->high[i] = centre + half;
    }
}
