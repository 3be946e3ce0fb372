/* A text as lines of tokens, with line numbers for messages, for the readers of solids.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A token is a run of bytes without blanks; a byte of `marks` is a token by itself. Tokens point
 * into the text and nothing is copied.
 */
#ifndef GRAZE_READ_TOKEN_LINES_H
#define GRAZE_READ_TOKEN_LINES_H

#include <flint/fmpq.h>
#include "base/context/context.h"

typedef struct token {
    const char *text;
    size_t length;
} token;

typedef struct lines {
    graze_context *context;
    const char *path;
    const char *marks; /* bytes that are tokens by themselves; "" for none */
    char comment;      /* begins a comment that ends with its line; 0 for none */
    int continued;     /* a backslash before the line's end joins the next line */
    const char *at;    /* first byte not yet read */
    const char *end;
    size_t line;              /* of `at`, from 1 */
    size_t where;             /* line of the last token read, for messages */
    unsigned char stops[256]; /* bytes that end a token, a backslash only before a line's end */
} lines;

/** Begin a text whose first five fields are set; a byte order mark is skipped. */
void lines_begin(lines *l, const char *text, size_t length);

/**
 * Begin a text, and look through it first.
 * @return GRAZE_ELIMIT a line is too long; GRAZE_EINPUT a NUL byte or a lone carriage return
 */
graze_status lines_start(lines *l, const char *text, size_t length);

/** The next token of this line; 0 at the line's end, before its newline. */
int lines_token(lines *l, token *out);

/** Step over the rest of this line and over lines without tokens; 0 at the end of the text. */
int lines_next(lines *l);

/** The next token on this line or a later one; 0 at the end of the text. */
int lines_any(lines *l, token *out);

/** Fail with "path:line: " of the last token before the message. */
graze_status lines_fail(const lines *l, graze_status status, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/** Put "path:line: " before the message of a failure on its way up. */
graze_status lines_at(const lines *l, graze_status status);

/** Read the next `count` tokens of this line as numbers. `what` and `index` name
 * their owner in messages. */
graze_status lines_numbers(lines *l, fmpq *out, int count, const char *what, size_t index);

/** A number of cells: a plain integer within the cells limit. `what` names them, in the plural. */
graze_status lines_cells(lines *l, size_t *out, const char *what);

/** The word, in any case. */
int token_is(token t, const char *word);

/** Is it an integer with or without sign? The value is held within +-10^18. */
int token_integer(token t, long long *out);

/** For messages: `%.*s` of the token, shortened. */
#define TOKEN_SHOWN(t) ((t).length > 40 ? 40 : (int)(t).length), (t).text

#endif
