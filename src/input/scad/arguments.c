/* Reads arguments: numbers and nested lists of them.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <ctype.h>
#include <string.h>
#include "base/context/scope.h"
#include "base/number/rational.h"
#include "input/scad/arguments.h"

static scad_span trimmed(scad_span s) {
    for (; s.length > 0 && isspace((unsigned char)*s.at); s.length--)
        s.at++;
    while (s.length > 0 && isspace((unsigned char)s.at[s.length - 1]))
        s.length--;
    return s;
}

static int span_is(scad_span s, const char *word) {
    return s.length == strlen(word) && memcmp(s.at, word, s.length) == 0;
}

int scad_item(scad_span *item, scad_span *rest) {
    size_t end = 0, deep = 0;
    int quoted = 0;
    if (trimmed(*rest).length == 0)
        return 0;
    for (; end < rest->length && (quoted || deep > 0 || rest->at[end] != ','); end++) {
        char c = rest->at[end];
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
    *item = trimmed((scad_span){rest->at, end});
    end += end < rest->length;
    *rest = (scad_span){rest->at + end, rest->length - end};
    return 1;
}

/* The name before `=`, empty without one; the item becomes the value. */
static scad_span split_name(scad_span *item) {
    size_t n = 0;
    while (n < item->length &&
           (isalnum((unsigned char)item->at[n]) || item->at[n] == '_' || item->at[n] == '$'))
        n++;
    scad_span name = {item->at, n}, rest = trimmed((scad_span){item->at + n, item->length - n});
    if (rest.length == 0 || *rest.at != '=')
        return (scad_span){item->at, 0};
    *item = trimmed((scad_span){rest.at + 1, rest.length - 1});
    return name;
}

int scad_value(scad_span *out, const scad_place *p, const char *name) {
    scad_span rest = p->file->node[p->node].arguments;
    while (scad_item(out, &rest))
        if (span_is(split_name(out), name ? name : ""))
            return !span_is(*out, "undef");
    return 0;
}

graze_status scad_known(const scad_place *p, const char *names) {
    scad_span rest = p->file->node[p->node].arguments, item;
    while (scad_item(&item, &rest)) {
        scad_span name = split_name(&item);
        const char *at = names;
        int known = name.length == 0 || *name.at == '$';
        for (; *at && !known; at += strcspn(at, " "), at += *at == ' ')
            known = span_is(name, "") ||
                    (strcspn(at, " ") == name.length && memcmp(at, name.at, name.length) == 0);
        if (!known)
            return scad_fail(p->file, p->context, GRAZE_EINPUT, p->node,
                             "an unknown argument, %.*s; expected some of %s",
                             name.length < 40 ? (int)name.length : 40, name.at, names);
    }
    return GRAZE_OK;
}

graze_status scad_list(scad_span *out, const scad_place *p, scad_span value) {
    if (value.length < 2 || *value.at != '[' || value.at[value.length - 1] != ']')
        return scad_fail(p->file, p->context, GRAZE_EINPUT, p->node,
                         "expected a list in brackets, not '%.*s'",
                         value.length < 40 ? (int)value.length : 40, value.at);
    *out = (scad_span){value.at + 1, value.length - 2};
    return GRAZE_OK;
}

graze_status scad_number(fmpq_t out, const scad_place *p, scad_span value) {
    graze_status status = rational_parse(out, p->context, value.at, value.length);
    return status ? context_in(p->context, status, p->file->source, p->file->node[p->node].line)
                  : GRAZE_OK;
}

graze_status scad_vector(fmpq *out, const scad_place *p, scad_span value, size_t count) {
    scad_span rest, item;
    size_t k = 0;
    TRY(scad_list(&rest, p, value));
    for (; scad_item(&item, &rest); k++)
        if (k < count)
            TRY(scad_number(out + k, p, item));
    if (k != count)
        return scad_fail(p->file, p->context, GRAZE_EINPUT, p->node,
                         "expected a list of %zu numbers, not %zu", count, k);
    return GRAZE_OK;
}

/* The value of an argument that must be given. */
static graze_status named_value(scad_span *out, const scad_place *p, const char *name) {
    return scad_value(out, p, name) ? GRAZE_OK
                                    : scad_fail(p->file, p->context, GRAZE_EINPUT, p->node,
                                                "expected the argument %s", name);
}

graze_status scad_named_vector(fmpq *out, const scad_place *p, const char *name, size_t count) {
    scad_span value;
    TRY(named_value(&value, p, name));
    return scad_vector(out, p, value, count);
}

graze_status scad_named_list(scad_span *out, const scad_place *p, const char *name) {
    scad_span value;
    TRY(named_value(&value, p, name));
    return scad_list(out, p, value);
}

graze_status scad_named_number(fmpq_t out, const scad_place *p, const char *name) {
    scad_span value;
    TRY(named_value(&value, p, name));
    return scad_number(out, p, value);
}

graze_status scad_index(size_t *out, const scad_place *p, scad_span value, size_t count) {
    fmpq_t number;
    fmpq_init(number);
    graze_status status = scad_number(number, p, value);
    int good = fmpz_is_one(fmpq_denref(number)) && fmpq_sgn(number) >= 0 &&
               fmpz_cmp_ui(fmpq_numref(number), count) < 0;
    *out = good ? fmpz_get_ui(fmpq_numref(number)) : 0;
    fmpq_clear(number);
    return status || good ? status
                          : scad_fail(p->file, p->context, GRAZE_EINPUT, p->node,
                                      "%.*s is no point; expected a number below %zu",
                                      value.length < 40 ? (int)value.length : 40, value.at, count);
}

int scad_flag(const scad_place *p, const char *name) {
    scad_span value;
    return scad_value(&value, p, name) && span_is(value, "true");
}
