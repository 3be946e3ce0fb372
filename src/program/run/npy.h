/* Points out of numpy's .npy files.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_RUN_NPY_H
#define GRAZE_RUN_NPY_H

#include "base/number/text.h"
#include "program/run/npy_head.h"

typedef struct npy npy;

/** Is the plain file behind this descriptor a .npy file, by its name or its first bytes? */
int npy_is(int fd, const char *name);

/** Read the head of such a file; context, file and name are borrowed. npy_close in any case.
 * @return EXIT_DONE, or the status of the fault, which names the file */
int npy_open(npy **out, fault *f, graze_context *context, int fd, const char *name, int dimension);
void npy_close(npy *a);

/**
 * The next point as a line of exact numbers between commas: integers, or ratios whose value is the
 * float; borrowed until the next call. Its start is NULL at the end.
 * @return EXIT_DONE, or the status of the fault, which names file, row and column
 */
int npy_next(npy *a, fault *f, field *line);

/** Points handed out, and in all. */
unsigned long npy_done(const npy *a);
unsigned long npy_count(const npy *a);

#endif
