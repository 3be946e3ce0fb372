/* Heads of numpy's .npy files.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_RUN_NPY_HEAD_H
#define GRAZE_RUN_NPY_HEAD_H

#include "program/run/block.h"

/** Array of points: `rows` of them, each with the coordinates of the space. */
typedef struct npy_head {
    char kind;               /* 'f', 'i' or 'u', of `size` bytes */
    int size, big_endian;    /* 1, 2, 4 or 8 bytes, of floats 4 or 8 */
    int column_after_column; /* Fortran's order: all x first */
    unsigned long rows;
    size_t start; /* byte of the file at which the numbers begin */
} npy_head;

/** Longest head that is read. */
enum { NPY_HEAD_MOST = 1 << 16 };

/** Do the bytes begin as those of a .npy file do? */
int npy_is_begun(const char *bytes, size_t length);

/**
 * Read a head.
 * @param bytes  the file's first `length` bytes: all, or at least NPY_HEAD_MOST
 * @return EXIT_DONE, or the status of the fault, which names the file
 */
int npy_head_read(npy_head *out, fault *f, const char *name, const char *bytes, size_t length,
                  int dimension);

#endif
