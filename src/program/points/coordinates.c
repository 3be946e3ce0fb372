/* Writes the coordinates of points in the form asked for.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "program/points/heads.h"

#include <stdio.h>
#include <string.h>

int coordinates_check(const coordinate_options *o) {
    if (o->digits && o->form != COORDINATES_DECIMAL)
        return complain(EXIT_USAGE, "--digits goes with --coordinates decimal");
    return EXIT_DONE;
}

void coordinates_note(char out[COORDINATES_NOTE], const coordinate_options *o) {
    *out = '\0';
    if (o->form == COORDINATES_AS_GIVEN)
        strcpy(out, "# coordinates as-given\n");
    else if (o->form == COORDINATES_DECIMAL && !o->digits)
        strcpy(out, "# coordinates decimal\n");
    else if (o->form == COORDINATES_DECIMAL)
        snprintf(out, COORDINATES_NOTE, "# coordinates decimal %d\n", o->digits);
}

/* Add one number as a decimal. */
static int put_decimal_coordinate(text *out, fault *f, const coordinate_options *o,
                                  graze_context *context, const mpq_t value, char axis,
                                  const char *where) {
    char *decimal = NULL;
    graze_status made = graze_number_decimal(&decimal, context, value, o->digits);
    if (made == GRAZE_EINPUT)
        return fault_set(f, EXIT_INPUT,
                         "%s: %c has no finite decimal; expected --digits N, which rounds it, or "
                         "--coordinates exact",
                         where, axis);
    if (made)
        return fault_of(f, made, context, EXIT_FAULT);
    text_put(out, decimal);
    graze_free(decimal);
    return EXIT_DONE;
}

int coordinates_put(text *out, fault *f, const coordinate_options *o, graze_context *context,
                    mpq_t *point, int dimension, const field *tokens, const char *where) {
    int status = EXIT_DONE;
    for (int k = 0; k < dimension && !status; k++) {
        text_put(out, k ? "," : "");
        if (o->form == COORDINATES_AS_GIVEN) {
            text_bytes(out, tokens[k].start, tokens[k].length);
        } else if (o->form == COORDINATES_DECIMAL) {
            status = put_decimal_coordinate(out, f, o, context, point[k], (char)('x' + k), where);
        } else {
            text_owned(out, numbers_text(point[k]));
        }
    }
    return !status && out->failed ? fault_set(f, EXIT_IO, "out of memory") : status;
}
