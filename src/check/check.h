/* A certificate and its rows; what a word says; the golden table beside it; all of them together.
 * Section 7 of proofs/certificate.md names the files of the core, and those that read.
 * SPDX-License-Identifier: MIT
 */
#ifndef CHECK_CHECK_H
#define CHECK_CHECK_H

#include "trace.h"

/** Head of a certificate. */
typedef struct head {
    int dimension, unsweep, combined, contacts;
    char solid[65], motion[65], scene[65];
} head;

/** Verdict of a word by proofs/claims.md sections 3 and 4. */
typedef struct verdict {
    char claims[80]; /* pmc, and for a sweep class, definition, case, i, t; commas between them */
    unsigned long k; /* for a sweep */
} verdict;

/** The verdict of a word of one or more letters I, B and O. */
verdict verdict_of(const char *states, const head *h);

/** A golden table, its head held to that of the certificate: in it is certified what a certificate
 * claims, which the first columns say, and nothing else. */
typedef struct table {
    lines l;
    const head *h;
    size_t rows;
} table;

/** @param tells a note names the other columns on standard error */
table table_open(const char *path, const head *h, int tells);
/** The next row of the table must say what was found of the point of r, if that is given. */
void table_row(table *t, const trace *r);
/** The table must end with `# complete N`. */
void table_end(table *t);

/** The contact at hand as the text of its line. */
typedef struct contact {
    size_t length, room; /* no text: there is none */
    char *text;
} contact;

/** Go on with the interval of r that was last proved, and its polynomial if the kind has one.
 * Returns 1 if the contact ends with it and its text is whole: the caller then sets `length` to 0.
 */
int contact_follow(contact *c, trace *r, word kind, const poly *q);

/** One certificate being read. */
typedef struct certificate {
    lines l;
    source line; /* what is left of the one at hand */
    head h;
    mpq_t *times; /* of the head's line `signs` */
    size_t time_count, row_count;
    contact contact;
} certificate;

/** Open it and read its head. */
certificate certificate_open(const char *path);
/**
 * Follow its rows to the end of the file; those with a number of `part` modulo `parts` are tested,
 * the others passed over.
 * @param t the table beside it, or NULL
 */
void certificate_follow(certificate *c, trace *r, table *t, size_t part, size_t parts);

/** Arguments of one run of graze-check. */
typedef struct task {
    const char *path[4]; /* solid, motion, certificate, table or NULL */
    int assume_legal;
    size_t jobs; /* processes */
} task;

/** Verify it all, or refute or give up; the number of rows. */
size_t check_files(const task *work);

#endif
