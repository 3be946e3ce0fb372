/* Writes a table, and continues one.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "run/results.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "run/status.h"

static int keep_head(results *t, const char *line, size_t length) {
    char *grown = realloc(t->head, t->head_length + length + 1);
    if (!grown)
        return complain(EXIT_IO, "out of memory");
    memcpy(grown + t->head_length, line, length);
    t->head = grown;
    t->head_length += length;
    t->head[t->head_length] = '\0';
    t->line_number++;
    t->next_start += (long long)length;
    t->head_whole = *line != '#' && line[length - 1] == '\n';
    return EXIT_DONE;
}

/* One line of the file, at byte `start`; a row changes places with the last one. */
static int take_line(results *t, char **line, size_t length, long long start, int *complete) {
    int whole = (*line)[length - 1] == '\n';
    if (!t->head_whole)
        return keep_head(t, *line, length);
    if (whole && **line == '#') {
        *complete |= strncmp(*line, "# complete ", 11) == 0;
    } else if (whole) {
        char *spare = t->last;
        t->last = *line;
        t->last_length = length;
        t->last_start = start;
        t->rows++;
        *line = spare;
    }
    return EXIT_DONE;
}

static int complain_of_reading(const results *t) {
    return complain(EXIT_IO, "%s: reading failed: %s", t->resumed, strerror(errno));
}

/* Find out how far the file has come. */
static int scan(results *t) {
    char *line = NULL;
    long long start = 0;
    int status = EXIT_DONE, complete = 0;
    for (;;) {
        size_t room = 0; /* getline takes a buffer of its own for each row that is kept */
        free(line);
        line = NULL;
        ssize_t length = getline(&line, &room, t->file);
        if (length <= 0 || status)
            break;
        status = take_line(t, &line, (size_t)length, start, &complete);
        start += length;
    }
    if (!status && !feof(t->file)) /* also where getline had no memory */
        status = complain_of_reading(t);
    if (!status && complete)
        status =
            complain(EXIT_INPUT, "%s: is complete with its %lu rows; expected an interrupted table",
                     t->resumed, t->rows);
    free(line);
    if (!status && fseeko(t->file, (off_t)t->next_start, SEEK_SET) != 0)
        status = complain_of_reading(t);
    return status;
}

/* The file is locked before it is looked at. Closing any descriptor of it would end the lock. */
static int open_resumed(results *t) {
    t->file = fopen(t->resumed, "r");
    if (!t->file)
        return complain(EXIT_IO, "%s: cannot be opened: %s", t->resumed, strerror(errno));
    int status = output_lock(&t->out);
    return status ? status : scan(t);
}

int results_open(results *t, const char *path, const char *resumed) {
    t->resumed = resumed;
    int status = resumed ? output_continue(&t->out, resumed) : output_open(&t->out, path);
    t->opened = !status;
    return status || !resumed ? status : open_resumed(t);
}

unsigned long results_skip(const results *t) {
    return t->last ? t->rows - 1 : 0;
}

int results_next(results *t, field *row) {
    ssize_t length = getline(&t->line, &t->line_room, t->file);
    if (length <= 0)
        return complain_of_reading(t);
    t->line_number++;
    t->next_start += length;
    *row = (field){t->line, (size_t)length - (t->line[length - 1] == '\n')};
    return *t->line == '#' ? results_refuse(t, *row, "a row", (field){"", 0}) : EXIT_DONE;
}

int results_refuse(const results *t, field there, const char *expected, field here) {
    return complain(EXIT_INPUT,
                    "%s:%lu: `%.*s` stands there; expected %s%.*s, as in a table of these points "
                    "that was not changed",
                    t->resumed, t->line_number, there.length < 200 ? (int)there.length : 200,
                    there.start, expected, here.length < 200 ? (int)here.length : 200, here.start);
}

/* Name the line at which the head there and this run's differ. */
static int complain_of_head(const results *t, const char *here) {
    const char *there = t->head;
    size_t left = t->head_length;
    unsigned long number = 1;
    for (;; number++) {
        size_t n = strcspn(here, "\n"), m = 0;
        while (m < left && there[m] != '\n')
            m++;
        if (n != m || memcmp(here, there, n) != 0 || !here[n])
            return complain(
                EXIT_INPUT,
                "%s:%lu: `%.*s` stands in the file and `%.*s` is this run's: expected a "
                "table of this run",
                t->resumed, number, (int)(m < 200 ? m : 200), there, (int)(n < 200 ? n : 200),
                here);
        here += n + 1;
        m += m < left;
        there += m;
        left -= m;
    }
}

int results_begin(results *t, const char *head) {
    size_t length = strlen(head);
    if (t->resumed) {
        size_t there = t->head_length;
        int same = t->head_whole ? there == length : there < length;
        if (!same || (there && memcmp(t->head, head, there) != 0))
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
    if (t->last && rows && t->next_start != t->last_start) {
        field line;
        int status = results_next(t, &line);
        return status ? status : results_refuse(t, line, "the last row", (field){"", 0});
    }
    if (t->last && rows) {
        if (length < t->last_length || memcmp(text, t->last, t->last_length) != 0)
            return complain(
                EXIT_INPUT,
                "%s: its last row, %lu, is not what this run makes of its point; expected "
                "the points the table was begun with",
                t->resumed, t->rows);
        output_from(&t->out, t->last_start);
        free(t->last);
        t->last = NULL;
        t->rows--;
    }
    output_bytes(&t->out, text, length);
    t->rows += rows;
    return EXIT_DONE;
}

int results_end(results *t) {
    if (!t->last)
        return EXIT_DONE;
    return complain(EXIT_INPUT,
                    "%s: has %lu rows already, more than there are points; expected the points "
                    "the table was begun with",
                    t->resumed, t->rows);
}

int results_close(results *t, int status) {
    if (t->opened) {
        int closed = output_close(&t->out);
        status = closed ? closed : status;
    }
    if (t->file)
        fclose(t->file);
    free(t->head);
    free(t->last);
    free(t->line);
    return status;
}
