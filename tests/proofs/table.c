/* For each word of I, B and O on standard input the row that the C functions make of it, in the
 * form of proofs/coq/table.v: word, i, t, k, case, then class, pmc and definition by Definitions 6
 * and 7 and by 10 and 11, and the pmc of the unsweep.
 *
 * The contacts alone are made here; the word, the states beside the contacts and those at both ends
 * are made by word_read, counts and classes by verdict_decide. A question after the state at a
 * time, which word_read asks of the solid, is answered from the word (linked with
 * --wrap=tracer_locate). Each word is read twice: with the time of every contact, and with that of
 * its inner crossings left out, as the filter does. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "decide/scene/scene.h"
#include "decide/trace/trace.h"
#include "decide/verdict/verdict.h"
#include "input/motion/motion.h"

enum { LONGEST = 64 };

static const char *asked_word;

graze_status __wrap_tracer_locate(graze_state *out, tracer *r, size_t piece, const fmpq_t u);

/* Letter j stands at time j / (n - 1); one that is not B fills the gap between its neighbours. */
graze_status __wrap_tracer_locate(graze_state *out, tracer *r, size_t piece, const fmpq_t u) {
    (void)r, (void)piece;
    size_t steps = strlen(asked_word) - 1;
    fmpq_t place;
    fmpz_t below;
    fmpq_init(place);
    fmpz_init(below);
    fmpq_mul_ui(place, u, steps);
    fmpz_fdiv_q(below, fmpq_numref(place), fmpq_denref(place));
    size_t j = fmpz_get_ui(below);
    if (asked_word[j] == 'B' && !fmpz_is_one(fmpq_denref(place)))
        j++;
    fmpq_clear(place);
    fmpz_clear(below);
    *out = (graze_state)asked_word[j];
    return asked_word[j] == 'B' ? GRAZE_EINTERNAL : GRAZE_OK;
}

static graze_time *new_time(const graze_motion *motion, size_t numerator, size_t denominator) {
    graze_time *time = calloc(1, sizeof *time);
    fmpq_t u;
    if (!time)
        abort();
    time->motion = motion;
    algebraic_init(&time->u);
    fmpz_poly_init(time->poly);
    fmpq_init(time->low);
    fmpq_init(time->high);
    fmpq_init(u);
    fmpq_set_ui(u, numerator, denominator);
    fmpq_canonicalise(u);
    algebraic_set_rational(&time->u, u);
    fmpq_clear(u);
    return time;
}

/* The contacts of a word; without `all_times` an inner crossing knows its sides instead of its
 * time. */
static void make_contacts(graze_trace *trace, const char *word, const graze_motion *motion,
                          int all_times) {
    size_t n = strlen(word);
    trace->contact = calloc(n, sizeof *trace->contact);
    if (!trace->contact)
        abort();
    for (size_t j = 0; j < n; j++) {
        if (word[j] != 'B')
            continue;
        contact *c = &trace->contact[trace->contact_count++];
        if (!all_times && j > 0 && j + 1 < n && word[j - 1] != word[j + 1]) {
            c->left = (graze_state)word[j - 1];
            c->right = (graze_state)word[j + 1];
        } else if (n == 1) { /* all of the motion */
            c->from = new_time(motion, 0, 1);
            c->to = new_time(motion, 1, 1);
        } else {
            c->from = c->to = new_time(motion, j, n - 1);
        }
    }
}

static void print_class(const graze_verdict *v) {
    printf(",%s,%s,%d", graze_class_name(v->class_), graze_pmc_name(v->pmc), v->definition);
}

static int print_row(const char *word, int all_times) {
    motion_piece piece = {0};
    graze_motion motion = {.dimension = 2, .piece_count = 1, .piece = &piece};
    graze_scene scene = {.motion = &motion};
    graze_trace trace = {0};
    tracer r = {.out = &trace, .scene = &scene};
    graze_options options = {.size = sizeof options};
    asked_word = word;
    make_contacts(&trace, word, &motion, all_times);
    if (word_read(&r) != GRAZE_OK)
        return 0;
    verdict_decide(&trace, &options);
    printf("%s,%lu,%lu,%lu,%d", trace.word, trace.verdict.i, trace.verdict.t,
           verdict_k(trace.first, trace.last, trace.verdict.i), trace.verdict.case_);
    print_class(&trace.verdict);
    options.folds = GRAZE_FOLDS_COMBINED;
    verdict_decide(&trace, &options);
    print_class(&trace.verdict);
    options.operation = GRAZE_UNSWEEP;
    verdict_decide(&trace, &options);
    printf(",%s\n", graze_pmc_name(trace.verdict.pmc));
    trace_clear(&trace);
    return 1;
}

int main(void) {
    char word[LONGEST];
    while (fgets(word, sizeof word, stdin)) {
        word[strcspn(word, "\n")] = '\0';
        for (int all_times = 0; all_times < 2; all_times++) {
            if (!print_row(word, all_times)) {
                fprintf(stderr, "%s: expected a word that can be read\n", word);
                return 1;
            }
        }
    }
    return 0;
}
