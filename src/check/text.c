/* Reads files, their lines and their tokens.
 * SPDX-License-Identifier: MIT
 */
#include "base.h"

#include <stdint.h>
#include <string.h>

lines lines_open(const char *path) {
    lines l = {.path = path, .file = fopen(path, "rb")};
    if (!l.file)
        give_up("%s: cannot be opened", path);
    return l;
}

/* Read the bytes before the next `stop` or the end of the file; returns 0 if the file was already
 * at its end. */
static int read_up_to(lines *l, word *out, int stop, size_t most) {
    size_t n = 0;
    int c;
    l->text = room_for(l->text, n, &l->room, 1);
    while ((c = getc(l->file)) != EOF && c != stop) {
        if (n >= most)
            give_up("%s:%zu: a line of more than %zu bytes", l->path, l->line + 1, most);
        l->text = room_for(l->text, n, &l->room, 1);
        l->text[n++] = (char)c;
    }
    must(!ferror(l->file), "%s: cannot be read", l->path);
    *out = (word){l->text, n};
    return n > 0 || c != EOF;
}

int lines_next(lines *l, word *out) {
    int more = read_up_to(l, out, '\n', MOST_LINE);
    l->line += (size_t)more;
    return more;
}

source source_open(const char *path, const char *sha256, const char *marks) {
    lines l = lines_open(path);
    char found[65];
    word all;
    read_up_to(&l, &all, EOF, SIZE_MAX);
    fclose(l.file);
    sha256_text(found, all.at, all.length);
    if (strcmp(found, sha256) != 0)
        refute("%s: its SHA-256 is not that of the certificate", path);
    size_t mark = all.length >= 3 && memcmp(all.at, "\xEF\xBB\xBF", 3) == 0 ? 3 : 0;
    return (source){path, all.at + mark, all.at + all.length, 1, marks, 0, 0};
}

void source_fail(const source *f, const char *what) {
    give_up("%s:%zu: %s", f->path, f->line, what);
}

/* Skip blanks and comments; note in `first` whether a line ended among them. */
static void skip_blanks(source *f) {
    int comment = 0;
    f->first = 0;
    for (; f->at < f->end; f->at++) {
        comment = (comment || (f->comments && *f->at == '#')) && *f->at != '\n';
        if (!comment && (*f->at == '\0' || !strchr(BLANKS, *f->at)))
            return;
        f->first = f->first || *f->at == '\n';
        f->line += *f->at == '\n';
    }
}

word token(source *f) {
    skip_blanks(f);
    word rest = {f->at, (size_t)(f->end - f->at)}, out = rest;
    if (!word_take(&rest, f->marks)) {
        (void)word_cut(&rest, f->marks);
    } else if (*out.at == '"') {
        (void)word_cut(&rest, "\"\r\n");
        if (!word_take(&rest, "\""))
            source_fail(f, "a string has no end");
    }
    f->at = rest.at;
    out.length -= rest.length;
    return out;
}

void token_want(source *f, const char *expected) {
    source list = {.at = expected, .end = expected + strlen(expected), .marks = BLANKS};
    for (word want = token(&list); want.length > 0; want = token(&list)) {
        word w = token(f);
        if (w.length != want.length || memcmp(w.at, want.at, w.length) != 0)
            give_up("%s:%zu: '%.*s'; expected %.*s", f->path, f->line, WORD(w), (int)want.length,
                    want.at);
    }
}

int token_goes_on(source *f, const char *close) {
    word w = token(f);
    if (word_is(w, ","))
        return 1;
    if (!word_is(w, close))
        give_up("%s:%zu: '%.*s'; expected ',' or %s", f->path, f->line, WORD(w), close);
    return 0;
}
