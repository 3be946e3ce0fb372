/* How deep wrong rows are: enclosures of the signed distances of their points.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * They stand in the golden table, or are computed for at most MOST_MEASURED rows, spread evenly
 * over the wrong ones.
 */
#ifndef GRAZE_COMPARE_DEPTH_H
#define GRAZE_COMPARE_DEPTH_H

#include "output/compare/errors.h"
#include "output/compare/table.h"
#include "output/report/enclosure.h"

enum { MOST_MEASURED = 1000 };

/** Parts of the size that rows may be deeper than: 1e-12, 1e-9, 1e-6, 1e-3. */
enum { DEPTH_PARTS = 4 };
extern const char *const depth_parts[DEPTH_PARTS];

/** Zeroed at first, with `size` initialised. */
typedef struct depths {
    unsigned long wrong, stride;       /* rows offered; every stride-th waits */
    size_t waiting;                    /* number of rows that wait */
    errors by[3];                      /* sizes of s, by golden pmc */
    fmpq_t size;                       /* the diagonal of S^0's box; 0: not known */
    unsigned long deeper[DEPTH_PARTS]; /* rows that are certainly deeper than these parts of it */
    char *unmeasured;                  /* the limit that distances meet, malloc'ed; NULL: none */
} depths;

void depth_clear(depths *d);

/** Take the enclosure that a golden row has; *out is the larger size of its bounds. GRAZE_EINPUT,
 * GRAZE_ELIMIT, GRAZE_ESYSTEM. */
graze_status depth_take(ceiling *out, depths *d, const table *golden, const table_row *row,
                        int pmc);

/** Bounds of a signed distance, as decimals, and the larger of their sizes. */
typedef struct depth_bounds {
    char low[BOUND_ROOM], high[BOUND_ROOM];
    ceiling size;
} depth_bounds;

/** Take the size from the scene. GRAZE_ELIMIT, GRAZE_ECANCELED. */
graze_status depth_scale(depths *d, graze_context *context, const graze_scene *scene);

/** Enclose the signed distance of a wrong row's point to 1e-13 of the size, and count it.
 * @param point coordinates with blanks between
 * @return as graze_distances */
graze_status depth_measure(depth_bounds *out, depths *d, graze_context *context,
                           const graze_scene *scene, const char *point, int pmc);

#endif
