/* Counts, case, class of a word: proofs/claims.md C10, C12, C14, C15, C20.
 * SPDX-License-Identifier: MIT
 */
#include <string.h>
#include "rows.h"

static int column(char state) {
    return state == 'O' ? 0 : state == 'B' ? 1 : 2;
}

/* An inner contact is an intersection iff its sides differ; one at an end iff its germ is I. */
static void count(verdict *v, const char *w, size_t n) {
    for (size_t k = 0; k < n; k++) {
        if (w[k] != 'B')
            continue;
        char left = k > 0 ? w[k - 1] : 0, right = k + 1 < n ? w[k + 1] : 0;
        int crosses = left && right ? left != right : left == 'I' || right == 'I';
        v->i += (unsigned long)crosses;
        v->t += (unsigned long)!crosses;
    }
    v->k = (v->i + (w[0] == 'I') + (w[n - 1] == 'I')) / 2;
}

static void classify(verdict *v, int combined) {
    if (v->k == 0) {
        v->class_ = v->t > 0 ? "boundary" : "exterior";
        v->definition = v->t > 0 ? "8" : "9";
        v->pmc = v->t > 0 ? "on" : "out";
        return;
    }
    v->pmc = "in";
    if (combined ? v->k >= 2 : v->k >= 2 && v->t == 0) {
        v->class_ = "fold";
        v->definition = combined ? "10" : "6";
    } else if (v->t > 0) {
        v->class_ = "fold_boundary";
        v->definition = combined ? "11" : "7";
    } else {
        v->class_ = "regular";
        v->definition = "5";
    }
}

verdict verdict_of(const char *w, size_t n, int unsweep, int combined) {
    static const int cases[3][3] = {{1, 4, 7}, {2, 5, 8}, {3, 6, 9}}; /* [at t1][at t0] */
    verdict v = {.pmc = "on", .class_ = "", .definition = ""};
    if (unsweep) {
        if (memchr(w, 'O', n))
            v.pmc = "out";
        else if (n == 1 && w[0] == 'I')
            v.pmc = "in";
        return v;
    }
    count(&v, w, n);
    classify(&v, combined);
    v.position = cases[column(w[n - 1])][column(w[0])];
    if (v.position == 5 || v.position == 6 || v.position == 8 || v.position == 9)
        v.definition = "ext";
    return v;
}
