/* Puts members of JSON objects. SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/compare/json_put.h"

#include <string.h>

void put_key_text(yajl_gen g, const char *text) {
    yajl_gen_string(g, (const unsigned char *)text, strlen(text));
}

void put_named(yajl_gen g, const char *name, const char *text) {
    put_key_text(g, name);
    if (text)
        put_key_text(g, text);
    else
        yajl_gen_null(g);
}

void put_json_count(yajl_gen g, const char *name, unsigned long count) {
    put_key_text(g, name);
    yajl_gen_integer(g, (long long)count);
}
