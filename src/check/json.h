/* JSON text as a tree, strictly (RFC 8259), each key of an object once.
 * SPDX-License-Identifier: MIT
 */
#ifndef CHECK_JSON_H
#define CHECK_JSON_H

#include "base.h"

typedef enum json_kind { JSON_OBJECT, JSON_ARRAY, JSON_STRING, JSON_NUMBER, JSON_OTHER } json_kind;

/** A string's text is as it stands in the file; one with a backslash is refused, since no word or
 * expression of a motion has one. */
typedef struct json {
    json_kind kind;
    word key;  /* of a member of an object */
    word text; /* of a string or number */
    size_t count;
    struct json *item;
    size_t line;
} json;

/** Read a whole text; gives up where it is not JSON. */
json json_read(const char *path, const char *text, size_t length);
/** The member of an object by its key, or NULL. */
const json *json_member(const json *object, const char *key);

#endif
