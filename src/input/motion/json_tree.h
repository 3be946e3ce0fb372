/* A JSON text as a tree that keeps number tokens as written and knows the line of every value.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_MOTION_JSON_TREE_H
#define GRAZE_MOTION_JSON_TREE_H

#include "base/context/context.h"

typedef enum json_kind {
    JSON_NULL,
    JSON_BOOLEAN,
    JSON_NUMBER,
    JSON_STRING,
    JSON_ARRAY,
    JSON_OBJECT
} json_kind;

/** One value, in one block with its text and its key. Children stand in the order of the text; an
 * object's may repeat a key. */
typedef struct json {
    json_kind kind;
    size_t line; /* from 1 */
    char *text;  /* token of a number, decoded bytes of a string; a NUL follows */
    size_t length;
    char *key; /* in an object; a NUL follows, one inside is possible */
    size_t key_length;
    size_t index; /* among its parent's children */
    struct json *parent, *first, *last, *next;
    size_t count;          /* children */
    const char *source;    /* name of the file, borrowed; for messages */
    struct json *previous; /* the value read before this one; the root's is NULL */
} json;

/** A parsed text: the root, and the chain of all values by which they are freed. */
typedef struct json_document {
    json *root, *newest;
} json_document;

/**
 * Read one JSON text, UTF-8, with or without byte order mark.
 * @param[out] out  cleared by json_clear, also after a failure
 * @param source    names the text in messages; borrowed as long as the document lives
 * @return GRAZE_EINPUT with the line; GRAZE_ELIMIT nested past `depth`
 */
graze_status json_parse(json_document *out, graze_context *context, const char *source,
                        const char *text, size_t length);
void json_clear(json_document *document);

/** Fail with "source:line: path: message", where path is such as pieces[1].transform.scale[0]. */
graze_status json_fail(graze_context *context, graze_status status, const json *where,
                       const char *format, ...) __attribute__((format(printf, 4, 5)));
/** Put "source:line: path: " before the message of a failure on its way up; returns `status`. */
graze_status json_at(graze_context *context, graze_status status, const json *where);
/** json_at, unless status is GRAZE_OK or the message begins with the source already. */
graze_status json_at_last(graze_context *context, graze_status status, const json *where);

/**
 * Sort the members of an object by key: out[k] is the value of names[k], NULL where it is missing.
 * @return GRAZE_EINPUT not an object, an unknown key, a key twice
 */
graze_status json_members(const json **out, graze_context *context, const json *object,
                          const char *const *names, size_t count);

/** GRAZE_EINPUT unless the value is an array, and of `count` entries where count is not 0. */
graze_status json_array(graze_context *context, const json *value, size_t count);

#endif
