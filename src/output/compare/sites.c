/* Recognises tables of contact points, reads their answers and compares them.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * An answer may be empty where graze contact leaves it so; an empty answer equals an empty one
 * alone. Times and numbers go by their value, everything else by its text.
 */
#include "output/compare/compare.h"

#include <string.h>
#include "base/context/scope.h"
#include "base/number/rational.h"
#include "decide/filter/filter.h"
#include "input/delimited/delimited.h"
#include "output/compare/counts.h"
#include "output/compare/judgement.h"
#include "output/compare/rows.h"

/* Kind of rows that a table has, if its columns tell. */
typedef enum table_kind { KIND_ANY, KIND_POINTS, KIND_CONTACTS } table_kind;

/* Tables of Graze are known by their first column, since further ones may have any name. */
static table_kind table_kind_of(const table *t) {
    if (t->notes[NOTE_GRAZE])
        return t->where[COLUMN_TIME] == 0 ? KIND_CONTACTS : KIND_POINTS;
    int points = t->where[COLUMN_PMC] >= 0 || t->where[COLUMN_SDF] >= 0, contacts = 0;
    for (int c = COLUMN_ROLE; c <= COLUMN_SHIFT; c++)
        contacts |= t->where[c] >= 0;
    if (points == contacts)
        return KIND_ANY;
    return points ? KIND_POINTS : t->where[COLUMN_TIME] >= 0 ? KIND_CONTACTS : KIND_ANY;
}

static graze_status named_once(const table *t) {
    return t->doubled < 0 ? GRAZE_OK : table_named_twice(t, (column)t->doubled);
}

graze_status sites_known(int *contacts, const table *golden, const table *candidate) {
    table_kind right = table_kind_of(golden), given = table_kind_of(candidate);
    *contacts = right == KIND_CONTACTS;
    if (*contacts ? given == KIND_POINTS : given == KIND_CONTACTS)
        return context_fail_in(golden->in.context, GRAZE_EINPUT, candidate->in.name, 0,
                               "has %s, %s has %s; expected two tables of one kind",
                               *contacts ? "answers of graze classify" : "contact points",
                               golden->in.name,
                               *contacts ? "contact points" : "answers of graze classify");
    graze_status status = *contacts ? named_once(golden) : GRAZE_OK;
    return *contacts && !status ? named_once(candidate) : status;
}

static graze_status sites_options(const graze_compare_options *o, const table *golden) {
    const char *asked = o->question       ? "the closed question"
                        : o->on_as        ? "a meaning of `on`"
                        : o->has          ? "a column sdf"
                        : o->motion_error ? "a motion error"
                                          : NULL;
    if (!asked)
        return GRAZE_OK;
    return context_fail_in(golden->in.context, GRAZE_EINPUT, golden->in.name, 0,
                           "has contact points, which %s is not for; expected a table of graze "
                           "classify",
                           asked);
}

graze_status sites_choose(graze_comparison *c, const table *golden, const table *candidate) {
    int any = 0;
    const char *names[JUDGED_COUNT];
    size_t count = 0;
    char meant[TABLE_MEANT];
    for (int k = 0; k < JUDGED_COUNT; k++) {
        if (!judged_of(k, 1))
            continue;
        names[count++] = judged_name(k);
        int right = golden->where[judged_column(k)] >= 0;
        int given = candidate->where[judged_column(k)] >= 0;
        any |= c->judged[k] = right && given;
        c->lacking[k] = right && !given ? 1 : given && !right ? 2 : 0;
    }
    table_meant(meant, candidate, names, count);
    if (!any)
        return context_fail_in(golden->in.context, GRAZE_EINPUT, candidate->in.name, 0,
                               "has no column that can be judged; expected one of cell, role, "
                               "theta, contact_order, orientation, left, right, trimmed, status, "
                               "near, near_in, word, shift that %s has too%s",
                               golden->in.name, meant);
    return sites_options(&c->options, golden);
}

/* Words that a column may have, with blanks around each; NULL: it has other answers. */
static const char *words_of(column c) {
    return c == COLUMN_ROLE          ? " contact egress ingress hidden "
           : c == COLUMN_THETA       ? " + 0 - "
           : c == COLUMN_ORIENTATION ? " preserving reversing degenerate "
           : c == COLUMN_LEFT        ? " I B O "
           : c == COLUMN_RIGHT       ? " I B O "
           : c == COLUMN_TRIMMED     ? " yes no "
           : c == COLUMN_STATUS      ? " slides simple meets trimmed_near trimmed_far "
                                     : NULL;
}

/* Does a field stand among the words? */
static int is_site_word(field f, const char *words) {
    while (*++words) {
        size_t length = strcspn(words, " ");
        if (field_equal(f, (field){words, length}))
            return 1;
        words += length;
    }
    return 0;
}

/* A cell as graze generate spells it. */
static int is_cell(field f) {
    field number, second;
    unsigned long index;
    if (field_behind(&number, f, "face ") || field_behind(&number, f, "vertex "))
        return field_count(&index, number, ~0ul);
    const char *dash =
        field_behind(&number, f, "edge ") ? memchr(number.start, '-', number.length) : NULL;
    if (!dash)
        return 0;
    second = (field){dash + 1, (size_t)(number.start + number.length - dash - 1)};
    number.length = (size_t)(dash - number.start);
    return field_count(&index, number, ~0ul) && field_count(&index, second, ~0ul);
}

/* The expected values, for a message about a field that is no answer; NULL if it is one. */
static const char *site_answer_fault(field f, column c) {
    unsigned long order;
    switch (c) {
    case COLUMN_CELL:
        return is_cell(f) ? NULL : "`face 3`, `edge 1-2` or `vertex 5`";
    case COLUMN_CONTACT_ORDER:
        return field_is(f, "inf") || field_count(&order, f, ~0ul) ? NULL : "a whole number or inf";
    case COLUMN_NEAR:
    case COLUMN_NEAR_IN:
        return moment_is_token(f) ? NULL : "a time such as " MOMENT_FORMS;
    case COLUMN_SHIFT:
        return rational_is_token(f.start, f.length) && *f.start != '-' ? NULL
                                                                       : "a number from 0 up";
    default:
        return is_site_word(f, words_of(c)) ? NULL : words_of(c);
    }
}

/* A number may be one in form alone, or beyond a limit. */
static graze_status check_number(const table *t, const table_row *row, column c) {
    field f = table_field(t, row, c);
    graze_context *context = t->in.context;
    LOCAL(fmpq, value);
    graze_status status = rational_is_token(f.start, f.length)
                              ? rational_parse(value, context, f.start, f.length)
                              : GRAZE_OK;
    if (status)
        context_item(context, status, NULL, 0, column_name(c));
    return status ? context_in(context, status, t->in.name, row->line) : GRAZE_OK;
}

static graze_status check_answer(const table *t, const table_row *row, column c) {
    field f = table_field(t, row, c);
    if (!f.length)
        return GRAZE_OK;
    if (c == COLUMN_WORD)
        return judged_word(t, row);
    const char *expected = site_answer_fault(f, c);
    if (!expected)
        return check_number(t, row, c);
    char text[64] = "one of";
    if (expected == words_of(c)) {
        strncat(text, expected, sizeof text - strlen(text) - 1);
        text[strlen(text) - 1] = '\0'; /* the blank behind the last word */
        expected = text;
    }
    return judged_no_answer(t, row, c, expected);
}

graze_status sites_judge(int *wrong, const graze_comparison *c, const table *golden,
                         const table_row *row, const table *candidate, const table_row *given) {
    memset(wrong, 0, JUDGED_COUNT * sizeof *wrong);
    for (int k = 0; k < JUDGED_COUNT; k++) {
        column which = judged_column(k);
        int same = 1;
        if (!c->judged[k])
            continue;
        TRY(check_answer(golden, row, which));
        if (given)
            TRY(check_answer(candidate, given, which));
        if (given)
            TRY(moment_same(&same, golden->in.context, table_field(golden, row, which),
                            table_field(candidate, given, which)));
        wrong[k] = !same;
    }
    return GRAZE_OK;
}
