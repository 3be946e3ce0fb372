/* Writes a table or a certificate, and continues one.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "program/run/results.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/context/array.h"
#include "program/run/enclosed.h"
#include "program/run/row.h"
#include "program/run/shard.h"
#include "program/run/status.h"

static int no_memory(void) {
    return complain(EXIT_IO, "out of memory");
}

void results_count(results *t, const char *text, size_t length) {
    while ((t->counts_undecided || t->tolerance > 0) && length) {
        const char *newline = memchr(text, '\n', length);
        size_t row = newline ? (size_t)(newline - text) : length, line = row + (newline != NULL);
        t->undecided += t->counts_undecided && row_is_undecided((field){text, row});
        t->wide += t->tolerance > 0 && enclosed_is_wide((field){text, row}, t->tolerance,
                                                        t->counts_undecided + t->certain);
        text += line;
        length -= line;
    }
}

/* Add a line to the head. */
static int keep_head(results *t, field line) {
    stream_copy_line(&t->head, &t->in, line);
    if (t->head.failed)
        return no_memory();
    t->head_lines++;
    t->head_whole = t->in.whole && line_ends_head(t->kind, line);
    return EXIT_DONE;
}

/* Add a line, with a newline, to the row that is kept. */
static int keep_line(results *t, field line) {
    size_t length = t->last_length + line.length + 1;
    if (!array_reserve(&t->last, &t->last_room, length, 1))
        return no_memory();
    memcpy(t->last + t->last_length, line.start, line.length);
    t->last[length - 1] = '\n';
    t->last_length = length;
    return EXIT_DONE;
}

/* Keep a row's first line in place of the row before it. */
static int keep_row(results *t, field line, long long start) {
    t->last_length = 0;
    t->last_start = start;
    t->rows++;
    return keep_line(t, line);
}

/* One line of the file, at byte `start`. */
static int take_kept_line(results *t, field line, long long start, int *complete) {
    field value;
    if (!t->head_whole)
        return keep_head(t, line);
    if (!t->in.whole)
        return EXIT_DONE;
    switch (line_part_of(t->kind, line)) {
    case LINE_ROW:
        return keep_row(t, line, start);
    case LINE_OF_ROW:
        return t->last ? keep_line(t, line) : EXIT_DONE;
    case LINE_NOTE:
        break;
    }
    *complete |= line_note(&value, t->kind, line, COMPLETE_LINE);
    return EXIT_DONE;
}

/* Find out how far the file has come, at most to the end of row `most`, and go back to its first
 * row. */
static int scan(results *t, unsigned long most) {
    int status = EXIT_DONE, complete = 0;
    for (;;) {
        long long start = stream_tell(&t->in);
        field line;
        status = complain_of(stream_next(&t->in, &line), t->in.context);
        if (status || !line.start)
            break;
        if (t->head_whole && t->rows == most && line_part_of(t->kind, line) == LINE_ROW)
            break;
        status = take_kept_line(t, line, start, &complete);
        if (status)
            break;
    }
    if (!status && complete && !t->beside)
        status =
            complain(EXIT_INPUT, "%s: is complete with its %lu rows; expected an interrupted %s",
                     t->resumed, t->rows, result_name(t->kind));
    if (status)
        return status;
    t->in.line = t->head_lines;
    return complain_of(stream_seek(&t->in, (long long)t->head.length), t->in.context);
}

/* The file is locked before it is looked at. Closing any descriptor of it would end the lock. */
static int open_resumed(results *t, graze_context *context) {
    int status = complain_of(stream_open_own(&t->in, context, t->resumed, 0), context);
    if (!status)
        status = output_lock(&t->out);
    return status ? status : scan(t, ULONG_MAX);
}

int results_shorten(results *t, unsigned long rows) {
    if (t->rows < rows)
        return complain(EXIT_INPUT, "%s: has %lu rows; expected the %lu of the table beside it",
                        t->resumed, t->rows, rows);
    if (t->rows == rows)
        return EXIT_DONE;
    t->rows = 0;
    t->last_length = 0;
    if (rows)
        return scan(t, rows);
    free(t->last);
    t->last = NULL;
    t->last_room = 0;
    return EXIT_DONE;
}

int results_open(results *t, graze_context *context, const char *path, const char *resumed) {
    t->resumed = resumed;
    int status = resumed ? output_continue(&t->out, resumed) : output_open(&t->out, path);
    t->opened = !status;
    return status || !resumed ? status : open_resumed(t, context);
}

unsigned long results_skip(const results *t) {
    return t->last ? t->rows - 1 : 0;
}

int results_next(results *t, field *line) {
    int status = complain_of(stream_next(&t->in, line), t->in.context);
    if (status)
        return status;
    if (!line->start)
        return complain(EXIT_IO, "%s: another program has changed it", t->resumed);
    if (line_part_of(t->kind, *line) == LINE_NOTE)
        return results_refuse(t, *line, "a row", (field){"", 0});
    results_count(t, line->start, line->length);
    return EXIT_DONE;
}

int results_refuse(const results *t, field there, const char *expected, field here) {
    return complain(EXIT_INPUT,
                    "%s:%lu: `%.*s` stands there; expected %s%.*s, as in a %s of these points "
                    "that was not changed",
                    t->resumed, t->in.line, there.length < 200 ? (int)there.length : 200,
                    there.start, expected, here.length < 200 ? (int)here.length : 200, here.start,
                    result_name(t->kind));
}

/* Name the line at which the head there and this run's differ. */
static int complain_of_head(const results *t, const char *here) {
    const char *there = t->head.data;
    size_t left = t->head.length;
    unsigned long number = 1;
    for (;; number++) {
        size_t n = strcspn(here, "\n"), m = 0;
        while (m < left && there[m] != '\n')
            m++;
        if (n != m || memcmp(here, there, n) != 0 || !here[n])
            return complain(
                EXIT_INPUT,
                "%s:%lu: `%.*s` stands in the file and `%.*s` is this run's: expected a "
                "%s of this run",
                t->resumed, number, (int)(m < 200 ? m : 200), there, (int)(n < 200 ? n : 200), here,
                result_name(t->kind));
        here += n + 1;
        m += m < left;
        there += m;
        left -= m;
    }
}

int results_begin(results *t, const char *head) {
    size_t length = strlen(head);
    if (t->resumed) {
        size_t there = t->head.length;
        int same = t->head_whole ? there == length : there < length;
        if (!same || (there && memcmp(t->head.data, head, there) != 0))
            return complain_of_head(t, head);
        if (t->last)
            return EXIT_DONE;
        output_from(&t->out, t->head_whole ? (long long)length : 0);
        if (t->head_whole)
            return EXIT_DONE;
    }
    output_bytes(&t->out, head, length);
    return EXIT_DONE;
}

int results_add(results *t, const char *text, size_t length, unsigned long rows) {
    if (t->last && rows && stream_tell(&t->in) != t->last_start) {
        field line;
        int status = results_next(t, &line);
        return status ? status : results_refuse(t, line, "the last row", (field){"", 0});
    }
    if (t->last && rows) {
        if (length < t->last_length || memcmp(text, t->last, t->last_length) != 0)
            return complain(
                EXIT_INPUT,
                "%s: its last row, %lu, is not what this run makes of its point; expected "
                "the points the %s was begun with",
                t->resumed, t->rows, result_name(t->kind));
        output_from(&t->out, t->last_start);
        free(t->last);
        t->last = NULL;
        t->rows--;
    }
    output_bytes(&t->out, text, length);
    results_count(t, text, length);
    t->rows += rows;
    return EXIT_DONE;
}

int results_end(results *t) {
    if (!t->last)
        return EXIT_DONE;
    return complain(EXIT_INPUT,
                    "%s: has %lu rows already, more than there are points; expected the points "
                    "the %s was begun with",
                    t->resumed, t->rows, result_name(t->kind));
}

int results_close(results *t, int status) {
    if (t->opened) {
        int closed = output_close(&t->out);
        status = closed ? closed : status;
    }
    if (t->resumed)
        stream_close(&t->in);
    text_clear(&t->head);
    free(t->last);
    return status;
}
