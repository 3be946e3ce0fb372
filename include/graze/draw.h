/* graze/draw.h - pictures of a scene.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_DRAW_H
#define GRAZE_DRAW_H

#include <graze/core.h>

#ifdef __cplusplus
extern "C" {
#endif

/** What a picture shows. Zeroed it holds the defaults; everything is borrowed. */
typedef struct graze_draw_options {
    const char *title;        /**< a line above the picture, or NULL */
    unsigned long grid;       /**< cells along the longer side; 0: 240, or 360 of a wide box */
    unsigned long times;      /**< positions of S, 2 to 64, evenly spread over the motion; 0: 5 */
    const mpq_t *low, *high;  /**< the box, d rationals each; both NULL: around the scene */
    int plane_axis;           /**< E^3: the plane in which this coordinate, 0 to 2, ... */
    const mpq_t *plane;       /**< ... is this rational; NULL: z in the middle of the box */
    double view[3];           /**< E^3: seen from there; all 0: from (2, -3, 2) */
    const mpq_t *points;      /**< point_count points, d canonical rationals each */
    size_t point_count;       /**< of those whose trajectories are drawn */
    const char *const *names; /**< a name for each of them, UTF-8 */
} graze_draw_options;

/**
 * Draw a scene. A grid of square cells is coloured by the class of their centres, which are
 * rationals and classified exactly, under outlines of S at some times of the motion; in E^3 in a
 * plane, beside a view of the positions of S. Points are drawn where they are, and their
 * (inverted) trajectories through the standing S with the contacts, marked by kind and cell. Of an
 * unsweep the colours are those of pmc, the positions those of the inverse motion.
 * @param file    the picture to write: .svg, or .png, for which libgraze-png must be there
 * @param options or NULL
 * @return GRAZE_EUSE an option out of its range, or another extension; GRAZE_ELIMIT more cells than
 * the limit `grid`; GRAZE_ESYSTEM the file, or no libgraze-png; GRAZE_ECANCELED; GRAZE_EINTERNAL.
 * Except when writing fails half-way, no file is made or changed then.
 */
GRAZE_API GRAZE_CHECKED graze_status graze_draw(graze_context *context, const graze_scene *scene,
                                                const char *file,
                                                const graze_draw_options *options);

#ifdef __cplusplus
}
#endif
#endif
