/* What a word says; the golden table beside the certificate.
 * SPDX-License-Identifier: MIT
 */
#ifndef CHECK_ROWS_H
#define CHECK_ROWS_H

#include "base.h"

/** What a certificate's head says. */
typedef struct head {
    int dimension, unsweep, combined;
    char solid[65], motion[65], scene[65];
} head;

/** What proofs/claims.md sections 3 and 4 make of a word. */
typedef struct verdict {
    char claims[80]; /* pmc, and for a sweep class, definition, case, i, t; commas between them */
    unsigned long k; /* for a sweep */
} verdict;

verdict verdict_of(word states, const head *h);

/** A golden table, its head held to that of the certificate. */
typedef struct table {
    lines l;
    const head *h;
    size_t rows;
} table;

table table_open(const char *path, const head *h);
/** The next row of the table; if it is `held`, it must say this. */
void table_row(table *t, int held, mpq_t *point, const char *states);
/** The table must end with `# complete N`. */
void table_end(table *t);

#endif
