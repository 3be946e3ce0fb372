/* Forms in which tables write the coordinates of points: --coordinates and --digits.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_RUN_COORDINATES_H
#define GRAZE_RUN_COORDINATES_H

#include "base/number/text.h"
#include "program/run/columns.h"

typedef enum coordinate_form {
    COORDINATES_EXACT,
    COORDINATES_AS_GIVEN,
    COORDINATES_DECIMAL,
    COORDINATES_UNSET /* the command chooses */
} coordinate_form;

/** Zeroed: integers and ratios in lowest terms. */
typedef struct coordinate_options {
    coordinate_form form;
    int digits; /* of rounded decimals; 0: decimals are the numbers themselves */
} coordinate_options;

/** Does --digits go with --coordinates? Returns an exit status and says what is wrong. */
int coordinates_check(const coordinate_options *o);

/** Room for coordinates_note. */
enum { COORDINATES_NOTE = 64 };

/** The line `# coordinates ...` of a table's head; empty for exact ones. */
void coordinates_note(char out[COORDINATES_NOTE], const coordinate_options *o);

/**
 * Add a point's coordinates.
 * @param tokens a field for each coordinate, as it was read; for COORDINATES_AS_GIVEN alone
 * @return EXIT_DONE, or the status of the fault, whose message begins with `where`
 */
int coordinates_put(text *out, fault *f, const coordinate_options *o, graze_context *context,
                    mpq_t *point, int dimension, const field *tokens, const char *where);

#endif
