/* JSON strings and base64.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/page/page.h"

#include <string.h>

void encode_string(json_writer *w, const char *key, const char *string) {
    text *out = json_begin(w, key);
    text_put(out, "\"");
    while (*string) {
        size_t n = canvas_character(string);
        if (n == 0)
            text_put(out, "?");
        else if (strchr("\"\\<>&", *string))
            text_format(out, "\\u%04x", (unsigned)(unsigned char)*string);
        else
            text_bytes(out, string, n);
        string += n ? n : 1;
    }
    text_put(out, "\"");
}

static void put_triple(encoder *e) {
    static const char letters[] =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const unsigned char *b = e->rest;
    char four[4] = {letters[b[0] >> 2], letters[(b[0] & 3) << 4 | b[1] >> 4],
                    letters[(b[1] & 15) << 2 | b[2] >> 6], letters[b[2] & 63]};
    for (int k = e->held + 1; k < 4; k++)
        four[k] = '=';
    text_bytes(e->out, four, 4);
    e->held = 0;
    memset(e->rest, 0, sizeof e->rest);
}

void encode_begin(encoder *e, json_writer *w, const char *key) {
    *e = (encoder){.out = json_begin(w, key)};
    text_put(e->out, "\"");
}

void encode_byte(encoder *e, unsigned char byte) {
    e->rest[e->held++] = byte;
    if (e->held == 3)
        put_triple(e);
}

void encode_double(encoder *e, double value) {
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    for (int k = 0; k < 8; k++)
        encode_byte(e, (unsigned char)(bits >> 8 * k));
}

void encode_float(encoder *e, double value) {
    float rounded = (float)value;
    uint32_t bits;
    memcpy(&bits, &rounded, sizeof bits);
    encode_count(e, bits);
}

void encode_place(encoder *e, const fmpq *place, const double *centre, int d) {
    for (int k = 0; k < d; k++)
        encode_float(e, fmpq_get_d(place + k) - centre[k]);
}

void encode_count(encoder *e, uint32_t value) {
    for (int k = 0; k < 4; k++)
        encode_byte(e, (unsigned char)(value >> 8 * k));
}

void encode_end(encoder *e) {
    if (e->held)
        put_triple(e);
    text_put(e->out, "\"");
}
