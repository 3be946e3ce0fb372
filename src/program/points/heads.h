/* Heads of files of points.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_PROGRAM_POINTS_HEADS_H
#define GRAZE_PROGRAM_POINTS_HEADS_H

#include "program/points/points.h"

/* The columns of a file of contact points, and of a list of pairs. */

/** Find the columns by a line of names: time and point, and `cell` if points are moved. All other
 * columns are carried along, except those with names of columns of a table of contact points.
 * @return EXIT_DONE or the status of the fault */
int site_columns_fix(fault *f, columns *c, const fields *names, unsigned long number);

/** Find the columns of a list of pairs; GRAZE_EUSE's exit status for one that names an option that
 * lists do not take. */
int pair_columns_fix(fault *f, columns *c, const fields *names, unsigned long number);

/** Set the fault of a file that has no such line of names. */
int names_fault(fault *f, const columns *c, unsigned long number, const char *what);

/** Is a field an irrational time as tables write it? */
int site_time_is_root(field token);

/** The name of number `index` of a row; number 0 is the time. */
const char *site_number_name(const site_form *s, int index);

void columns_clear(columns *c);
/** Must the file have a line of names? */
int columns_are_named(const columns *c);

/**
 * Fix the columns by the first line of a file that is neither blank nor a comment.
 * @param[out] header 1 if the line names the columns, 0 if it is a row
 * @return EXIT_DONE, or the status of the fault, which names file and line
 */
int columns_fix(int *header, fault *f, columns *c, graze_context *context, field text,
                unsigned long number, columns_head head);

/* Boundary cells as graze generate writes them. */

/** The form of a cell, for messages. */
#define CELL_FORM "`face 3`, `edge 1-2` or `vertex 5`"

/** Read a cell in CELL_FORM; an edge is stored with the lower number first. 0 if the text is none.
 */
int cell_read(graze_cell *out, field text);

/* Heads of numpy's .npy files. */

/** An array of points: `rows` points, each with d coordinates. */
typedef struct npy_head {
    char kind;               /* 'f', 'i' or 'u': floats, integers, unsigned integers */
    int size, big_endian;    /* size of a number: 1, 2, 4 or 8 bytes, for floats 4 or 8 */
    int column_after_column; /* Fortran's order: all x come first */
    unsigned long rows;
    size_t start; /* byte of the file at which the numbers begin */
} npy_head;

/** Longest head that is read. */
enum { NPY_HEAD_MOST = 1 << 16 };

/** Do the bytes begin like a .npy file? */
int npy_is_begun(const char *bytes, size_t length);

/**
 * Read a head.
 * @param bytes  the file's first `length` bytes: all, or at least NPY_HEAD_MOST
 * @return EXIT_DONE, or the status of the fault, which names the file
 */
int npy_head_read(npy_head *out, fault *f, const char *name, const char *bytes, size_t length,
                  int dimension);

/* Points out of numpy's .npy files. */

/** NPY_ROWS is the most rows in memory, NPY_ROW_BYTES the most bytes of a row. */
enum { NPY_ROWS = 4096, NPY_ROW_BYTES = 24 };

struct npy {
    npy_head head;
    int fd, dimension;
    graze_context *context; /* of decimals; borrowed */
    const char *name;
    unsigned long done, from, to; /* rows handed out; rows `from` to `to` - 1 are in memory */
    text line;
    mpq_t value;
    unsigned char bytes[NPY_ROWS * NPY_ROW_BYTES]; /* in the order of the file */
};

/** Is a descriptor's file a plain file that is .npy by its name or its first bytes? */
int npy_is(int fd, const char *name);

/** Read the head of a .npy file; context, file and name are borrowed. npy_close frees it in any
 * case.
 * @return EXIT_DONE, or the status of the fault, which names the file */
int npy_open(npy **out, fault *f, graze_context *context, int fd, const char *name, int dimension);
void npy_close(npy *a);

/**
 * Give the next point as a line of exact numbers with commas between them: integers, or decimals
 * whose value is the float. The line is borrowed until the next call; its start is NULL at the end.
 * @return EXIT_DONE, or the status of the fault, which names file, row and column
 */
int npy_next(npy *a, fault *f, field *line);

#endif
