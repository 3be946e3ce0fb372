/* One row's trajectory, and the tests of the certificate's claims about its intervals.
 * SPDX-License-Identifier: MIT
 */
#ifndef CHECK_TRACE_H
#define CHECK_TRACE_H

#include "motion.h"
#include "solid.h"

/** A row being followed from t0 on. */
typedef struct trace {
    const solid *s;
    const motion *m;
    int unsweep;
    size_t line, row; /* for messages */
    mpq_t point[3];
    mpz_t *p; /* homogeneous coordinates of `point`, d + 1 integers, the last positive */

    size_t piece; /* the piece whose trajectory is in x: polynomials X_0 .. X_(d-1), W of degree <=
                     n */
    poly x[4];
    size_t n;

    mpq_t from, at; /* the ends of the last interval; `at` is t0 before the first one */
    char *word;     /* the word that the row claims */
    size_t length;  /* number of letters of `word` that the intervals so far have spelled */

    /* The interval at hand. */
    mpz_t *beta;  /* n + 1 groups of d + 1 scaled Bernstein coefficients of x */
    mpz_t *coefs; /* n + 1 coefficients of one polynomial */
    mpz_t *form;  /* d + 1 */
    list near;

    /* Cells met since the caller last took them, each once: 8 times the number of a simplex plus a
     * bit for each of its side forms that is zero there. */
    int with_cells;
    list met;
    unsigned char *is_met; /* for each simplex, a bit for each of its cells */
} trace;

/** @param with_cells the cells that are met are listed in `met`, and it must be certain that others
 * are not met */
void trace_init(trace *r, const solid *s, const motion *m, int unsweep, int with_cells);
/** Begin a row that claims this word of the letters I, B and O; the caller has set `point`. */
void trace_start(trace *r, word claimed);
/**
 * Test the claim `kind` of the grammar on [r->at, to]; q is the polynomial of the root if `kind`
 * has three letters, else NULL. Refutes the claim unless the tests of proofs/certificate.md prove
 * it.
 */
void trace_interval(trace *r, word kind, const mpq_t to, const poly *q);
/** End the row: refutes it unless its intervals reach t1 and spell its word. */
void trace_end(trace *r);

#endif
