/* Runs through both tables and counts.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/compare/judgement.h"

#include "base/context/scope.h"

/* Both tables and their matching during a comparison. */
typedef struct run {
    graze_context *context;
    table golden, candidate;
    match match;
} run;

static graze_status check_rounding(graze_comparison *c, run *r, const char *path) {
    column columns[COLUMN_OPTIONS];
    size_t count = 0;
    for (column j = COLUMN_X; j < COLUMN_OPTIONS; j++)
        if (c->judged[j] && j != COLUMN_SDF)
            columns[count++] = j;
    if (c->rounding == GRAZE_ROUND_NONE || c->key.by_id)
        return GRAZE_OK;
    return match_rounding(r->context, &r->golden, path, &c->key, columns, count);
}

/* Open both tables and choose columns and a key; without a key rows match by order. */
static graze_status start(graze_comparison *c, run *r, const char *golden, const char *candidate,
                          match_way way) {
    TRY(table_open(&r->golden, r->context, golden));
    TRY(table_open(&r->candidate, r->context, candidate));
    TRY(comparison_choose(c, &r->golden, &r->candidate));
    if (!(c->golden_columns = strdup(r->golden.names)) ||
        !(c->candidate_columns = strdup(r->candidate.names)))
        TRY(comparison_no_memory(r->context));
    c->way = !c->key.count ? MATCH_ORDER : c->contacts ? MATCH_INDEXED : way;
    match_start(&r->match, r->context, &r->golden, &r->candidate, &c->key, c->way, c->contacts);
    for (int g = 0; g < GROUPING_COUNT; g++)
        c->grouped[g] = grouping_is_of(c, &r->golden, (grouping)g);
    return check_rounding(c, r, golden);
}

static void put_shown_answer(text *out, const table *t, const table_row *row, column which) {
    field f = table_field(t, row, which);
    if (t->where[which] < 0)
        return;
    text_format(out, "%s%s=", out->length ? " " : "", column_name(which));
    text_bytes(out, f.start, f.length);
}

/* Is a column shown beside a disagreement of points: an answer, or a word for an option? */
static int is_shown(column c) {
    const column_set *set = c < COLUMN_OPTIONS ? NULL : columns_known(c - COLUMN_OPTIONS).set;
    return (c >= COLUMN_PMC && c <= COLUMN_T) || c == COLUMN_WORD || (set && set->word);
}

/* Append the answers of a row, as `pmc=on i=0`; for a contact point its time and judged columns. */
static void put_answers(text *out, const graze_comparison *c, const table *t, const table_row *row,
                        int candidate) {
    int sdf = candidate && c->options.has == GRAZE_HAS_SDF;
    if (c->contacts)
        put_shown_answer(out, t, row, COLUMN_TIME);
    for (column k = COLUMN_X; k < COLUMN_COUNT; k++)
        if (c->contacts ? k < COLUMN_OPTIONS && c->judged[k] : sdf ? k == COLUMN_SDF : is_shown(k))
            put_shown_answer(out, t, row, k);
    for (int k = 0; k < 2 && c->enclosed && !candidate; k++)
        put_shown_answer(out, t, row, column_of("sdf") + (column)k);
}

/* A row's point (which = 0) or answers (1 golden, 2 candidate), malloc'ed. */
static char *row_text(const graze_comparison *c, const table *t, const table_row *row, int which) {
    text out;
    text_init(&out);
    for (int k = 0; which == 0 && k < t->dimension; k++) {
        field f = table_field(t, row, (column)(COLUMN_X + k));
        text_put(&out, k ? " " : "");
        text_bytes(&out, f.start, f.length);
    }
    if (which)
        put_answers(&out, c, t, row, which == 2);
    return text_take(&out);
}

/* Keep rows that disagree, to be shown. `wrong` is the golden pmc of a wrong row, else -1; `depth`
 * is the size of the row's distance, where that is known. */
static graze_status show(graze_comparison *c, const run *r, const table_row *golden,
                         const table_row *candidate, int wrong, ceiling depth) {
    disagreement *d;
    graze_status status = comparison_keep(&d, c, r->context, wrong);
    if (!d)
        return status;
    d->depth = depth;
    d->row = golden ? c->rows - 1 : c->rows;
    d->golden_line = golden ? golden->line : 0;
    d->candidate_line = candidate ? candidate->line : 0;
    d->point =
        golden ? row_text(c, &r->golden, golden, 0) : row_text(c, &r->candidate, candidate, 0);
    d->golden = golden ? row_text(c, &r->golden, golden, 1) : NULL;
    d->candidate = candidate ? row_text(c, &r->candidate, candidate, 2) : NULL;
    int failed = !d->point || (golden && !d->golden) || (candidate && !d->candidate);
    if (golden && r->golden.where[COLUMN_STRATUM] >= 0) {
        field stratum = table_field(&r->golden, golden, COLUMN_STRATUM);
        failed |= !(d->stratum = strndup(stratum.start, stratum.length));
    }
    if (c->options.transient && golden)
        failed |= !(d->golden_row = table_row_text(golden));
    if (c->options.transient && candidate)
        failed |= !(d->candidate_row = table_row_text(candidate));
    return failed ? comparison_no_memory(r->context) : GRAZE_OK;
}

static graze_status count_groups(graze_comparison *c, const run *r, const table_row *row, char what,
                                 const valuation *value) {
    const value_error *error = value->judged ? &value->error : NULL;
    if (error && !errors_add(&c->values, *error))
        TRY(comparison_no_memory(r->context));
    for (int g = 0; g < GROUPING_COUNT; g++) {
        field name = g == BY_SDF ? (field){value->decade, strlen(value->decade)}
                                 : table_field(&r->golden, row, groupings[g].of);
        if (c->grouped[g] && (name.length || g != BY_DISTANCE))
            TRY(tally_add(&c->tallies[g], r->context, name, what, error));
    }
    return GRAZE_OK;
}

/* Count a golden row: missing, wrong, undecided or agreeing. `right` is its pmc. */
static graze_status count_row(graze_comparison *c, const run *r, const table_row *golden,
                              const table_row *candidate, const judgement *j,
                              const valuation *value, int right) {
    char what = comparison_count(c, j, candidate != NULL);
    ceiling depth = {0, 0};
    TRY(count_groups(c, r, golden, what, value));
    if (what == 'w' && c->enclosed)
        TRY(depth_take(&depth, &c->depth, &r->golden, golden, right));
    return what == 'a' || what == 'u'
               ? GRAZE_OK
               : show(c, r, golden, candidate, what == 'w' ? right : -1, depth);
}

static graze_status count_contacts(graze_comparison *c, run *r, const table_row *golden,
                                   const table_row *candidate) {
    judgement j = {{0}, 0, {0}, 0, 0};
    valuation none = {.certain = 1};
    TRY(sites_judge(j.wrong, c, &r->golden, golden, &r->candidate, candidate));
    for (int k = 0; k < COLUMN_OPTIONS; k++)
        j.any_wrong |= j.wrong[k];
    return count_row(c, r, golden, candidate, &j, &none, PMC_ON);
}

/* Count a golden row of a curved solid with no decided answer in the columns that the candidate
 * has. The candidate's row may be `undecided` too. */
static graze_status count_open(graze_comparison *c, run *r, const table_row *golden,
                               const table_row *candidate) {
    static const char *const none = "undecided";
    const int known[COLUMN_OPTIONS] = {[COLUMN_PMC] = c->judged[COLUMN_PMC]};
    answer given = {-1, -1, 0, 0, {"", 0}};
    judgement j = {.undecided = 1};
    valuation value = {.certain = 1};
    if (candidate && !field_is(table_field(&r->candidate, candidate, COLUMN_PMC), none))
        TRY(answer_read(&given, &r->candidate, candidate, known, c->options.has == GRAZE_HAS_SDF));
    if (given.pmc >= 0)
        c->undecided_answers[given.pmc]++;
    c->open++;
    c->answered_on += given.pmc == PMC_ON;
    return count_row(c, r, golden, candidate, &j, &value, PMC_ON);
}

static graze_status count_pair(graze_comparison *c, run *r, const table_row *golden,
                               const table_row *candidate, const int *judged) {
    answer right, given = {-1, -1, 0, 0, {"", 0}};
    int known[COLUMN_OPTIONS];
    memcpy(known, judged, sizeof known);
    known[COLUMN_PMC] = 1;
    TRY(answer_read(&right, &r->golden, golden, known, 0));
    if (candidate)
        TRY(answer_read(&given, &r->candidate, candidate, judged, c->options.has == GRAZE_HAS_SDF));
    TRY(judged_position(c, &r->golden, golden, right.pmc));
    valuation value = {.certain = 1};
    if (c->enclosed)
        TRY(valuation_read(&value, c, &r->golden, golden, &r->candidate, candidate, right.pmc));
    judgement j = judge(c, judged, &r->golden, golden, &right, &given, &value);
    c->golden_on += candidate && j.truth == PMC_ON;
    c->answered_on += given.pmc == PMC_ON;
    c->undecided_by_motion += !value.certain;
    if (j.undecided && candidate)
        c->undecided_answers[given.pmc]++;
    else if (judged[COLUMN_PMC])
        c->confusion.pmc[j.truth][candidate ? given.pmc : 3]++;
    if (judged[COLUMN_CLASS])
        c->confusion.class_[right.class_][candidate ? given.class_ : 5]++;
    return count_row(c, r, golden, candidate, &j, &value, right.pmc);
}

/* Count a golden row of points. For a curved solid class, i, t and word are undecided together. */
static graze_status count_answers(graze_comparison *c, run *r, const table_row *golden,
                                  const table_row *candidate) {
    static const char *const none = "undecided";
    field word = table_field(&r->golden, golden, COLUMN_WORD);
    int judged[COLUMN_OPTIONS], pmc = field_is(table_field(&r->golden, golden, COLUMN_PMC), none);
    memcpy(judged, c->judged, sizeof judged);
    if (pmc || field_is(table_field(&r->golden, golden, COLUMN_CLASS), none) ||
        memchr(word.start, '?', word.length))
        judged[COLUMN_CLASS] = judged[COLUMN_I] = judged[COLUMN_T] = judged[COLUMN_WORD] = 0;
    int fewer = memcmp(judged, c->judged, sizeof judged) != 0;
    if (pmc || (fewer && !judged[COLUMN_PMC]))
        return count_open(c, r, golden, candidate);
    c->of_pmc += (unsigned long)fewer;
    return count_pair(c, r, golden, candidate, judged);
}

static graze_status count_all(graze_comparison *c, run *r) {
    for (unsigned long n = 0;; n++) {
        const table_row *golden, *candidate;
        TRY(match_next(&r->match, &golden, &candidate));
        TRY(n % 1024 ? GRAZE_OK : context_poll(r->context));
        if (!golden && !candidate)
            return GRAZE_OK;
        if (golden) {
            TRY((c->contacts ? count_contacts : count_answers)(c, r, golden, candidate));
        } else {
            c->extra++;
            TRY(show(c, r, NULL, candidate, -1, (ceiling){0, 0}));
        }
    }
}

/* Check a run through both tables at its end, and find the way of matching that may match more
 * rows.
 */
static graze_status finish_comparison(graze_comparison *c, const run *r, match_way *better) {
    if (!r->golden.complete)
        return table_fail(&r->golden, 0,
                          "ends after %lu rows without `# complete`; expected a whole table",
                          r->golden.rows);
    *better = match_better(&r->match);
    c->drifted = r->match.drift.rows;
    c->drift = ceiling_of(r->match.drift.farthest);
    return *better == c->way ? match_finish(&r->match) : GRAZE_OK;
}

/* Compare the tables with their rows matched in one way. */
static graze_status compare_by(graze_comparison *out, graze_context *context, const char *golden,
                               const char *candidate, const graze_compare_options *options,
                               match_way *way) {
    if (!comparison_begin(out, context, golden, candidate, options))
        return comparison_no_memory(context);
    run *r = calloc(1, sizeof *r);
    if (!r)
        return comparison_no_memory(context);
    r->context = context;
    graze_status status = start(out, r, golden, candidate, *way);
    if (!status)
        status = count_all(out, r);
    if (!status)
        status = finish_comparison(out, r, way);
    for (int g = 0; g < GROUPING_COUNT; g++)
        tally_sort(&out->tallies[g]);
    match_clear(&r->match);
    table_clear(&r->golden);
    table_clear(&r->candidate);
    free(r);
    return status;
}

graze_status comparison_make(graze_comparison *out, graze_context *context, const char *golden,
                             const char *candidate, const graze_compare_options *options) {
    match_way way = MATCH_STREAMED;
    TRY(compare_by(out, context, golden, candidate, options, &way));
    while (way != out->way) {
        comparison_clear(out);
        memset(out, 0, sizeof *out);
        TRY(compare_by(out, context, golden, candidate, options, &way));
    }
    return comparison_finish(out, context);
}
