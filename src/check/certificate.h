/* A certificate: its head, and its rows followed one by one.
 * SPDX-License-Identifier: MIT
 */
#ifndef CHECK_CERTIFICATE_H
#define CHECK_CERTIFICATE_H

#include "rows.h"
#include "trace.h"

/** One certificate being read. */
typedef struct certificate {
    lines l;
    source line; /* what is left of the one at hand */
    head h;
    mpq_t *times; /* of the head's line `signs` */
    size_t time_count, row_count;
} certificate;

/** Open it and read its head. */
certificate certificate_open(const char *path);
/**
 * Follow its rows to the end of the file; those with a number of `part` modulo `parts` are tested,
 * the others passed over.
 * @param t the table beside it, or NULL
 */
void certificate_follow(certificate *c, trace *r, table *t, size_t part, size_t parts);

#endif
