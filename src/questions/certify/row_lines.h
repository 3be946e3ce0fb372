/* The lines of a certificate's row: intervals, and contacts where they are wanted
 * (proofs/certificate.md, section 1). SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CERTIFY_ROW_LINES_H
#define GRAZE_CERTIFY_ROW_LINES_H

#include "base/number/text.h"
#include "decide/trace/trace.h"

/** A row being written. */
typedef struct row_lines {
    text *out;
    const graze_trace *trace;  /* its contacts are written with their cells; NULL: none are */
    size_t said;               /* their number */
    const motion_piece *piece; /* the one at hand */
    text start, finish;        /* where the next interval begins, and the last one ends */
    text opened;               /* the beginning of a contact that has not ended; empty: none */
} row_lines;

/** Begin to write the intervals of a row. */
void row_lines_init(row_lines *l, text *out, const graze_trace *trace, const graze_motion *motion);
void row_lines_clear(row_lines *l);
/** Write an interval up to u = high / 2^exponent, and the contact that ends with it. `q` is that of
 * a kind of three letters, in u. */
void row_lines_put(row_lines *l, const char *kind, const fmpz_t high, ulong exponent,
                   const fmpz_poly_struct *q);

#endif
