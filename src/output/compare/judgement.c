/* Reads answers and judges them under the question asked.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/compare/judgement.h"

#include "base/context/scope.h"
#include "base/number/rational.h"

const char *const pmc_words[3] = {"in", "on", "out"};
const char *const class_words[5] = {"regular", "fold", "fold_boundary", "boundary", "exterior"};

int judged_of(column c, int contacts) {
    return contacts ? c == COLUMN_CELL || (c >= COLUMN_ROLE && c <= COLUMN_SHIFT)
                    : c == COLUMN_PMC || c == COLUMN_CLASS || c == COLUMN_I || c == COLUMN_T ||
                          c == COLUMN_WORD;
}

graze_status judged_no_answer(const table *t, const table_row *row, column c, const char *right) {
    field f = table_field(t, row, c);
    return table_fail(t, row->line, "%s: '%.*s' is no answer; expected %s", column_name(c),
                      FIELD_SHOWN(f), right);
}

static int index_of(field f, const char *const *words, int count) {
    for (int k = 0; k < count; k++)
        if (field_is(f, words[k]))
            return k;
    return -1;
}

static int read_digits(unsigned long *out, field f) {
    char text[24], *end;
    if (!f.length || f.length > 18 || *f.start < '0' || *f.start > '9')
        return 0;
    memcpy(text, f.start, f.length);
    text[f.length] = '\0';
    *out = strtoul(text, &end, 10);
    return !*end;
}

/* Read a count, also as programs that read floats write it: 1.0, 2.000e+00. */
static int read_whole(unsigned long *out, const table *t, field f) {
    if (read_digits(out, f))
        return 1;
    LOCAL(fmpq, value);
    int whole = !table_number(value, t->in.context, f) && fmpz_is_one(fmpq_denref(value)) &&
                fmpz_sgn(fmpq_numref(value)) >= 0 && fmpz_abs_fits_ui(fmpq_numref(value));
    *out = whole ? fmpz_get_ui(fmpq_numref(value)) : 0;
    return whole;
}

/* The sign of a number token, from its digits before an exponent or a denominator. The value is not
 * computed, so it cannot underflow. */
static int answer_sign(field f) {
    size_t n = 0;
    while (n < f.length && !strchr("eE/", f.start[n]))
        n++;
    for (size_t k = 0; k < n; k++)
        if (f.start[k] >= '1' && f.start[k] <= '9')
            return *f.start == '-' ? -1 : 1;
    return 0;
}

static int zero_denominator(field f) {
    const char *slash = memchr(f.start, '/', f.length);
    return slash && answer_sign((field){slash + 1, (size_t)(f.start + f.length - slash - 1)}) == 0;
}

static graze_status read_distance(int *pmc, const table *t, const table_row *row) {
    field f = table_field(t, row, COLUMN_SDF);
    if (!rational_is_token(f.start, f.length) || zero_denominator(f))
        return judged_no_answer(t, row, COLUMN_SDF, "a number, negative inside");
    int sign = answer_sign(f);
    *pmc = sign < 0 ? PMC_IN : sign > 0 ? PMC_OUT : PMC_ON;
    return GRAZE_OK;
}

graze_status judged_word(const table *t, const table_row *row) {
    field word = table_field(t, row, COLUMN_WORD);
    for (size_t k = 0; k < word.length || k == 0; k++)
        if (!word.length || !strchr("IBO", word.start[k]))
            return judged_no_answer(t, row, COLUMN_WORD, "letters I, B, O");
    return GRAZE_OK;
}

graze_status answer_read(answer *out, const table *t, const table_row *row, const int *judged,
                         int sdf) {
    *out = (answer){-1, -1, 0, 0, {"", 0}};
    if (sdf)
        return read_distance(&out->pmc, t, row);
    if (judged[COLUMN_PMC]) {
        out->pmc = index_of(table_field(t, row, COLUMN_PMC), pmc_words, 3);
        if (out->pmc < 0)
            return judged_no_answer(t, row, COLUMN_PMC, "in, on or out");
    }
    if (judged[COLUMN_CLASS]) {
        out->class_ = index_of(table_field(t, row, COLUMN_CLASS), class_words, 5);
        if (out->class_ < 0)
            return judged_no_answer(t, row, COLUMN_CLASS,
                                    "regular, fold, fold_boundary, boundary or exterior");
    }
    if (judged[COLUMN_I] && !read_whole(&out->i, t, table_field(t, row, COLUMN_I)))
        return judged_no_answer(t, row, COLUMN_I, "a whole number");
    if (judged[COLUMN_T] && !read_whole(&out->t, t, table_field(t, row, COLUMN_T)))
        return judged_no_answer(t, row, COLUMN_T, "a whole number");
    out->word = table_field(t, row, COLUMN_WORD);
    return judged[COLUMN_WORD] ? judged_word(t, row) : GRAZE_OK;
}

/* Is an `on` point certainly on the boundary of the closed sweep? It is if its only contact is an
 * instant in a face (d = 2: an edge), since the solid then lies on one side of a plane only. The
 * contact is an instant if the point was generated in the face, not displaced, with a contact of
 * finite order; at a break point the order is that of one side. */
static int surely_boundary(const table *t, const table_row *row) {
    unsigned long i, tangencies, order;
    const char *flat = t->dimension == 2 ? "edge" : "face";
    field cell = table_field(t, row, COLUMN_CELL);
    int one = read_whole(&i, t, table_field(t, row, COLUMN_I)) &&
              read_whole(&tangencies, t, table_field(t, row, COLUMN_T)) && i + tangencies == 1;
    int in_face = cell.length >= 4 && memcmp(cell.start, flat, 4) == 0;
    int instant = read_whole(&order, t, table_field(t, row, COLUMN_ORDER)) &&
                  !field_is(table_field(t, row, COLUMN_STRATUM), "break");
    return one && in_face && instant && table_field(t, row, COLUMN_K).length == 0;
}

graze_status judged_position(const graze_comparison *c, const table *golden, const table_row *row,
                             int pmc) {
    static const char *const positions[] = {"interior", "boundary", "undecided"};
    if (c->options.question != GRAZE_QUESTION_CLOSED || pmc != PMC_ON)
        return GRAZE_OK;
    field topo = table_field(golden, row, column_of("topo"));
    if (!topo.length || index_of(topo, positions, 3) >= 0)
        return GRAZE_OK;
    return judged_no_answer(golden, row, column_of("topo"),
                            "interior, boundary or undecided for `on`");
}

/* The golden pmc under the question asked, of the open or the closed sweep. */
static int truth_of(int *undecided, const graze_comparison *c, const table *t, const table_row *row,
                    int pmc) {
    *undecided = 0;
    if (c->options.question == GRAZE_QUESTION_OPEN || pmc != PMC_ON)
        return pmc;
    field topo = table_field(t, row, column_of("topo"));
    if (field_is(topo, "interior"))
        return PMC_IN;
    if (!field_is(topo, "boundary"))
        *undecided = topo.length > 0 || !surely_boundary(t, row);
    return PMC_ON;
}

static int pmc_wrong(graze_on_as on_as, int truth, int given) {
    if (on_as == GRAZE_ON_AS_ANY && truth == PMC_ON)
        return 0;
    if (on_as == GRAZE_ON_AS_IN || on_as == GRAZE_ON_AS_OUT) {
        int side = on_as == GRAZE_ON_AS_IN ? PMC_IN : PMC_OUT;
        truth = truth == PMC_ON ? side : truth;
        given = given == PMC_ON ? side : given;
    }
    return truth != given;
}

void judge_pmc(judgement *j, graze_on_as on_as, int given) {
    for (int k = 0; k < CONVENTIONS; k++)
        j->wrong_as[k] |= pmc_wrong((graze_on_as)k, j->truth, given);
    j->wrong[COLUMN_PMC] = pmc_wrong(on_as, j->truth, given);
    j->any_wrong |= j->wrong[COLUMN_PMC];
}

judgement judge(const graze_comparison *c, const int *judged, const table *golden,
                const table_row *row, const answer *right, const answer *given,
                const valuation *value) {
    judgement j = {{0}, 0, {0}, 0, 0};
    j.truth = truth_of(&j.undecided, c, golden, row, right->pmc);
    j.undecided |= !value->certain;
    j.wrong[COLUMN_CLASS] = judged[COLUMN_CLASS] && right->class_ != given->class_;
    j.wrong[COLUMN_I] = judged[COLUMN_I] && right->i != given->i;
    j.wrong[COLUMN_T] = judged[COLUMN_T] && right->t != given->t;
    j.wrong[COLUMN_WORD] = judged[COLUMN_WORD] && !field_equal(right->word, given->word);
    j.wrong[COLUMN_SDF] = judged[COLUMN_SDF] && value->judged && value->error.beyond;
    for (int k = 0; k < COLUMN_OPTIONS; k++)
        j.any_wrong |= j.wrong[k];
    for (int k = 0; k < CONVENTIONS; k++)
        j.wrong_as[k] = j.any_wrong;
    if (judged[COLUMN_PMC] && !j.undecided)
        judge_pmc(&j, c->options.on_as, given->pmc);
    return j;
}
