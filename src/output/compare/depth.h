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

/** A wrong row that waits for its distance. */
typedef struct deep_row {
    char *point; /* coordinates with blanks between, malloc'ed */
    int pmc;     /* the golden one */
} deep_row;

/** Zeroed at first. */
typedef struct depths {
    unsigned long wrong, stride; /* rows offered; every one of so many waits */
    size_t count;
    deep_row rows[MOST_MEASURED];
    errors by[3];     /* sizes of s, by golden pmc */
    char *unmeasured; /* the limit that distances meet, malloc'ed; NULL: none */
} depths;

void depth_clear(depths *d);

/** Take the enclosure that a golden row has. GRAZE_EINPUT, GRAZE_ELIMIT, GRAZE_ESYSTEM. */
graze_status depth_take(depths *d, const table *golden, const table_row *row, int pmc);

/** Let a wrong row wait, if it is one of those that do. `point` is malloc'ed and taken.
 * @return 0 if it is NULL */
int depth_wait(depths *d, char *point, int pmc);

/** Bounds of a signed distance, as decimals, and the larger of their sizes. */
typedef struct depth_bounds {
    char low[BOUND_ROOM], high[BOUND_ROOM];
    ceiling size;
} depth_bounds;

/** Enclose the signed distance of a point to 1e-10 of the diagonal of S^0's box.
 * @param point coordinates with blanks between
 * @return as graze_distances */
graze_status depth_enclose(depth_bounds *out, graze_context *context, const graze_scene *scene,
                           const char *point);

/** Measure the rows that wait. GRAZE_ELIMIT, GRAZE_ECANCELED, GRAZE_ESYSTEM, GRAZE_EINTERNAL. */
graze_status depth_measure(depths *d, graze_context *context, const graze_scene *scene);

#endif
