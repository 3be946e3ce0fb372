/* JSON text as a tree.
 * SPDX-License-Identifier: MIT
 */
#include "json.h"

#include <string.h>

typedef struct reader {
    const char *path, *at, *end;
    size_t line, depth;
} reader;

static _Noreturn void fail(const reader *r, const char *what) {
    give_up("%s:%zu: %s", r->path, r->line, what);
}

static void blanks(reader *r) {
    for (; r->at < r->end && *r->at && strchr(" \t\r\n", *r->at); r->at++)
        r->line += *r->at == '\n';
}

static int next_is(reader *r, char c) {
    blanks(r);
    return r->at < r->end && *r->at == c;
}

static void expect(reader *r, char c, const char *what) {
    if (!next_is(r, c))
        fail(r, what);
    r->at++;
}

static word read_string(reader *r) {
    expect(r, '"', "a string is expected");
    word out = {r->at, 0};
    while (r->at < r->end && *r->at != '"') {
        if (*r->at == '\\' || (unsigned char)*r->at < ' ')
            fail(r, "a backslash or control character in a string");
        r->at++;
        out.length++;
    }
    expect(r, '"', "a string has no end");
    return out;
}

static int is_digit(const reader *r) {
    return r->at < r->end && *r->at >= '0' && *r->at <= '9';
}

static void digits(reader *r) {
    if (!is_digit(r))
        fail(r, "a JSON value is expected");
    while (is_digit(r))
        r->at++;
}

static word read_number(reader *r) {
    word out = {r->at, 0};
    if (next_is(r, '-'))
        r->at++;
    if (r->at < r->end && *r->at == '0')
        r->at++;
    else
        digits(r);
    if (r->at < r->end && *r->at == '.') {
        r->at++;
        digits(r);
    }
    if (r->at < r->end && (*r->at == 'e' || *r->at == 'E')) {
        r->at++;
        if (r->at < r->end && (*r->at == '+' || *r->at == '-'))
            r->at++;
        digits(r);
    }
    out.length = (size_t)(r->at - out.at);
    return out;
}

static json read_value(reader *r);

static void read_items(reader *r, json *out, char close) {
    size_t room = 0;
    r->at++;
    if (++r->depth > MOST_DEPTH)
        fail(r, "too many brackets within each other");
    if (!next_is(r, close))
        do {
            word key = {NULL, 0};
            out->item = room_for(out->item, out->count, &room, sizeof *out->item);
            if (close == '}') {
                blanks(r);
                key = read_string(r);
                for (size_t k = 0; k < out->count; k++)
                    if (out->item[k].key.length == key.length &&
                        memcmp(out->item[k].key.at, key.at, key.length) == 0)
                        fail(r, "a key stands twice in one object");
                expect(r, ':', "':' is expected");
            }
            json value = read_value(r);
            value.key = key;
            out->item[out->count++] = value;
        } while (next_is(r, ',') && r->at++);
    expect(r, close, "',' or a closing bracket is expected");
    r->depth--;
}

static int take(reader *r, const char *name) {
    size_t n = strlen(name);
    if ((size_t)(r->end - r->at) < n || memcmp(r->at, name, n) != 0)
        return 0;
    r->at += n;
    return 1;
}

static json read_value(reader *r) {
    json out = {.kind = JSON_NUMBER};
    blanks(r);
    out.line = r->line;
    if (next_is(r, '{') || next_is(r, '[')) {
        out.kind = *r->at == '{' ? JSON_OBJECT : JSON_ARRAY;
        read_items(r, &out, *r->at == '{' ? '}' : ']');
    } else if (next_is(r, '"')) {
        out.kind = JSON_STRING;
        out.text = read_string(r);
    } else if (take(r, "true") || take(r, "false") || take(r, "null")) {
        out.kind = JSON_OTHER;
    } else {
        out.text = read_number(r);
    }
    return out;
}

json json_read(const char *path, const char *text, size_t length) {
    reader r = {path, text, text + length, 1, 0};
    if (length >= 3 && memcmp(text, "\xEF\xBB\xBF", 3) == 0)
        r.at += 3;
    json out = read_value(&r);
    blanks(&r);
    if (r.at != r.end)
        fail(&r, "text follows the JSON value");
    return out;
}

const json *json_member(const json *object, const char *key) {
    for (size_t k = 0; k < object->count; k++)
        if (object->kind == JSON_OBJECT && word_is(object->item[k].key, key))
            return &object->item[k];
    return NULL;
}
