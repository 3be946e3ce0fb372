/* Checks that two tables go together, chooses columns and keys, and makes digests of keys.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/compare/judgement.h"

#include "base/context/scope.h"
#include "base/number/rational.h"

/* Ids of more characters are compared as texts, also if they look like numbers. */
enum { LONGEST_NUMBER = 40 };

/* Choose as key the coordinates that both tables have. */
static graze_status key_of_points(row_key *out, const table *golden, const table *candidate) {
    key_of_axes(out, golden, candidate);
    if (candidate->dimension > golden->dimension)
        return table_fail(candidate, 0,
                          "a column z; expected x and y, as the golden table has dimension 2");
    return GRAZE_OK;
}

/* Has a table the columns of time and of a point with this first coordinate? */
static int has_contact(const table *t, column first, size_t dimension) {
    int has = t->where[COLUMN_TIME] >= 0;
    for (size_t k = 0; k < dimension; k++)
        has = has && t->where[first + k] >= 0;
    return has;
}

static graze_status key_of_contacts(row_key *out, const table *golden, const table *candidate) {
    size_t dimension = golden->where[COLUMN_BZ] >= 0 || golden->where[COLUMN_Z] >= 0 ? 3 : 2;
    const char *told = golden->notes[NOTE_DIMENSION];
    if (told && strcmp(told, "2") == 0)
        dimension = 2;
    static const column firsts[] = {COLUMN_BX, COLUMN_X};
    for (int k = 0; k < 2; k++) {
        if (!has_contact(golden, firsts[k], dimension) ||
            !has_contact(candidate, firsts[k], dimension))
            continue;
        *out = (row_key){0, dimension + 1, {COLUMN_TIME}};
        for (size_t axis = 0; axis < dimension; axis++)
            out->at[axis + 1] = (column)(firsts[k] + axis);
        return GRAZE_OK;
    }
    return table_fail(candidate, 0,
                      "no columns %s that %s has too, and no id; expected one of them, to match "
                      "contact points by",
                      dimension == 2 ? "time, bx, by or time, x, y"
                                     : "time, bx, by, bz or time, x, y, z",
                      golden->in.name);
}

/* Choose the key: `id` if both tables have it; else x, y (and z), else no columns. For contact
 * points without id: time and bx, by (and bz), else time and x, y (and z).
 * @return GRAZE_EINPUT a column z for points of the plane; contact points that lack these columns
 */
static graze_status key_choose(row_key *out, const table *golden, const table *candidate,
                               int contacts) {
    *out = (row_key){1, 1, {COLUMN_ID}};
    if (golden->where[COLUMN_ID] >= 0 && candidate->where[COLUMN_ID] >= 0)
        return GRAZE_OK;
    return (contacts ? key_of_contacts : key_of_points)(out, golden, candidate);
}

graze_status key_check(const row_key *key, const table *t, const table_row *row) {
    for (size_t k = 0; k < key->count && !key->by_id; k++) {
        field f = table_field(t, row, key->at[k]);
        int time = key->at[k] == COLUMN_TIME;
        if (time ? !moment_is_token(f) : !rational_is_token(f.start, f.length))
            return table_fail(t, row->line, "%s: '%.*s' is not a %s; expected one such as %s",
                              column_name(key->at[k]), FIELD_SHOWN(f), time ? "time" : "number",
                              time ? MOMENT_FORMS : "-12, 0.1, 1.5e-3, 22/7");
    }
    return GRAZE_OK;
}

/* Append a number of the key in lowest terms after rounding; a root as it is written. */
static graze_status put_key_number(text *out, fmpq_t value, const table *t, const table_row *row,
                                   column which) {
    field f = table_field(t, row, which);
    if (which == COLUMN_TIME && moment_is_root(f)) {
        text_bytes(out, f.start, f.length);
        return GRAZE_OK;
    }
    TRY(table_rational(value, t, row, which));
    text_rational(out, value);
    return GRAZE_OK;
}

/* Is an id a number as programs that read doubles write it: 7, 7.0 or 7.000e+00? The id 7e0 is not
 * taken for one, as it may be the digits of a hash. */
static int is_id_number(field f) {
    int exponent = memchr(f.start, 'e', f.length) || memchr(f.start, 'E', f.length);
    return f.length <= LONGEST_NUMBER && rational_is_token(f.start, f.length) &&
           !memchr(f.start, '/', f.length) && (!exponent || memchr(f.start, '.', f.length));
}

/* Append an id: the value if it is a number, else the text as it is written. */
static void put_id(text *out, const table *t, const table_row *row) {
    field f = table_field(t, row, COLUMN_ID);
    LOCAL(fmpq, value);
    if (is_id_number(f) && table_number(value, t->in.context, f) == GRAZE_OK)
        text_rational(out, value);
    else
        text_bytes(out, f.start, f.length);
}

/* Append the id, or all numbers of the key with blanks between them. */
static graze_status put_key(text *out, const row_key *key, const table *t, const table_row *row) {
    LOCAL(fmpq, value);
    if (key->by_id)
        put_id(out, t, row);
    for (size_t k = 0; k < key->count && !key->by_id; k++) {
        TRY(put_key_number(out, value, t, row, key->at[k]));
        text_put(out, " ");
    }
    return out->failed ? comparison_no_memory(t->in.context) : GRAZE_OK;
}

graze_status key_make(table_row *row, const row_key *key, const table *t) {
    if (row->keyed)
        return GRAZE_OK;
    HELD(text, bytes);
    TRY(put_key(&bytes, key, t, row));
    row->key = digest_of(bytes.data, bytes.length);
    row->keyed = 1;
    return GRAZE_OK;
}

const struct grouped groupings[GROUPING_COUNT] = {
    {COLUMN_STRATUM, "stratum"},
    {COLUMN_K, "k (distance 2^-k)"},
    {COLUMN_SDF, "sdf (the power of ten below its size)"},
    {COLUMN_CLASS, "class"},
    {COLUMN_DEFINITION, "definition"},
    {COLUMN_CASE, "case"},
    {COLUMN_STATUS, "status"},
    {COLUMN_ROLE, "role"}};

static graze_status check_golden(const table *t) {
    static const char *const pmc = "pmc";
    char meant[TABLE_MEANT] = "";
    if (t->where[COLUMN_PMC] >= 0 && t->dimension)
        return GRAZE_OK;
    if (t->where[COLUMN_PMC] < 0)
        table_meant(meant, t, &pmc, 1);
    return table_fail(
        t, 0,
        "has no column %s; expected a table, which graze classify SOLID MOTION POINTS writes%s",
        t->where[COLUMN_PMC] < 0 ? "pmc" : "x or no column y", meant);
}

/* Check that both tables are of one scene and one set of options. */
static graze_status check_notes(const table *golden, const table *candidate) {
    static const note same[] = {NOTE_SOLID,     NOTE_MOTION, NOTE_SCENE,
                                NOTE_OPERATION, NOTE_FOLDS,  NOTE_DIMENSION};
    for (size_t k = 0; k < sizeof same / sizeof *same; k++) {
        const char *g = golden->notes[same[k]], *c = candidate->notes[same[k]];
        if (g && c && strcmp(g, "none") != 0 && strcmp(c, "none") != 0 && strcmp(g, c) != 0)
            return table_fail(candidate, 0,
                              "%s is %.64s, that of %s is %.64s; expected tables of one scene and "
                              "one set of options",
                              note_names[same[k]], c, golden->in.name, g);
    }
    return GRAZE_OK;
}

/* Choose the columns to judge: those of the candidate for which the golden table has answers. */
static graze_status choose_columns(graze_comparison *c, const table *golden,
                                   const table *candidate) {
    static const char *const answers[] = {"sdf", "pmc", "class", "word"};
    int sdf = c->options.has == GRAZE_HAS_SDF, any = 0;
    int open = c->options.question == GRAZE_QUESTION_OPEN && !c->options.motion_error;
    char meant[TABLE_MEANT];
    table_meant(meant, candidate, sdf ? answers : answers + 1, sdf ? 1 : 3);
    if (sdf && candidate->where[COLUMN_SDF] < 0)
        return table_fail(
            candidate, 0,
            "has no column sdf; expected a signed distance in a column of that name%s", meant);
    for (column j = COLUMN_X; j < COLUMN_OPTIONS; j++) {
        if (!judged_of(j, 0))
            continue;
        int answered = candidate->where[j] >= 0;
        c->judged[j] = j == COLUMN_PMC ? answered || sdf : answered && open && !sdf;
        if (c->judged[j] && golden->where[j] < 0)
            return table_fail(golden, 0, "has no column %s; expected one to judge that of %s by",
                              column_name(j), candidate->in.name);
        any |= c->judged[j];
    }
    if (!any)
        return table_fail(candidate, 0, "has no column that can be judged; expected one of %s%s",
                          open ? "pmc, class, i, t, word" : "pmc (or sdf)", meant);
    return values_choose(c, golden);
}

/* Take over from the golden table the options of `graze explain`, or of `graze classify --at-rest`.
 */
static graze_status note_options(graze_comparison *c, graze_context *context, const table *t) {
    text options;
    const char *round = t->notes[NOTE_ROUND], *folds = t->notes[NOTE_FOLDS];
    const char *operation = t->notes[NOTE_OPERATION], *cut = t->notes[NOTE_TRIANGULATE];
    text_init(&options);
    if (round && (strcmp(round, graze_rounding_name(GRAZE_ROUND_BINARY64)) == 0 ||
                  strcmp(round, graze_rounding_name(GRAZE_ROUND_BINARY32)) == 0))
        text_format(&options, " --round %s", round);
    if (folds && strcmp(folds, "combined") == 0)
        text_put(&options, " --folds combined");
    if (operation && strcmp(operation, "unsweep") == 0)
        text_put(&options, " --operation unsweep");
    if (cut && strcmp(cut, "yes") == 0)
        text_put(&options, " --triangulate");
    text_put(&options, t->notes[NOTE_AT_REST] ? " --at-rest" : "");
    return text_finish(&c->explain_options, context, &options);
}

graze_status comparison_choose(graze_comparison *c, const table *golden, const table *candidate) {
    TRY(sites_known(&c->contacts, golden, candidate));
    if (!c->contacts)
        TRY(check_golden(golden));
    TRY(check_notes(golden, candidate));
    TRY((c->contacts ? sites_choose : choose_columns)(c, golden, candidate));
    TRY(key_choose(&c->key, golden, candidate, c->contacts));
    return note_options(c, golden->in.context, golden);
}

int grouping_is_of(const graze_comparison *c, const table *golden, grouping g) {
    if (g == BY_SDF)
        return c->enclosed;
    int of_contacts = g == BY_STATUS || g == BY_ROLE, of_both = g == BY_STRATUM || g == BY_DISTANCE;
    return golden->where[groupings[g].of] >= 0 && (of_both || of_contacts == c->contacts);
}
