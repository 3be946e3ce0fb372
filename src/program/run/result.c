/* Writes a table or a certificate, and continues one.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#define _GNU_SOURCE /* memrchr */
#include <errno.h>
#include <sys/stat.h>
#include <unistd.h>
#include "base/context/scope.h"
#include "program/run/results.h"

/* PIECE bytes are read at a time; the notes at the end of a file have fewer than TAIL bytes. */
enum { PIECE = 1 << 16, TAIL = 512 };

/* Read bytes of the file. */
static int read_piece(const result *t, char *to, size_t length, unsigned long long from) {
    while (length) {
        ssize_t n = pread(t->out.fd, to, length, (off_t)from);
        if (n < 0 && errno == EINTR)
            continue;
        if (n < 0)
            return complain(EXIT_IO, "%s: cannot be read: %s", t->resumed, strerror(errno));
        if (n == 0)
            return complain(EXIT_IO, "%s: another program has changed it", t->resumed);
        to += n;
        from += (unsigned long long)n;
        length -= (size_t)n;
    }
    return EXIT_DONE;
}

/* Find the end of the last whole line, from the file's end. */
static int find_whole_lines(result *t) {
    char piece[PIECE];
    for (t->there = t->size; t->there;) {
        size_t length = t->there < PIECE ? (size_t)t->there : PIECE;
        TRY(read_piece(t, piece, length, t->there - length));
        const char *last = memrchr(piece, '\n', length);
        t->there -= length - (last ? (size_t)(last + 1 - piece) : 0);
        if (last)
            break;
    }
    return EXIT_DONE;
}

/* The last line of a text of whole lines, without its end. */
static field last_line(const char *text, size_t length) {
    const char *before = length > 1 ? memrchr(text, '\n', length - 1) : NULL;
    size_t start = before ? (size_t)(before + 1 - text) : 0;
    return (field){text + start, length - start - 1};
}

/* Drop the notes at the end of the file, which are written anew; a file with `complete` is refused.
 */
static int drop_notes(result *t) {
    char tail[TAIL];
    size_t length = t->there < TAIL ? (size_t)t->there : TAIL;
    field value;
    TRY(read_piece(t, tail, length, t->there - length));
    while (length) {
        field line = last_line(tail, length);
        if (line_part_of(t->kind, line) != LINE_NOTE)
            break;
        if (!t->beside && line_note(&value, t->kind, line, COMPLETE_LINE))
            return complain(EXIT_INPUT,
                            "%s: is complete with its %.*s rows; expected an interrupted %s",
                            t->resumed, FIELD_SHOWN(value), result_name(t->kind));
        t->there -= line.length + 1;
        length -= line.length + 1;
    }
    return EXIT_DONE;
}

int result_open(result *t, const char *path, const char *resumed) {
    struct stat about;
    t->resumed = resumed;
    TRY(resumed ? output_continue(&t->out, resumed) : output_open(&t->out, path));
    t->opened = 1;
    if (!resumed)
        return EXIT_DONE;
    TRY(output_lock(&t->out));
    if (fstat(t->out.fd, &about) != 0)
        return complain(EXIT_IO, "%s: cannot be read: %s", resumed, strerror(errno));
    t->size = (unsigned long long)about.st_size;
    TRY(find_whole_lines(t));
    return drop_notes(t);
}

/* Count bytes of the file in its checksum and its lines. */
static void take(result *t, const char *text, size_t length) {
    checksum_add(&t->sum, text, length);
    for (const char *at = text; (at = memchr(at, '\n', length - (size_t)(at - text))); at++)
        t->lines++;
}

int result_pass(result *t, const struct recorded *kept, unsigned long rows) {
    char piece[PIECE];
    while (t->sum.length < kept->length) {
        unsigned long long left = kept->length - t->sum.length;
        size_t length = left < PIECE ? (size_t)left : PIECE;
        TRY(read_piece(t, piece, length, t->sum.length));
        take(t, piece, length);
    }
    if (t->sum.length != kept->length || checksum_value(&t->sum) != kept->sum)
        return complain(EXIT_INPUT,
                        "%s: its first %lu rows are not those that were written; expected a %s "
                        "that was not changed",
                        t->resumed, rows, result_name(t->kind));
    t->rows = rows;
    if (t->sum.length == t->there)
        output_from(&t->out, (long long)t->there);
    return EXIT_DONE;
}

/* Refuse a file that differs from this run at byte `at` of `piece` and `text`, and name the line.
 */
static int refuse_line(const result *t, const char *piece, const char *text, size_t at,
                       size_t length) {
    size_t start = at, n, m;
    unsigned long line = t->lines + 1;
    for (const char *k = text; (k = memchr(k, '\n', at - (size_t)(k - text))); k++)
        line++;
    while (start && text[start - 1] != '\n')
        start--;
    for (n = 0; start + n < length && piece[start + n] != '\n';)
        n++;
    for (m = 0; text[start + m] && text[start + m] != '\n';)
        m++;
    return complain(EXIT_INPUT,
                    "%s:%lu: `%.*s` stands in the file and `%.*s` is this run's: expected a %s of "
                    "this run that was not changed",
                    t->resumed, line, (int)(n < 200 ? n : 200), piece + start,
                    (int)(m < 200 ? m : 200), text + start, result_name(t->kind));
}

/* Check that the next bytes of the file are those of a text. */
static int compare(result *t, const char *text, size_t length) {
    char piece[PIECE];
    while (length) {
        size_t part = length < PIECE ? length : PIECE, at = 0;
        TRY(read_piece(t, piece, part, t->sum.length));
        while (at < part && piece[at] == text[at])
            at++;
        if (at < part)
            return refuse_line(t, piece, text, at, part);
        take(t, text, part);
        text += part;
        length -= part;
    }
    return EXIT_DONE;
}

int result_add(result *t, const char *text, size_t length, unsigned long rows) {
    unsigned long long left = t->there > t->sum.length ? t->there - t->sum.length : 0;
    size_t there = left < length ? (size_t)left : length;
    if (!length) /* a run whose first row has no answer has no text */
        return EXIT_DONE;
    TRY(compare(t, text, there));
    if (there && t->sum.length == t->there)
        output_from(&t->out, (long long)t->there);
    output_bytes(&t->out, text + there, length - there);
    checksum_add(&t->sum, text + there, length - there);
    t->rows += rows;
    return EXIT_DONE;
}

int result_begin(result *t, const char *head) {
    size_t length = strlen(head);
    if (t->there < length) /* in a head, an incomplete line is compared too */
        t->there = t->size < length ? t->size : length;
    return result_add(t, head, length, 0);
}

int result_end(const result *t) {
    if (t->sum.length >= t->there)
        return EXIT_DONE;
    return complain(EXIT_INPUT,
                    "%s: has more than the %lu rows for which there are points; expected the "
                    "points the %s was begun with",
                    t->resumed, t->rows, result_name(t->kind));
}

struct recorded result_recorded(const result *t) {
    return (struct recorded){t->sum.length, checksum_value(&t->sum)};
}

int result_close(result *t, int status) {
    if (t->opened)
        TRY(output_close(&t->out));
    return status;
}
