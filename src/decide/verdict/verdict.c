/* The rule from contacts to counts, and from counts to a class.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "decide/verdict/verdict.h"

#include <string.h>

/* [EI] Definitions 3 and 4 at the ends of the motion: the germ that is present decides. */
graze_kind verdict_kind(graze_state left, graze_state right) {
    if (left == GRAZE_STATE_ABSENT)
        return right == GRAZE_STATE_I ? GRAZE_INTERSECTION : GRAZE_TANGENCY;
    if (right == GRAZE_STATE_ABSENT)
        return left == GRAZE_STATE_I ? GRAZE_INTERSECTION : GRAZE_TANGENCY;
    return left != right ? GRAZE_INTERSECTION : GRAZE_TANGENCY;
}

static int table_index(graze_state state) {
    return state == GRAZE_STATE_O ? 0 : state == GRAZE_STATE_B ? 1 : 2;
}

int verdict_case(graze_state first, graze_state last) {
    return 3 * table_index(first) + table_index(last) + 1;
}

/* The definitions assume that S^0 and S^1 do not meet, which leaves cases 1-4 and 7. */
static int is_main_case(int case_) {
    return case_ <= 4 || case_ == 7;
}

static graze_class class_of(unsigned long k, unsigned long t, graze_folds folds) {
    if (k == 0)
        return t == 0 ? GRAZE_EXTERIOR : GRAZE_BOUNDARY;
    if (k >= 2 && (t == 0 || folds == GRAZE_FOLDS_COMBINED))
        return GRAZE_FOLD;
    return t == 0 ? GRAZE_REGULAR : GRAZE_FOLD_BOUNDARY;
}

static int definition_of(graze_class class_, graze_folds folds) {
    if (folds == GRAZE_FOLDS_COMBINED && class_ == GRAZE_FOLD)
        return 10;
    if (folds == GRAZE_FOLDS_COMBINED && class_ == GRAZE_FOLD_BOUNDARY)
        return 11;
    return 4 + (int)class_;
}

unsigned long verdict_k(graze_state first, graze_state last, unsigned long i) {
    return (i + (first == GRAZE_STATE_I) + (last == GRAZE_STATE_I)) / 2;
}

graze_verdict verdict_sweep(graze_state first, graze_state last, unsigned long i, unsigned long t,
                            graze_folds folds) {
    graze_verdict v = {.i = i, .t = t};
    v.class_ = class_of(verdict_k(first, last, i), t, folds);
    v.pmc = v.class_ == GRAZE_EXTERIOR   ? GRAZE_OUT
            : v.class_ == GRAZE_BOUNDARY ? GRAZE_ON
                                         : GRAZE_IN;
    v.case_ = verdict_case(first, last);
    v.definition = is_main_case(v.case_) ? definition_of(v.class_, folds) : 0;
    return v;
}

graze_verdict verdict_unsweep(const char *word, size_t length, unsigned long i, unsigned long t) {
    graze_verdict v = {.i = i, .t = t};
    v.pmc = memchr(word, 'O', length) ? GRAZE_OUT : memchr(word, 'B', length) ? GRAZE_ON : GRAZE_IN;
    return v;
}

/* 1 for a word: equal neighbours are merged, and the boundary lies between inside and outside, so
 * every second letter is B. */
static int alternates(const char *word, size_t length) {
    for (size_t k = 0; k < length; k++) {
        int is_b = word[k] == 'B';
        if ((!is_b && word[k] != 'I' && word[k] != 'O') || (k > 0 && is_b == (word[k - 1] == 'B')))
            return 0;
    }
    return length > 0;
}

int verdict_of_word(graze_verdict *out, const char *word, size_t length,
                    const graze_options *options) {
    unsigned long counts[3] = {0, 0, 0}; /* by kind */
    if (!alternates(word, length))
        return 0;
    for (size_t k = 0; k < length; k++) {
        graze_state left = k > 0 ? (graze_state)word[k - 1] : GRAZE_STATE_ABSENT;
        graze_state right = k + 1 < length ? (graze_state)word[k + 1] : GRAZE_STATE_ABSENT;
        if (word[k] == 'B')
            counts[verdict_kind(left, right)]++;
    }
    unsigned long i = counts[GRAZE_INTERSECTION], t = counts[GRAZE_TANGENCY];
    *out = options->operation == GRAZE_UNSWEEP
               ? verdict_unsweep(word, length, i, t)
               : verdict_sweep((graze_state)word[0], (graze_state)word[length - 1], i, t,
                               options->folds);
    return 1;
}

/* Membership where states are not decided (proofs/curved.md C125): by a certain state that decides,
 * if there is one; else `on` if a certain state is B and no undecided state can be the deciding
 * one. */
static graze_pmc pmc_of_certain(const graze_trace *trace, int unsweep) {
    const undecided_place *open = trace->undecided;
    if (strchr(trace->word, unsweep ? 'O' : 'I'))
        return unsweep ? GRAZE_OUT : GRAZE_IN;
    int decisive = unsweep ? open->may_be_out : open->may_be_in;
    return !decisive && strchr(trace->word, 'B') ? GRAZE_ON : GRAZE_PMC_UNDECIDED;
}

void verdict_decide(graze_trace *trace, const graze_options *options) {
    unsigned long i = 0, t = 0;
    if (trace->undecided) {
        int unsweep = options->operation == GRAZE_UNSWEEP;
        trace->verdict = (graze_verdict){
            .pmc = pmc_of_certain(trace, unsweep),
            .class_ = unsweep ? GRAZE_CLASS_NONE : GRAZE_CLASS_UNDECIDED,
        };
        return;
    }
    if (trace->settled) {
        trace->verdict =
            (graze_verdict){.pmc = options->operation == GRAZE_UNSWEEP ? GRAZE_OUT : GRAZE_IN};
        return;
    }
    for (size_t k = 0; k < trace->contact_count; k++)
        if (verdict_kind(trace->contact[k].left, trace->contact[k].right) == GRAZE_INTERSECTION)
            i++;
        else
            t++;
    trace->verdict = options->operation == GRAZE_UNSWEEP
                         ? verdict_unsweep(trace->word, strlen(trace->word), i, t)
                         : verdict_sweep(trace->first, trace->last, i, t, options->folds);
}
