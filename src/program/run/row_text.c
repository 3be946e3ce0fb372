/* Cuts rows and knows numbers as graze writes them.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "program/run/row_text.h"

#include <ctype.h>

field row_take(field *rest, char separator) {
    field out = {rest->start, 0}; /* fields are a few bytes long */
    while (out.length < rest->length && out.start[out.length] != separator)
        out.length++;
    size_t gone = out.length + (out.length < rest->length);
    *rest = (field){rest->start + gone, rest->length - gone};
    return out;
}

/* A minus, digits without a zero in front; then nothing, or a slash and the same from 2 up. */
int row_is_number(field f) {
    const char *at = f.start, *end = at + f.length;
    for (int part = 0; part < 2; part++) {
        int minus = part == 0 && at < end && *at == '-';
        at += minus;
        int zero = at < end && *at == '0';
        const char *digits = at;
        while (at < end && isdigit((unsigned char)*at))
            at++;
        if (at == digits || (zero && (at - digits > 1 || minus || part == 1)))
            return 0;
        if (at == end)
            return part == 0 || at - digits > 1 || *digits > '1';
        if (*at++ != '/' || zero)
            return 0;
    }
    return 0;
}
