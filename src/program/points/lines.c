/* The rows of a shard, and kinds of lines in tables and certificates (src/program/cli/formats.md,
 * proofs/certificate.md). SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "program/points/points.h"

#include <ctype.h>
#include "base/context/scope.h"

const char *result_name(result_kind kind) {
    return kind == RESULT_TABLE ? "table" : "certificate";
}

const char *result_mark(result_kind kind) {
    return kind == RESULT_TABLE ? "# " : "";
}

line_part line_part_of(result_kind kind, field line) {
    field rest;
    if (kind == RESULT_TABLE)
        return line.length && *line.start == '#' ? LINE_NOTE : LINE_ROW;
    if (field_behind(&rest, line, "row "))
        return LINE_ROW;
    if (field_behind(&rest, line, "contact "))
        return LINE_OF_ROW;
    return line.length && *line.start >= 'a' && *line.start <= 'z' ? LINE_NOTE : LINE_OF_ROW;
}

int line_ends_head(result_kind kind, field line) {
    field rest;
    if (kind == RESULT_TABLE)
        return !line.length || *line.start != '#';
    return field_behind(&rest, line, "signs ");
}

int line_note(field *value, result_kind kind, field line, const char *key) {
    field note;
    return field_behind(&note, line, result_mark(kind)) && field_behind(value, note, key);
}

static const char undecided_key[] = "undecided ", rows_key[] = "rows-of-all-shards ",
                  points_key[] = "points-checksum ";

void last_lines_begin(text *out, result_kind kind, const last_lines *l) {
    const char *mark = result_mark(kind);
    if (l->counts_undecided)
        text_format(out, "%s%s%lu\n", mark, undecided_key, l->undecided);
    if (l->of_shard)
        text_format(out, "%s%s%lu\n%s%s%016llx\n", mark, rows_key, l->rows_of_all, mark, points_key,
                    l->points);
}

void last_lines_end(text *out, result_kind kind, const last_lines *l) {
    const char *mark = result_mark(kind);
    if (l->of_shard)
        text_format(out, "%s" SHARD_BYTES "%016llx\n", mark, l->bytes);
    text_format(out, "%s" COMPLETE_LINE "%lu\n", mark, l->rows);
}

static unsigned long long number_behind(const char *at, const char *key, int base) {
    const char *number = strstr(at, key);
    return number ? strtoull(number + strlen(key), NULL, base) : 0;
}

/* Are the lines at `at` last lines? They are if the same bytes would be written for their numbers.
 * -1: out of memory. */
static int are_these(last_lines *out, result_kind kind, const char *at, field first) {
    field value;
    HELD(text, same);
    *out = (last_lines){line_note(&value, kind, first, undecided_key),
                        1,
                        (unsigned long)number_behind(at, undecided_key, 10),
                        (unsigned long)number_behind(at, rows_key, 10),
                        (unsigned long)number_behind(at, COMPLETE_LINE, 10),
                        number_behind(at, points_key, 16),
                        number_behind(at, SHARD_BYTES, 16)};
    last_lines_begin(&same, kind, out);
    last_lines_end(&same, kind, out);
    return same.failed ? -1 : strcmp(at, same.data) == 0;
}

int last_lines_read(last_lines *out, result_kind kind, const char *tail) {
    field rest = {tail, strlen(tail)};
    int found = 0;
    while (rest.length && !found) {
        const char *at = rest.start;
        found = are_these(out, kind, at, field_line(&rest));
    }
    return found;
}

/* A number from 1 to SHARDS_MOST and the byte after it; NULL if there is none. */
static const char *read_shard_number(unsigned long *out, const char *text) {
    char *end;
    if (!isdigit((unsigned char)*text))
        return NULL;
    *out = strtoul(text, &end, 10);
    return *out >= 1 && *out <= SHARDS_MOST ? end : NULL;
}

int shard_read(shard *out, const char *text) {
    const char *at = read_shard_number(&out->index, text);
    if (!at || *at != '/')
        return 0;
    at = read_shard_number(&out->count, at + 1);
    if (!at || *at || out->index > out->count)
        return 0;
    out->index--;
    return 1;
}

unsigned long shard_place(shard s, unsigned long row) {
    return row * s.count + s.index;
}

unsigned long shard_rows(shard s, unsigned long rows) {
    return rows / s.count + (rows % s.count > s.index);
}
