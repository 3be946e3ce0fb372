/* cli: the commands of `graze`, a file each, and their documents.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_PROGRAM_CLI_H
#define GRAZE_PROGRAM_CLI_H

#include <stddef.h>
#include "program/io/io.h"
#include "program/run/run.h"

/** Read the value of `--NAME`, or of `-N` where the name is one letter, into `to`. Returns an exit
 * status and says what is wrong. */
typedef int option_read(void *to, const char *name, const char *value);

/** An option. The value of a flag is "". `read` is NULL for an option that may be given several
 * times: operands.repeated has its values. */
typedef struct option_entry {
    const char *name; /* NULL ends a table */
    enum { OPTION_VALUE, OPTION_FLAG, OPTION_MAYBE, OPTION_READ, OPTION_WRITTEN } kind;
    option_read *read;
    size_t offset; /* of the field in the command's struct */
} option_entry;

/** Words that are no options, and values of the option that may be given several times, each in
 * order. Both arrays are malloc'ed; the strings are borrowed from argv. */
typedef struct operands {
    int count, repeated_count;
    char **item;
    const char **repeated;
    unsigned long long options; /* bit k: option k of the command's table was given */
    const char *output; /* --output of a command without its own: the file for what it prints */
} operands;

typedef struct command {
    const char *name;
    const option_entry *options;
    size_t size;         /* size of the struct into which the options are read */
    const void *initial; /* initial value of this struct; NULL: zeros */
    int reads;           /* the first `reads` operands are files */
    int inputs;          /* for the last `inputs` of these files `-` is standard input */
    const char *takes;   /* `least` to `reads` operands, in words; NULL: `run` counts them */
    int least;
    /** Add files that neither the operands nor OPTION_READ and OPTION_WRITTEN name; may be NULL. */
    void (*add_files)(guard *g, const void *options, const operands *given);
    const char *help;
    int (*run)(void *options, const operands *given);
} command;

/**
 * Read the words of a command; `argv[0]` is its name. Says on standard error what is wrong.
 * @param[out] given   for operands_clear in either case
 * @param[out] options a struct of the command's size
 * @param[out] help    1 if --help was asked for
 * @return EXIT_DONE, EXIT_USAGE, EXIT_IO
 */
int command_read(operands *given, void *options, int *help, const command *c, int argc,
                 char **argv);
void operands_clear(operands *given);

/** Refuse, with EXIT_USAGE and a message, a file to write that the command also reads or writes a
 * second time. Returns EXIT_IO when out of memory. `options` and `given` are those of command_read.
 */
int command_guard(const command *c, const void *options, const operands *given);

/** The command classify, whose options are a classify_options. */
extern const command command_classify;

/** Take the operands over, and check that they and the options go together. Returns an exit status
 * and says what is wrong. */
int classify_take(classify_options *o, const operands *given);

#endif
