/* Points to be drawn, with their names and strata.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CLI_MARKS_H
#define GRAZE_CLI_MARKS_H

#include "graze.h"

/** Points of one dimension; the texts are malloc'ed. Zeroed but for `dimension`: none. */
typedef struct marks {
    int dimension;
    mpq_t *value;
    size_t values, value_capacity; /* values that are initialised */
    char **name, **stratum;        /* of a stratum NULL where the file has none */
    size_t count, capacity, stratum_capacity;
} marks;

void marks_clear(marks *m);
/** Add the points of a CSV file or `-`, named by the column id or by their numbers. Returns an exit
 * status and says what is wrong. */
int marks_read(marks *m, const char *path, graze_context *context);
/** Add the points of the option -p. */
int marks_take_points(marks *m, const char *const *points, int count, graze_context *context);
/** Points and names as options of a picture. */
void marks_give(graze_draw_options *out, const marks *m);

#endif
