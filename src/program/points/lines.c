/* Kinds of lines in tables and certificates (src/program/cli/formats.md, proofs/certificate.md).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "program/points/points.h"

#include "input/delimited/delimited.h"

const char *result_name(result_kind kind) {
    return kind == RESULT_TABLE ? "table" : "certificate";
}

const char *result_command(result_kind kind) {
    return kind == RESULT_TABLE ? "graze classify" : "graze certify";
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
