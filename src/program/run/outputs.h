/* The files of one run: a table, a certificate, or both.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A certificate is written before the rows of its table, so that a table never tells of a row whose
 * certificate is not there.
 */
#ifndef GRAZE_RUN_OUTPUTS_H
#define GRAZE_RUN_OUTPUTS_H

#include "output/table/typed.h"
#include "program/run/answer.h"
#include "program/run/files.h"
#include "program/run/record.h"
#include "program/run/results.h"

/** Zeroed, outputs_init, and outputs_close in any case. */
typedef struct outputs {
    const classify_options *o;
    const loaded *l;
    results file[RESULT_KINDS];
    typed_table typed;  /* the table, where it is exported */
    record_file beside; /* of the table, or of the certificate alone */
    int recorded;       /* rows of this run are in it */
    record at;          /* how far the rows have come; not beyond a row without an answer */
} outputs;

void outputs_init(outputs *out, const classify_options *o, const loaded *l);
/** Is that file wanted? */
int outputs_wants(const outputs *out, result_kind kind);
/** The file that counts the rows: the table, or the certificate alone. */
results *outputs_main(outputs *out);

/** Open the files, or those to continue. Returns an exit status and says what is wrong. */
int outputs_open(outputs *out);
/** Number of rows that need not be made again: those in the record of an earlier run. */
unsigned long outputs_skip(const outputs *out);
/** Pass over these rows, whose points, `rows` of them, have this checksum. EXIT_INPUT: they are
 * other rows, or of other points. */
int outputs_pass(outputs *out, unsigned long rows, unsigned long long points);
/** Write the heads. `source` has the columns or the grid. */
int outputs_begin(outputs *out, const row_source *source);
/** Write the rows of a block that have answers, up to the first that has none. EXIT_SIGNAL: that
 * was left out after a signal. */
int outputs_block(outputs *out, const block *b);
/** Write the last lines, or the table in the form asked for. `rows_of_all` and `checksum` describe
 * the whole run, so that merge can match the parts. */
int outputs_end(outputs *out, unsigned long rows_of_all, unsigned long long checksum);
/** All points are answered. EXIT_INPUT: a continued file has more rows. */
int outputs_check_end(const outputs *out);
/** Has a write failed? */
int outputs_failed(const outputs *out);
/** Flush and close. Returns `status`, or why the writing failed; after a signal, says how many rows
 * there are. */
int outputs_close(outputs *out, int status);

#endif
