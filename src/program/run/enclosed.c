/* Reads the decimals of enclosures.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#define _GNU_SOURCE /* memmem, memrchr */
#include "program/run/enclosed.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Are all letters of a field among these? */
static int is_made_of(field f, const char *letters) {
    for (size_t k = 0; k < f.length; k++)
        if (!strchr(letters, f.start[k]) || !f.start[k])
            return 0;
    return f.length > 0;
}

/* A whole field as a double; NaN if it is no number. */
static double enclosed_bound(field f) {
    char text[64], *end;
    if (f.length >= sizeof text || !is_made_of(f, "-+.e0123456789"))
        return (double)NAN;
    memcpy(text, f.start, f.length);
    text[f.length] = '\0';
    double out = strtod(text, &end);
    return *end ? (double)NAN : out;
}

int enclosed_fits(graze_pmc pmc, field low, field high, field time) {
    double a = enclosed_bound(low), b = enclosed_bound(high);
    if (!is_made_of(time, "-+/.e0123456789"))
        return 0;
    return pmc == GRAZE_OUT  ? a >= 0 && b > 0 && a <= b
           : pmc == GRAZE_IN ? a < 0 && b <= 0 && a <= b
                             : a == 0 && b == 0;
}

/* The last field, which is cut off. */
static field cut_last(field *row) {
    const char *comma = row->length ? memrchr(row->start, ',', row->length) : NULL;
    const char *start = comma ? comma + 1 : row->start;
    field out = {start, (size_t)(row->start + row->length - start)};
    row->length = comma ? (size_t)(comma - row->start) : 0;
    return out;
}

/* A number of an object, up to its comma. */
static field number_of(field row, const char *key) {
    const char *at = memmem(row.start, row.length, key, strlen(key));
    if (!at)
        return (field){"", 0};
    at += strlen(key);
    const char *comma = memchr(at, ',', (size_t)(row.start + row.length - at));
    return (field){at, comma ? (size_t)(comma - at) : 0};
}

int enclosed_is_wide(field row, double tolerance, int behind) {
    field low, high;
    if (row.length && *row.start == '{') {
        low = number_of(row, "\"sdf_low\":");
        high = number_of(row, "\"sdf_high\":");
    } else {
        for (; behind > 0; behind--)
            (void)cut_last(&row);
        (void)cut_last(&row); /* the time */
        high = cut_last(&row);
        low = cut_last(&row);
    }
    return enclosed_bound(high) - enclosed_bound(low) > tolerance;
}
