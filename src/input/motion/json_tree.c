/* A JSON text as a tree that keeps number tokens as written and knows the line of every value.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * yajl reads the text; its callbacks append to the tree. Invariant while reading: `open` is the
 * innermost array or object not yet closed, `depth` the number of open ones.
 */
#include "input/motion/motion.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <yajl/yajl_parse.h>
#include "base/context/array.h"
#include "base/context/json_memory.h"

enum { PATH_SIZE = 400 };

typedef struct builder {
    json_document *document;
    graze_context *context;
    const char *source, *text;
    json_memory memory;
    yajl_handle handle;
    json *open;
    char *key; /* the last key; its value is still to come if `keyed` */
    size_t key_length, key_room;
    int keyed;
    size_t depth, line, counted; /* lines are counted up to byte `counted` */
    graze_status status;
} builder;

static void count_lines(builder *b) {
    size_t reached = yajl_get_bytes_consumed(b->handle);
    for (; b->counted < reached; b->counted++)
        b->line += b->text[b->counted] == '\n';
}

static int out_of_memory(builder *b) {
    b->status =
        context_fail_in(b->context, GRAZE_ESYSTEM, b->source, 0, "no memory for its values");
    return 0;
}

/* Copy bytes and a NUL to a place. Returns the place behind the NUL. */
static char *keep_bytes(char *out, const char *bytes, size_t length) {
    if (length > 0)
        memcpy(out, bytes, length);
    out[length] = '\0';
    return out + length + 1;
}

/* Append a value to the open one. Behind it in its block stand its key, if it has one, and its
 * text, if there are bytes. Returns NULL if memory is short. */
static json *append_value(builder *b, json_kind kind, const char *bytes, size_t length) {
    count_lines(b);
    size_t room = (b->keyed ? b->key_length + 1 : 0) + (bytes != NULL ? length + 1 : 0);
    json *value = malloc(sizeof *value + room);
    if (value == NULL) {
        out_of_memory(b);
        return NULL;
    }
    char *behind = (char *)(value + 1);
    *value = (json){.kind = kind,
                    .line = b->line,
                    .parent = b->open,
                    .source = b->source,
                    .previous = b->document->newest};
    if (b->keyed) {
        value->key = behind;
        value->key_length = b->key_length;
        behind = keep_bytes(behind, b->key, b->key_length);
    }
    if (bytes != NULL) {
        value->text = behind;
        value->length = length;
        keep_bytes(behind, bytes, length);
    }
    b->document->newest = value;
    b->keyed = 0;
    if (b->open == NULL) {
        b->document->root = value;
        return value;
    }
    value->index = b->open->count++;
    if (b->open->last == NULL)
        b->open->first = value;
    else
        b->open->last->next = value;
    b->open->last = value;
    return value;
}

static int on_null(void *data) {
    return append_value(data, JSON_NULL, NULL, 0) != NULL;
}

static int on_boolean(void *data, int value) {
    (void)value;
    return append_value(data, JSON_BOOLEAN, NULL, 0) != NULL;
}

static int on_number(void *data, const char *bytes, size_t length) {
    return append_value(data, JSON_NUMBER, bytes, length) != NULL;
}

static int on_string(void *data, const unsigned char *bytes, size_t length) {
    return append_value(data, JSON_STRING, (const char *)bytes, length) != NULL;
}

static int on_key(void *data, const unsigned char *bytes, size_t length) {
    builder *b = data;
    if (!array_reserve(&b->key, &b->key_room, length + 1, 1))
        return out_of_memory(b);
    keep_bytes(b->key, (const char *)bytes, length);
    b->key_length = length;
    b->keyed = 1;
    return 1;
}

static int on_start(builder *b, json_kind kind) {
    json *value = append_value(b, kind, NULL, 0);
    if (value == NULL)
        return 0;
    b->open = value;
    b->depth++;
    if (b->depth > b->context->limits[GRAZE_LIMIT_DEPTH]) {
        context_limit(b->context, GRAZE_LIMIT_DEPTH, "nesting of JSON values");
        b->status = context_in(b->context, GRAZE_ELIMIT, b->source, b->line);
        return 0;
    }
    return 1;
}

static int on_start_object(void *data) {
    return on_start(data, JSON_OBJECT);
}

static int on_start_array(void *data) {
    return on_start(data, JSON_ARRAY);
}

static int on_end(void *data) {
    builder *b = data;
    b->open = b->open->parent;
    b->depth--;
    return 1;
}

/* Fail with the message of yajl, up to its first full stop or line end. */
static void syntax_error(builder *b, size_t length) {
    count_lines(b);
    unsigned char *words = yajl_get_error(b->handle, 0, (const unsigned char *)b->text, length);
    words[strcspn((char *)words, ".\n")] = '\0';
    b->status = context_fail_in(b->context, GRAZE_EINPUT, b->source, b->line,
                                "not JSON: %s; expected an object, {...}, with expressions between "
                                "quotes, as \"8*t\"; a motion stands behind its solid",
                                (char *)words);
}

/* Let yajl read the whole text. */
static void parse(builder *b, const char *text, size_t length) {
    static const yajl_callbacks callbacks = {
        .yajl_null = on_null,
        .yajl_boolean = on_boolean,
        .yajl_number = on_number,
        .yajl_string = on_string,
        .yajl_start_map = on_start_object,
        .yajl_map_key = on_key,
        .yajl_end_map = on_end,
        .yajl_start_array = on_start_array,
        .yajl_end_array = on_end,
    };
    json_memory_init(&b->memory);
    if (setjmp(b->memory.short_of) != 0) {
        out_of_memory(b);
        return;
    }
    b->handle = yajl_alloc(&callbacks, &b->memory.functions, b);
    yajl_status parsed = yajl_parse(b->handle, (const unsigned char *)text, length);
    if (parsed == yajl_status_ok)
        parsed = yajl_complete_parse(b->handle);
    if (parsed == yajl_status_error)
        syntax_error(b, length);
}

graze_status json_parse(json_document *out, graze_context *context, const char *source,
                        const char *text, size_t length) {
    *out = (json_document){NULL, NULL};
    if (length >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0) {
        text += 3;
        length -= 3;
    }
    size_t blanks = 0;
    while (blanks < length && strchr(" \t\r\n", text[blanks]) != NULL && text[blanks] != '\0')
        blanks++;
    if (blanks == length)
        return context_fail_in(context, GRAZE_EINPUT, source, 0, "empty; expected a JSON object");
    builder b = {.document = out, .context = context, .source = source, .text = text, .line = 1};
    parse(&b, text, length);
    json_memory_clear(&b.memory);
    free(b.key);
    return b.status;
}

void json_clear(json_document *document) {
    for (json *value = document->newest; value != NULL;) {
        json *previous = value->previous;
        free(value);
        value = previous;
    }
    *document = (json_document){NULL, NULL};
}

/* The path from the root to a value. If the buffer is too short, the front of the path is cut off.
 */
static const char *path_of(char buffer[PATH_SIZE], const json *value) {
    size_t start = PATH_SIZE - 1;
    buffer[start] = '\0';
    for (; value->parent != NULL; value = value->parent) {
        char step[64];
        if (value->parent->kind == JSON_ARRAY) {
            snprintf(step, sizeof step, "[%zu]", value->index);
        } else {
            snprintf(step, sizeof step, "%s%.50s", value->parent->parent != NULL ? "." : "",
                     value->key);
        }
        size_t n = strlen(step);
        if (n + 3 > start) {
            start -= 3;
            memcpy(buffer + start, "...", 3);
            break;
        }
        start -= n;
        memcpy(buffer + start, step, n);
    }
    return buffer[start] != '\0' ? buffer + start : "motion";
}

graze_status json_fail(graze_context *context, graze_status status, const json *where,
                       const char *format, ...) {
    char text[CONTEXT_MESSAGE_SIZE];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    context_fail(context, status, "%s", text);
    return json_at(context, status, where);
}

graze_status json_at(graze_context *context, graze_status status, const json *where) {
    char path[PATH_SIZE];
    if (status == GRAZE_OK)
        return status;
    context_item(context, status, NULL, 0, path_of(path, where));
    return context_in(context, status, where->source, where->line);
}

graze_status json_at_last(graze_context *context, graze_status status, const json *where) {
    size_t n = strlen(where->source);
    int placed = strncmp(context->message, where->source, n) == 0 && context->message[n] == ':';
    return status == GRAZE_OK || placed ? status : json_at(context, status, where);
}

/* "a, b, c" */
static void join_names(char *out, size_t size, const char *const *names, size_t count) {
    size_t used = 0;
    out[0] = '\0';
    for (size_t k = 0; k < count && used < size; k++)
        used += (size_t)snprintf(out + used, size - used, "%s%s", k > 0 ? ", " : "", names[k]);
}

graze_status json_members(const json **out, graze_context *context, const json *object,
                          const char *const *names, size_t count) {
    for (size_t k = 0; k < count; k++)
        out[k] = NULL;
    char known[200];
    join_names(known, sizeof known, names, count);
    if (object->kind != JSON_OBJECT)
        return json_fail(context, GRAZE_EINPUT, object, "expected an object with keys among %s",
                         known);
    for (const json *member = object->first; member != NULL; member = member->next) {
        size_t k = 0;
        while (k < count && (strlen(names[k]) != member->key_length ||
                             memcmp(names[k], member->key, member->key_length) != 0))
            k++;
        if (k == count) {
            int angle = !strncmp(member->key, "deg", 3) || !strncmp(member->key, "angle", 5);
            return json_fail(context, GRAZE_EINPUT, member, "unknown key; expected one of %s%s",
                             known, angle ? "; `graze motion rotate` takes degrees" : "");
        }
        if (out[k] != NULL)
            return json_fail(context, GRAZE_EINPUT, member,
                             "this key is repeated; the first is in line %zu", out[k]->line);
        out[k] = member;
    }
    return GRAZE_OK;
}

graze_status json_array(graze_context *context, const json *value, size_t count) {
    if (value->kind != JSON_ARRAY)
        return json_fail(context, GRAZE_EINPUT, value, "expected an array");
    if (count > 0 && value->count != count)
        return json_fail(context, GRAZE_EINPUT, value, "expected an array of %zu entries, not %zu",
                         count, value->count);
    return GRAZE_OK;
}
