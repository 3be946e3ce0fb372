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

    size_t piece; /* whose trajectory is in x: polynomials X_0 .. X_(d-1), W of degree <= n */
    int made;
    poly x[4];
    size_t n;

    mpq_t at;   /* the end of the last interval */
    char *word; /* of the intervals so far; neighbours differ */
    size_t length, room;

    char free;    /* the letter of the stretch off the boundary that goes on, or 0 */
    mpq_t sample; /* its time with the shortest numbers so far */
    size_t sample_piece;

    /* The interval at hand. */
    mpz_t *beta[4];      /* n + 1 scaled Bernstein coefficients each */
    mpz_t *value, *root; /* n + 1 each: of a form; of a quotient */
    size_t beta_room;
    mpz_t form[4];
    list near;
} trace;

void trace_init(trace *r, const solid *s, const motion *m, int unsweep);
void trace_clear(trace *r);
/** Begin a row; `point` has been set. */
void trace_start(trace *r);

/**
 * The claim `kind` on [r->at, to], with the polynomial q of its root where the kind has one (else
 * NULL). Refutes it unless the tests of proofs/certificate.md prove it.
 */
void trace_interval(trace *r, word kind, const mpq_t to, const poly *q);

/** The row ends: it must have come to t1. */
void trace_end(trace *r);

/**
 * Scaled Bernstein coefficients C(n, k) b_k of p on [a, b], to degree n, all times one positive
 * integer that depends on n, a and b alone.
 */
void bernstein(mpz_t *out, const poly *p, size_t n, const mpq_t a, const mpq_t b);
/** 1 or -1 if all have this strict sign, else 0. */
int strict_sign(mpz_t *c, size_t count);

#endif
