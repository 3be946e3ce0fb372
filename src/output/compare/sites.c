/* Recognises tables of contact points, reads their answers and times, and compares them.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * An answer may be empty where graze contact leaves it empty; an empty answer equals only an empty
 * one. Times and numbers are compared by value, all else as text.
 */
#include "output/compare/judgement.h"

#include "base/context/scope.h"
#include "base/number/rational.h"

/* Kind of rows of a table; KIND_ANY if its columns do not tell. */
typedef enum table_kind { KIND_ANY, KIND_POINTS, KIND_CONTACTS } table_kind;

/* The kind of a table. A table of Graze is known by its first column, since further columns may
 * have any name. */
static table_kind table_kind_of(const table *t) {
    if (t->notes[NOTE_GRAZE])
        return t->where[COLUMN_TIME] == 0 ? KIND_CONTACTS : KIND_POINTS;
    int points = t->where[COLUMN_PMC] >= 0 || t->where[COLUMN_SDF] >= 0, contacts = 0;
    for (int c = COLUMN_ROLE; c <= COLUMN_SHIFT; c++)
        contacts |= c != COLUMN_WORD && t->where[c] >= 0;
    if (points == contacts)
        return KIND_ANY;
    return points ? KIND_POINTS : t->where[COLUMN_TIME] >= 0 ? KIND_CONTACTS : KIND_ANY;
}

graze_status sites_known(int *contacts, const table *golden, const table *candidate) {
    table_kind right = table_kind_of(golden), given = table_kind_of(candidate);
    *contacts = right == KIND_CONTACTS;
    if (*contacts ? given == KIND_POINTS : given == KIND_CONTACTS)
        return table_fail(candidate, 0, "has %s, %s has %s; expected two tables of one kind",
                          *contacts ? "answers of graze classify" : "contact points",
                          golden->in.name,
                          *contacts ? "contact points" : "answers of graze classify");
    const table *twice = golden->doubled >= 0 ? golden : candidate->doubled >= 0 ? candidate : NULL;
    return *contacts && twice ? table_named_twice(twice, (column)twice->doubled) : GRAZE_OK;
}

static graze_status sites_options(const graze_compare_options *o, const table *golden) {
    const char *asked = o->question       ? "the closed question"
                        : o->on_as        ? "a meaning of `on`"
                        : o->has          ? "a column sdf"
                        : o->motion_error ? "a motion error"
                                          : NULL;
    if (!asked)
        return GRAZE_OK;
    return table_fail(golden, 0,
                      "has contact points, which %s is not for; expected a table of graze classify",
                      asked);
}

graze_status sites_choose(graze_comparison *c, const table *golden, const table *candidate) {
    int any = 0;
    const char *names[COLUMN_OPTIONS] = {NULL};
    size_t count = 0;
    char meant[TABLE_MEANT];
    for (column j = COLUMN_X; j < COLUMN_OPTIONS; j++) {
        if (!judged_of(j, 1))
            continue;
        names[count++] = column_name(j);
        int right = golden->where[j] >= 0, given = candidate->where[j] >= 0;
        any |= c->judged[j] = right && given;
        c->lacking[j] = right && !given ? 1 : given && !right ? 2 : 0;
    }
    table_meant(meant, candidate, names, count);
    if (!any)
        return table_fail(candidate, 0,
                          "has no column that can be judged; expected one of cell, role, theta, "
                          "contact_order, orientation, left, right, trimmed, status, near, "
                          "near_in, word, shift that %s has too%s",
                          golden->in.name, meant);
    return sites_options(&c->options, golden);
}

/* Words that a column may have, with blanks around each; NULL: it has other answers. */
static const char *const words_of[COLUMN_OPTIONS] = {
    [COLUMN_ROLE] = " contact egress ingress hidden ",
    [COLUMN_THETA] = " + 0 - ",
    [COLUMN_ORIENTATION] = " preserving reversing degenerate ",
    [COLUMN_LEFT] = " I B O ",
    [COLUMN_RIGHT] = " I B O ",
    [COLUMN_TRIMMED] = " yes no ",
    [COLUMN_STATUS] = " slides simple meets trimmed_near trimmed_far "};

/* Is a field one of the words? */
static int is_site_word(field f, const char *words) {
    while (*++words) {
        size_t length = strcspn(words, " ");
        if (field_equal(f, (field){words, length}))
            return 1;
        words += length;
    }
    return 0;
}

/* Is a field a cell as graze generate writes it? */
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

/* The expected values, for a message, if a field is no answer of its column; NULL if it is one. */
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
        return is_site_word(f, words_of[c]) ? NULL : words_of[c];
    }
}

static graze_status check_answer(const table *t, const table_row *row, column c) {
    field f = table_field(t, row, c);
    LOCAL(fmpq, value);
    if (!f.length)
        return GRAZE_OK;
    if (c == COLUMN_WORD)
        return judged_word(t, row);
    const char *expected = site_answer_fault(f, c);
    if (!expected) /* a field of the form of a number may be no number, or beyond a limit */
        return rational_is_token(f.start, f.length) ? table_rational(value, t, row, c) : GRAZE_OK;
    char text[64] = "one of";
    if (expected == words_of[c]) {
        strncat(text, expected, sizeof text - strlen(text) - 1);
        text[strlen(text) - 1] = '\0'; /* the blank behind the last word */
        expected = text;
    }
    return judged_no_answer(t, row, c, expected);
}

/* The bytes of `rest` before the first separator, or all; `rest` becomes the bytes behind it, or
 * starts at NULL. */
static field root_part(field *rest, char separator) {
    const char *end = memchr(rest->start, separator, rest->length);
    field part = *rest;
    if (end)
        part.length = (size_t)(end - rest->start);
    *rest = end ? (field){end + 1, rest->length - part.length - 1} : (field){NULL, 0};
    return part;
}

static int is_whole(field f) {
    return rational_is_token(f.start, f.length) && !memchr(f.start, '.', f.length) &&
           !memchr(f.start, '/', f.length) && !memchr(f.start, 'e', f.length) &&
           !memchr(f.start, 'E', f.length);
}

int moment_is_root(field f) {
    field rest, part[3];
    size_t count = 0;
    if (!field_behind(&rest, f, "root(") || !rest.length || rest.start[rest.length - 1] != ')')
        return 0;
    rest.length--;
    for (int k = 0; k < 3; k++) {
        if (!rest.start)
            return 0;
        part[k] = root_part(&rest, ';');
    }
    if (rest.start || !rational_is_token(part[1].start, part[1].length) ||
        !rational_is_token(part[2].start, part[2].length))
        return 0;
    for (rest = part[0]; rest.start; count++)
        if (!is_whole(root_part(&rest, ' ')))
            return 0;
    return count >= 3;
}

int moment_is_token(field f) {
    return rational_is_token(f.start, f.length) || moment_is_root(f);
}

/* Are two times the same? Numbers are compared by value after rounding. GRAZE_EINPUT, GRAZE_ELIMIT.
 */
static graze_status moment_same(int *same, graze_context *context, field a, field b) {
    *same = field_equal(a, b);
    if (*same || !rational_is_token(a.start, a.length) || !rational_is_token(b.start, b.length))
        return GRAZE_OK;
    LOCAL_VEC(fmpq, x, 2);
    fmpq *y = x + 1;
    TRY(rational_parse(x, context, a.start, a.length));
    TRY(rational_parse(y, context, b.start, b.length));
    *same = fmpq_equal(x, y);
    return GRAZE_OK;
}

graze_status sites_judge(int *wrong, const graze_comparison *c, const table *golden,
                         const table_row *row, const table *candidate, const table_row *given) {
    memset(wrong, 0, COLUMN_OPTIONS * sizeof *wrong);
    for (column j = COLUMN_X; j < COLUMN_OPTIONS; j++) {
        int same = 1;
        if (!c->judged[j])
            continue;
        TRY(check_answer(golden, row, j));
        if (given) {
            TRY(check_answer(candidate, given, j));
            TRY(moment_same(&same, golden->in.context, table_field(golden, row, j),
                            table_field(candidate, given, j)));
        }
        wrong[j] = !same;
    }
    return GRAZE_OK;
}
