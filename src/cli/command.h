/* A command, and how its options are read.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A command names its options in a table. Each entry has a function that reads the option's value
 * into one field of the command's own struct.
 */
#ifndef GRAZE_CLI_COMMAND_H
#define GRAZE_CLI_COMMAND_H

#include <stddef.h>

/** Read the value of `--name`, or of `-n` where the name is one letter, into `to`. Returns an exit
 * status and says what is wrong. */
typedef int option_read(void *to, const char *name, const char *value);

/** An option. The value of a flag is "". `read` is NULL for an option that may be given several
 * times: operands.repeated has its values. */
typedef struct option_entry {
    const char *name; /* NULL ends a table */
    enum { OPTION_VALUE, OPTION_FLAG } kind;
    option_read *read;
    size_t offset; /* of the field in the command's struct */
} option_entry;

/** The entry of an option with a value, and of one without. */
#define OPTION(name, type, field, read)                                                            \
    { name, OPTION_VALUE, read, offsetof(type, field) }
#define FLAG(name, type, field, read)                                                              \
    { name, OPTION_FLAG, read, offsetof(type, field) }

/** That of an option that may be given several times. */
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
} operands;

typedef struct command {
    const char *name;
    const option_entry *options;
    size_t size;         /* of the struct the options are read into */
    const void *initial; /* that struct before, NULL: zeroed */
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

/** Read the words and do what they say; returns an exit status. */
int command_run(const command *c, int argc, char **argv);

#endif
