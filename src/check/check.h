/* What graze-check is asked.
 * SPDX-License-Identifier: MIT
 */
#ifndef CHECK_CHECK_H
#define CHECK_CHECK_H

#include "certificate.h"

typedef struct task {
    const char *path[4]; /* solid, motion, certificate, table or NULL */
    int assume_legal;
    size_t jobs; /* processes */
} task;

/** Verify it all, or refute or give up; the number of rows. */
size_t check_files(const task *work);

#endif
