/* What the commands share: options, messages and exit status.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CLI_CLI_H
#define GRAZE_CLI_CLI_H

#include "graze.h"

/** Exit status (formats: Commands). */
enum {
    EXIT_DONE = 0,
    EXIT_NO = 1,
    EXIT_USAGE = 2,
    EXIT_INPUT = 3,
    EXIT_FAULT = 4,
    EXIT_IO = 5,
    EXIT_LIMIT = 6,
    EXIT_SIGNAL = 128 /* the caller dies of the signal that came */
};

/** The command line, read. Strings are borrowed from argv. */
typedef struct options {
    graze_options scene;
    graze_rounding rounding;
    unsigned solid_flags;
    graze_format format;
    graze_export exported; /* classify: what the table is turned into at the end */
    unsigned long limits[GRAZE_LIMIT_COUNT]; /* 0: as the context has it */
    const char *grid, *box, *output, *strata, *folder;
    long jobs;
    unsigned long count;     /* -n */
    unsigned long long seed; /* --seed */
    int seeded, representable;
    int exact_only; /* --no-filter */
    graze_compare_options compare;
    graze_comparison_format report;
    const char *candidate, *points, *keep; /* validate */
    unsigned long timeout;                 /* seconds; 0: as the command has it */
    const char *title, *plane, *view;      /* draw */
    unsigned long times;                   /* 0: as the command has it */
    int mark_count;
    const char **marks; /* -p X,Y[,Z], malloc'ed like the operands */
    int operand_count;
    char **operands; /* malloc'ed array of what is no option, options anywhere between */
} options;

/** A command: its name, its options (a set of letters, cli/options.c), its help, what it does. */
typedef struct command {
    const char *name;
    const char *allowed;
    const char *help;
    int (*run)(const options *o);
} command;

extern const command command_check, command_classify, command_explain, command_generate,
    command_cases, command_compare, command_validate, command_draw;

/**
 * Read the options of a command; `argv[0]` is the command's name. Says on standard error what is
 * wrong.
 * @param[out] help 1 if --help was asked for
 * @return EXIT_DONE or EXIT_USAGE; `out` is cleared by options_clear in either case
 */
int options_read(options *out, int *help, const command *c, int argc, char **argv);
void options_clear(options *o);

/** Write `graze: MESSAGE` and a line end to standard error; returns `status`. */
int complain(int status, const char *format, ...) __attribute__((format(printf, 2, 3)));

/** Say the context's message; returns the exit status its cause has (EXIT_SIGNAL for a cancel). */
int complain_of(graze_status status, const graze_context *context);

/** A context with the options' rounding and limits and the interrupt as its cancel. */
graze_status context_for(graze_context **out, const options *o);

/** Solid, motion and scene as one thing to make and to free. */
typedef struct loaded {
    graze_context *context;
    graze_solid *solid;
    graze_motion *motion;
    graze_scene *scene;
} loaded;

/** Read operands 0 and 1. On failure says why and returns the exit status; `illegal` is the one for
 * readable but illegal. `out` is freed by unload in either case. */
int load(loaded *out, const options *o, int illegal);
void unload(loaded *l);

#endif
