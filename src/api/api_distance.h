/* The enclosure of one point's distance, for public functions of more than one file.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_API_DISTANCE_INTERNAL_H
#define GRAZE_API_DISTANCE_INTERNAL_H

#include "graze.h"
#include <flint/fmpq.h>

/** As graze_distances, of one point, whose number is not told. */
graze_status api_enclose(graze_enclosure *out, graze_context *context, const graze_scene *scene,
                         const fmpq *point, double tolerance);

#endif
