/* Reads contact points from CSV (src/cli/formats.md, Contact points).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "run/sites.h"

#include <stdlib.h>
#include <string.h>

static const char *const body_names[] = {"time", "bx", "by", "bz"};
static const char *const world_names[] = {"time", "x", "y", "z"};
/* Columns of the table that a file may have, as when a table is read again. */
static const char *const result_names[] = {"time",
                                           "bx",
                                           "by",
                                           "bz",
                                           "x",
                                           "y",
                                           "z",
                                           "cell",
                                           "role",
                                           "theta",
                                           "contact_order",
                                           "orientation",
                                           "left",
                                           "right",
                                           "trimmed",
                                           "status",
                                           "near",
                                           "near_in",
                                           "word"};
enum { RESULT_NAMES = sizeof result_names / sizeof *result_names };

static int is_result(field name) {
    for (size_t k = 0; k < RESULT_NAMES; k++)
        if (field_is(name, result_names[k]))
            return 1;
    return 0;
}

/* The columns of d + 1 names; 0 if one is missing, -1 if one stands twice. */
static int find_names(sites *s, const char *const *names) {
    for (int k = 0; k <= s->dimension; k++) {
        size_t found = 0;
        for (size_t c = 0; c < s->cut.count; c++)
            if (field_is(field_content(s->cut.item[c]), names[k])) {
                s->where[k] = c;
                found++;
            }
        if (found != 1)
            return found ? -1 : 0;
    }
    return 1;
}

static int complain_of_names(const sites *s, const char *what) {
    return complain(EXIT_INPUT, "%s:%lu: %s; expected a line of names with %s", s->in.name,
                    s->in.line, what,
                    s->dimension == 2 ? "time,bx,by or time,x,y" : "time,bx,by,bz or time,x,y,z");
}

/* The names of the columns that are carried along. */
static int keep_names(sites *s) {
    text names;
    text_init(&names);
    s->count = s->cut.count;
    s->carried = calloc(s->count + 1, 1);
    int some = 0;
    for (size_t c = 0; c < s->count && s->carried; c++) {
        field name = s->cut.item[c];
        s->carried[c] = !is_result(field_content(name));
        if (!s->carried[c])
            continue;
        text_put(&names, some ? "," : "");
        text_bytes(&names, name.start, name.length);
        some = 1;
    }
    s->others = text_take(&names);
    if (!s->carried || !s->others)
        return complain(EXIT_IO, "out of memory");
    if (!some) {
        graze_free(s->others);
        s->others = NULL;
    }
    return EXIT_DONE;
}

/* The next line that is neither blank nor a comment. */
static int next_site_line(int *ended, sites *s) {
    field line;
    graze_status status;
    do {
        status = stream_next(&s->in, &line);
        *ended = !status && !line.start;
    } while (!status && line.start &&
             ((line.length && *line.start == '#') || field_trimmed(line).length == 0));
    if (!status && !*ended)
        status = fields_read(&s->cut, s->context, s->in.name, s->in.line, line, ',');
    return status ? complain_of(status, s->context) : EXIT_DONE;
}

int sites_open(sites *out, graze_context *context, const char *path, int dimension) {
    int ended = 0;
    memset(out, 0, sizeof *out);
    out->context = context;
    out->dimension = dimension;
    int status = complain_of(stream_open(&out->in, context, path), context);
    if (!status)
        status = next_site_line(&ended, out);
    if (status)
        return status;
    if (ended)
        return complain_of_names(out, "the file is empty");
    int found = find_names(out, body_names);
    if (found == 0) {
        found = find_names(out, world_names);
        out->in_world = 1;
    }
    if (found < 1)
        return complain_of_names(out, found ? "a name stands twice" : "a name is missing");
    return keep_names(out);
}

void sites_close(sites *s) {
    stream_close(&s->in);
    fields_clear(&s->cut);
    free(s->carried);
    graze_free(s->others);
}

int sites_next(mpq_t number[4], text *rest, int *ended, sites *s) {
    int status = next_site_line(ended, s);
    if (status || *ended)
        return status;
    if (s->cut.count != s->count)
        return complain(EXIT_INPUT, "%s:%lu: %zu columns; expected %zu, as on the first line",
                        s->in.name, s->in.line, s->cut.count, s->count);
    for (int k = 0; k <= s->dimension; k++) {
        field token = field_content(s->cut.item[s->where[k]]);
        graze_status read = graze_number_parse(number[k], s->context, token.start, token.length);
        if (read)
            return complain(exit_for(read, EXIT_INPUT), "%s:%lu: %s: %s", s->in.name, s->in.line,
                            (s->in_world ? world_names : body_names)[k],
                            graze_context_message(s->context));
    }
    for (size_t c = 0, some = 0; c < s->count; c++) {
        if (!s->carried[c])
            continue;
        text_put(rest, some++ ? "," : "");
        text_bytes(rest, s->cut.item[c].start, s->cut.item[c].length);
    }
    return rest->failed ? complain(EXIT_IO, "out of memory") : EXIT_DONE;
}
