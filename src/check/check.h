/* Certificates and their rows; the verdict of a word; golden tables; the check of all files
 * together. Section 7 of proofs/certificate.md says which files are the core and which only read.
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

/** The verdict that follows from a word (proofs/claims.md sections 3 and 4). */
typedef struct verdict {
    char claims[80]; /* pmc and, for a sweep, class, definition, case, i, t; separated by commas */
    unsigned long k; /* for a sweep */
} verdict;

/** The verdict of a word of one or more letters I, B and O. */
verdict verdict_of(const char *states, const head *h);

/** A golden table whose head agrees with that of the certificate. Only its first columns are
 * certified, since they say what a certificate claims. */
typedef struct table {
    lines l;
    const head *h;
    size_t rows;
} table;

/** @param tells 1: a note on standard error names the columns that are not certified */
table table_open(const char *path, const head *h, int tells);
/** Read the next row of the table; if r is given, refutes the row unless it has the point of r and
 * what was found of it. */
void table_row(table *t, const trace *r);
/** Refute the table unless it ends with `# complete N`, N the number of rows read. */
void table_end(table *t);

/** The contact being followed, as the text of the line that must claim it. */
typedef struct contact {
    size_t length, room; /* 0: no contact is being followed */
    char *text;
} contact;

/** Follow the contact through the interval of r that was proved last; q is the polynomial of a kind
 * of three letters. Returns 1 if the contact ends in this interval: then its text is complete, and
 * the caller sets `length` to 0.
 */
int contact_follow(contact *c, trace *r, word kind, const poly *q);

/** One certificate being read. */
typedef struct certificate {
    lines l;
    source line; /* the unread part of the current line */
    head h;
    mpq_t *times; /* the times in the head's line `signs` */
    size_t time_count, row_count;
    contact contact;
} certificate;

/** Open a certificate and read its head. */
certificate certificate_open(const char *path);
/**
 * Read all rows to the end of the file. Rows whose number is `part` modulo `parts` are tested, the
 * others skipped.
 * @param t the golden table of the certificate, or NULL
 */
void certificate_follow(certificate *c, trace *r, table *t, size_t part, size_t parts);

/** Arguments of one run of graze-check. */
typedef struct task {
    const char *path[4]; /* solid, motion, certificate, table or NULL */
    int assume_legal;
    size_t jobs; /* processes */
} task;

/** Verify all files and return the number of rows; otherwise the program ends as refuted or not
 * checked. */
size_t check_files(const task *work);

#endif
