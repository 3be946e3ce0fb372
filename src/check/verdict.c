/* Finds counts, case and class of a word: proofs/claims.md C10, C12, C14, C15, C20.
 * SPDX-License-Identifier: MIT
 */
#include <string.h>
#include "check.h"

static int column(char state) {
    return state == 'O' ? 0 : state == 'B' ? 1 : 2;
}

/* Count intersections i and tangencies t. A contact between two states is an intersection iff they
 * differ; one at an end of the word iff the state beside it is I. */
static void count(unsigned long *i, unsigned long *t, const char *states) {
    for (const char *at = states; *at; at++) {
        char left = at > states ? at[-1] : 0, right = at[1];
        int crosses = left && right ? left != right : left == 'I' || right == 'I';
        *(crosses ? i : t) += *at == 'B';
    }
}

/* pmc, class and definition. */
static const char *class_of(unsigned long k, unsigned long t, int combined) {
    if (k == 0)
        return t > 0 ? "on,boundary,8" : "out,exterior,9";
    if (combined && k >= 2)
        return "in,fold,10";
    if (t > 0)
        return combined ? "in,fold_boundary,11" : "in,fold_boundary,7";
    return k >= 2 ? "in,fold,6" : "in,regular,5";
}

verdict verdict_of(const char *states, const head *h) {
    static const int cases[3][3] = {{1, 4, 7}, {2, 5, 8}, {3, 6, 9}}; /* [at t1][at t0] */
    verdict v = {"", 0};
    unsigned long i = 0, t = 0;
    if (h->unsweep) {
        const char *pmc = strcmp(states, "I") == 0 ? "in" : strchr(states, 'O') ? "out" : "on";
        snprintf(v.claims, sizeof v.claims, "%s", pmc);
        return v;
    }
    char first = states[0], last = states[strlen(states) - 1];
    count(&i, &t, states);
    v.k = (i + (first == 'I') + (last == 'I')) / 2;
    const char *class_ = class_of(v.k, t, h->combined);
    int position = cases[column(last)][column(first)];
    int extended = column(first) > 0 && column(last) > 0;
    int length = (int)(extended ? strrchr(class_, ',') - class_ : (long)strlen(class_));
    snprintf(v.claims, sizeof v.claims, "%.*s%s,%d,%lu,%lu", length, class_, extended ? ",ext" : "",
             position, i, t);
    return v;
}
