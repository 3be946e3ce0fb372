/* Reads arguments: numbers and nested lists of them.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include "base/context/scope.h"
#include "base/number/rational.h"
#include "input/scad/arguments.h"

graze_status scad_fail(const scad_place *p, graze_status status, const char *format, ...) {
    const scad_node *n = &p->file->node[p->node];
    char said[CONTEXT_MESSAGE_SIZE];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(said, sizeof said, format, arguments);
    va_end(arguments);
    return context_fail_in(p->context, status, p->file->source, n->line, "%.*s: %s",
                           FIELD_SHOWN(n->name), said);
}

static field trimmed(field s) {
    for (; s.length > 0 && isspace((unsigned char)*s.start); s.length--)
        s.start++;
    while (s.length > 0 && isspace((unsigned char)s.start[s.length - 1]))
        s.length--;
    return s;
}

int scad_item(field *item, field *rest) {
    size_t end = 0, deep = 0;
    int quoted = 0;
    if (trimmed(*rest).length == 0)
        return 0;
    for (; end < rest->length && (quoted || deep > 0 || rest->start[end] != ','); end++) {
        char c = rest->start[end];
        if (quoted && c == '\\')
            end++;
        else if (c == '"')
            quoted = !quoted;
        else if (!quoted && c == '[')
            deep++;
        else if (!quoted && c == ']' && deep > 0)
            deep--;
    }
    end = end < rest->length ? end : rest->length;
    *item = trimmed((field){rest->start, end});
    end += end < rest->length;
    *rest = (field){rest->start + end, rest->length - end};
    return 1;
}

/* The name before `=`, empty without one; the item becomes the value. */
static field split_name(field *item) {
    size_t n = 0;
    while (n < item->length && (isalnum((unsigned char)item->start[n]) || item->start[n] == '_' ||
                                item->start[n] == '$'))
        n++;
    field name = {item->start, n}, rest = trimmed((field){item->start + n, item->length - n});
    if (rest.length == 0 || *rest.start != '=')
        return (field){item->start, 0};
    *item = trimmed((field){rest.start + 1, rest.length - 1});
    return name;
}

int scad_value(field *out, const scad_place *p, const char *name) {
    field rest = p->file->node[p->node].arguments;
    while (scad_item(out, &rest))
        if (field_is(split_name(out), name ? name : ""))
            return !field_is(*out, "undef");
    return 0;
}

graze_status scad_known(const scad_place *p, const char *names) {
    field rest = p->file->node[p->node].arguments, item;
    while (scad_item(&item, &rest)) {
        field name = split_name(&item);
        const char *at = names;
        int known = name.length == 0 || *name.start == '$';
        for (; *at && !known; at += strcspn(at, " "), at += *at == ' ')
            known = strcspn(at, " ") == name.length && !memcmp(at, name.start, name.length);
        if (!known)
            return scad_fail(p, GRAZE_EINPUT, "an unknown argument, %.*s; expected some of %s",
                             FIELD_SHOWN(name), names);
    }
    return GRAZE_OK;
}

graze_status scad_list(field *out, const scad_place *p, field value) {
    if (value.length < 2 || *value.start != '[' || value.start[value.length - 1] != ']')
        return scad_fail(p, GRAZE_EINPUT, "expected a list in brackets, not '%.*s'",
                         FIELD_SHOWN(value));
    *out = (field){value.start + 1, value.length - 2};
    return GRAZE_OK;
}

graze_status scad_number(fmpq_t out, const scad_place *p, field value) {
    graze_status status = rational_parse(out, p->context, value.start, value.length);
    return status ? context_in(p->context, status, p->file->source, p->file->node[p->node].line)
                  : GRAZE_OK;
}

graze_status scad_vector(fmpq *out, const scad_place *p, field value, size_t count) {
    field rest, item;
    size_t k = 0;
    TRY(scad_list(&rest, p, value));
    for (; scad_item(&item, &rest); k++)
        if (k < count)
            TRY(scad_number(out + k, p, item));
    if (k != count)
        return scad_fail(p, GRAZE_EINPUT, "expected a list of %zu numbers, not %zu", count, k);
    return GRAZE_OK;
}

/* The value of an argument that must be given. */
static graze_status named_value(field *out, const scad_place *p, const char *name) {
    return scad_value(out, p, name) ? GRAZE_OK
                                    : scad_fail(p, GRAZE_EINPUT, "expected the argument %s", name);
}

graze_status scad_named_vector(fmpq *out, const scad_place *p, const char *name, size_t count) {
    field value;
    TRY(named_value(&value, p, name));
    return scad_vector(out, p, value, count);
}

graze_status scad_named_list(field *out, const scad_place *p, const char *name) {
    field value;
    TRY(named_value(&value, p, name));
    return scad_list(out, p, value);
}

graze_status scad_named_number(fmpq_t out, const scad_place *p, const char *name) {
    field value;
    TRY(named_value(&value, p, name));
    return scad_number(out, p, value);
}

graze_status scad_index(size_t *out, const scad_place *p, field value, size_t count) {
    LOCAL(fmpq, number);
    TRY(scad_number(number, p, value));
    if (!fmpz_is_one(fmpq_denref(number)) || fmpq_sgn(number) < 0 ||
        fmpz_cmp_ui(fmpq_numref(number), count) >= 0)
        return scad_fail(p, GRAZE_EINPUT, "%.*s is no point; expected a number below %zu",
                         FIELD_SHOWN(value), count);
    *out = fmpz_get_ui(fmpq_numref(number));
    return GRAZE_OK;
}

int scad_flag(const scad_place *p, const char *name) {
    field value;
    return scad_value(&value, p, name) && field_is(value, "true");
}
