/* A command, and how its options are read.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A command names its options in a table. Each entry has a function that reads the option's value
 * into one field of the command's own struct.
 */
#ifndef GRAZE_CLI_COMMAND_H
#define GRAZE_CLI_COMMAND_H

#include <stddef.h>
#include "program/run/guard.h"

/** Read the value of `--name`, or of `-n` where the name is one letter, into `to`. Returns an exit
 * status and says what is wrong. */
typedef int option_read(void *to, const char *name, const char *value);

/** An option. The value of a flag is "". `read` is NULL for an option that may be given several
 * times: operands.repeated has its values. */
typedef struct option_entry {
    const char *name; /* NULL ends a table */
    enum { OPTION_VALUE, OPTION_FLAG, OPTION_READ, OPTION_WRITTEN } kind;
    option_read *read;
    size_t offset; /* of the field in the command's struct */
} option_entry;

/** The entry of an option with a value, and of one without. */
#define OPTION(name, type, field, read)                                                            \
    { name, OPTION_VALUE, read, offsetof(type, field) }
#define FLAG(name, type, field, read)                                                              \
    { name, OPTION_FLAG, read, offsetof(type, field) }

/** Options whose value is a file to read, and a file to write. */
#define FILE_READ(name, type, field)                                                               \
    { name, OPTION_READ, value_text, offsetof(type, field) }
#define FILE_WRITTEN(name, type, field)                                                            \
    { name, OPTION_WRITTEN, value_text, offsetof(type, field) }

/** Those of `--output FILE` and `-o FILE`, with value_text, or value_output where `-` is as if
 * neither were given. */
#define OUTPUT(type, field, read)                                                                  \
    {"output", OPTION_WRITTEN, read, offsetof(type, field)}, OPTION("o", type, field, read)

/** An option that may be given several times. */
#define REPEATED(name)                                                                             \
    { name, OPTION_VALUE, NULL, 0 }

/** Options of one command at the most. */
enum { OPTIONS_MOST = 40 };

/** Words that are no options, and values of the option that may be given several times, in order.
 * Both arrays are malloc'ed, the strings those of argv. */
typedef struct operands {
    int count, repeated_count;
    char **item;
    const char **repeated;
    const char *output; /* the file for what a command prints that has no OUTPUT of its own */
} operands;

typedef struct command {
    const char *name;
    const option_entry *options;
    size_t size;         /* of the struct the options are read into */
    const void *initial; /* that struct before, NULL: zeroed */
    int reads;           /* number of operands, from the first on, that are files, */
    int inputs;          /* and of the last ones of these, for which `-` is standard input */
    /** Add files that neither these nor OPTION_READ and OPTION_WRITTEN name; may be NULL. */
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

/** Refuse a file to write that is to be read or written besides: EXIT_USAGE, and says so; EXIT_IO.
 * `options` and `given` are those of command_read. */
int command_guard(const command *c, const void *options, const operands *given);

/** Read the words and do what they say; returns an exit status. */
int command_run(const command *c, int argc, char **argv);

#endif
