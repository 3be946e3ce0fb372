/* One row's trajectory, and the tests of what the certificate claims of its intervals.
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
    mpz_t *p; /* its homogeneous coordinates, d + 1, the last positive */

    size_t piece; /* whose trajectory is in x: polynomials X_0 .. X_(d-1), W of degree <= n */
    poly x[4];
    size_t n;

    mpq_t from, at; /* the last interval's ends; `at` is t0 before the first */
    char *word;     /* that the row claims */
    size_t length;  /* letters of `word` that the intervals so far have spelled */

    /* The interval at hand. */
    mpz_t *beta;  /* n + 1 times the d + 1 scaled Bernstein coefficients of x */
    mpz_t *coefs; /* n + 1: of one polynomial */
    mpz_t *form;  /* d + 1 */
    list near;

    /* Cells met since the caller last took them, each once: 8 times a simplex, and a bit for each
     * side form that is zero there. */
    int with_cells;
    list met;
    unsigned char *is_met; /* of a simplex, a bit for each of its cells */
} trace;

/** @param with_cells cells that are met are kept, and others are to be known as not met */
void trace_init(trace *r, const solid *s, const motion *m, int unsweep, int with_cells);
/** Begin a row of this word of the letters I, B and O; `point` has been set. */
void trace_start(trace *r, word claimed);
/**
 * The claim `kind` of the grammar on [r->at, to], with the polynomial q of its root if it has three
 * letters, else NULL. Refutes it unless the tests of proofs/certificate.md prove it.
 */
void trace_interval(trace *r, word kind, const mpq_t to, const poly *q);
/** The row ends: it must have come to t1 and have spelled its word. */
void trace_end(trace *r);

#endif
