/* A text as lines of tokens (token_lines.h).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <strings.h>
#include "base/context/scope.h"
#include "base/number/rational.h"
#include "input/read/token_lines.h"

static void find_stops(lines *l) {
    memset(l->stops, 0, sizeof l->stops);
    for (const char *c = "\n \t\r\v\f"; *c != '\0'; c++)
        l->stops[(unsigned char)*c] = 1;
    for (const char *c = l->marks; *c != '\0'; c++)
        l->stops[(unsigned char)*c] = 1;
    l->stops[(unsigned char)l->comment] =
        1; /* if there are no comments this is NUL, which no text has */
    l->stops['\\'] = l->continued != 0;
}

void lines_begin(lines *l, const char *text, size_t length) {
    int marked = length >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0;
    find_stops(l);
    l->line = l->where = 1;
    l->at = text + (marked ? 3 : 0);
    l->end = text + length;
}

graze_status lines_start(lines *l, const char *text, size_t length) {
    lines_begin(l, text, length);
    text = l->at;
    while (text < l->end) {
        const char *newline = memchr(text, '\n', (size_t)(l->end - text));
        size_t size = (size_t)((newline == NULL ? l->end : newline) - text);
        if (size > l->context->limits[GRAZE_LIMIT_LINE])
            return lines_at(l, context_limit(l->context, GRAZE_LIMIT_LINE, "bytes of a line"));
        if (memchr(text, '\0', size) != NULL)
            return lines_fail(l, GRAZE_EINPUT, "a NUL byte; expected a text in UTF-8");
        const char *cr = memchr(text, '\r', size);
        if (cr != NULL && cr + 1 != newline)
            return lines_fail(l, GRAZE_EINPUT,
                              "a carriage return within the line; expected LF or CRLF at its end");
        l->where++;
        text += size + (newline != NULL);
    }
    l->where = 1;
    return GRAZE_OK;
}

/* The length of a backslash and a line's end at p, which join the line to the next one; 0 if they
 * are not there. */
static size_t joined(const lines *l, const char *p) {
    if (!l->continued || *p != '\\')
        return 0;
    size_t n = 1 + (size_t)(p + 1 < l->end && p[1] == '\r');
    return p + n < l->end && p[n] == '\n' ? n + 1 : 0;
}

static int is_blank_byte(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

static void skip_blanks(lines *l) {
    while (l->at < l->end) {
        size_t join = joined(l, l->at);
        if (join > 0) {
            l->at += join;
            l->line++;
        } else if (is_blank_byte(*l->at)) {
            l->at++;
        } else {
            break;
        }
    }
    if (l->comment != '\0' && l->at < l->end && *l->at == l->comment) {
        const char *newline = memchr(l->at, '\n', (size_t)(l->end - l->at));
        l->at = newline == NULL ? l->end : newline;
    }
}

int lines_token(lines *l, token *out) {
    skip_blanks(l);
    *out = (token){l->at, 0};
    if (l->at == l->end || *l->at == '\n')
        return 0;
    l->where = l->line;
    if (*l->marks != '\0' && strchr(l->marks, *l->at)) {
        l->at++;
    } else {
        const char *p = l->at;
        while (p < l->end && (!l->stops[(unsigned char)*p] || (*p == '\\' && joined(l, p) == 0)))
            p++;
        l->at = p;
    }
    out->length = (size_t)(l->at - out->text);
    return 1;
}

int lines_next(lines *l) {
    token rest;
    while (lines_token(l, &rest)) {
    }
    while (l->at < l->end && *l->at == '\n') {
        l->at++;
        l->line++;
        skip_blanks(l);
    }
    if (l->at < l->end)
        l->where = l->line;
    return l->at < l->end;
}

int lines_any(lines *l, token *out) {
    while (!lines_token(l, out)) {
        if (l->at == l->end)
            return 0;
        l->at++;
        l->line++;
    }
    return 1;
}

graze_status lines_at(const lines *l, graze_status status) {
    return context_in(l->context, status, l->path, l->where);
}

graze_status lines_numbers(lines *l, fmpq *out, int count, const char *what, size_t index) {
    for (int k = 0; k < count; k++) {
        token t;
        if (!lines_token(l, &t))
            return lines_fail(l, GRAZE_EINPUT, "%s %zu: the line has %d of its %d numbers", what,
                              index, k, count);
        graze_status status = rational_parse(out + k, l->context, t.text, t.length);
        TRY(lines_at(l, context_item(l->context, status, what, index, NULL)));
    }
    return GRAZE_OK;
}

graze_status facet_begin(soup *s, graze_context *context) {
    TRY(soup_add_facet(s, context));
    return soup_add_cycle(s, context, NULL, 0);
}

graze_status lines_cells(lines *l, size_t *out, const char *what) {
    token t;
    long long value;
    if (!lines_any(l, &t))
        return lines_fail(l, GRAZE_EINPUT, "the file ends before the number of %s", what);
    if (!token_integer(t, &value) || value < 0)
        return lines_fail(l, GRAZE_EINPUT, "'%.*s' is not a number of %s; expected a plain integer",
                          TOKEN_SHOWN(t), what);
    if ((unsigned long long)value > l->context->limits[GRAZE_LIMIT_CELLS])
        return lines_at(l, context_limit(l->context, GRAZE_LIMIT_CELLS, what));
    *out = (size_t)value;
    return GRAZE_OK;
}

int token_is(token t, const char *word) {
    return strlen(word) == t.length && strncasecmp(t.text, word, t.length) == 0;
}

int token_integer(token t, long long *out) {
    const long long most = 1000000000000000000;
    size_t k = t.length > 0 && (t.text[0] == '-' || t.text[0] == '+');
    int negative = k == 1 && t.text[0] == '-';
    long long value = 0;
    if (k == t.length)
        return 0;
    for (; k < t.length; k++) {
        if (t.text[k] < '0' || t.text[k] > '9')
            return 0;
        value = value >= most / 10 ? most : 10 * value + (t.text[k] - '0');
    }
    *out = negative ? -value : value;
    return 1;
}
