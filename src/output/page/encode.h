/* Values of a page's data: strings of JSON, and arrays of numbers as base64.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_PAGE_ENCODE_H
#define GRAZE_PAGE_ENCODE_H

#include <stdint.h>
#include "base/number/text.h"

/** A string of JSON that may stand within a script of HTML. Bytes that are no character become
 * question marks. */
void encode_string(text *out, const char *string);
/** A double as JSON, with 17 digits; null unless it is finite. */
void encode_number(text *out, double value);

/** An array of little-endian numbers as a string of base64. Zeroed but for `out` to begin with. */
typedef struct encoder {
    text *out;
    unsigned char rest[3];
    int held;
} encoder;

/** Begin an array behind a text. */
void encode_begin(encoder *e, text *out, const char *before);
void encode_byte(encoder *e, unsigned char byte);
void encode_double(encoder *e, double value);
void encode_float(encoder *e, float value);
void encode_count(encoder *e, uint32_t value);
void encode_end(encoder *e);

#endif
