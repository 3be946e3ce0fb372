/* The request for a picture.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_DRAW_REQUEST_H
#define GRAZE_DRAW_REQUEST_H

#include <flint/fmpq.h>
#include <stddef.h>
#include <stdint.h>

/** A mesh in the colours of distances. All is borrowed. */
typedef struct draw_mesh {
    const fmpq *vertices; /* three each */
    size_t vertex_count;
    const uint32_t *corners; /* three vertices each */
    size_t triangle_count;
    const double *distance; /* one a vertex, negative inside the sweep */
} draw_mesh;

/** Contents of a picture: the numbers of graze_draw_options, checked and with their defaults.
 */
typedef struct draw_request {
    const char *title;
    unsigned long grid;     /* 0: two pixels a cell */
    unsigned long times;    /* at least 2 */
    int by_distance;        /* colours of cells: bands of the signed distance, else classes */
    const fmpq *low, *high; /* d each, low < high; both NULL: around the scene */
    int plane_axis;         /* E^3 */
    const fmpq *plane;      /* NULL: the middle of the box */
    const fmpq *normal;     /* three: the plane is normal . x = *plane; NULL: an axis' plane */
    double view[3];         /* not zero */
    const fmpq *points;     /* d each */
    size_t point_count;
    const char *const *names; /* one a point */
    /* Pages alone: */
    const char *const *strata;  /* one a point, or NULL; entries may be NULL */
    const char *const *answers; /* the same: a candidate's, where it is wrong */
    unsigned surface;           /* level of the sweep's surface; 0: none */
    const draw_mesh *mesh;      /* shown in place of the surface; NULL: none */
} draw_request;

#endif
