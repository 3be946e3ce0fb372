/* graze classify, for the programs that start it, and what graze certify shares with it.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CLI_CLASSIFY_H
#define GRAZE_CLI_CLASSIFY_H

#include "program/cli/command.h"
#include "program/run/classify.h"

/** Its options are a classify_options. */
extern const command command_classify;

/** Take the operands over, and check that they and the options go together. Returns an exit status
 * and says what is wrong. */
int classify_take(classify_options *o, const operands *given);

/** Add the record of the rows (record.h), where one may be written. */
void classify_add_record(guard *g, const void *options, const operands *given);

/** Do --output and --resume go together? Returns an exit status and says what is wrong. */
int classify_check_files(const classify_options *o);

/** Is the table one that --resume and --shard go with? Returns an exit status and says what is
 * wrong. */
int classify_check_table(const classify_options *o);

/** Read the value i/n of --shard into a struct shard_choice. */
int value_shard(void *to, const char *name, const char *value);

#endif
