/* Members of JSON objects.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_COMPARE_JSON_PUT_H
#define GRAZE_COMPARE_JSON_PUT_H

#include <yajl/yajl_gen.h>

/** A string. */
void put_key_text(yajl_gen g, const char *text);
/** A member that is a string; NULL: null. */
void put_named(yajl_gen g, const char *name, const char *text);
/** A member that is a number. */
void put_json_count(yajl_gen g, const char *name, unsigned long count);

#endif
