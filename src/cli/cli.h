/* What the commands share: options, messages and exit status.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CLI_CLI_H
#define GRAZE_CLI_CLI_H

#include "cli/shard.h"
#include "graze.h"

/** Exit status (src/cli/formats.md, Exit status). */
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

/** The options of its own that a command may have. */
enum { OWN_OPTIONS = 16 };

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
    int exact_only;      /* --no-filter */
    int quiet;           /* no progress */
    int sharded;         /* --shard was given */
    shard part;          /* the whole run unless it was */
    const char *resume;  /* the table to continue */
    const char *receipt; /* check writes it, classify trusts it */
    graze_compare_options compare;
    graze_comparison_format report;
    const char *candidate, *points, *keep; /* validate */
    unsigned long timeout;                 /* seconds; 0: as the command has it */
    int mark_count;
    const char **marks;           /* draw: -p X,Y[,Z], malloc'ed like the operands */
    const char *own[OWN_OPTIONS]; /* the command's own, in its order; NULL: not given */
    int operand_count;
    char **operands; /* malloc'ed array of what is no option, options anywhere between */
} options;

/** A command: its name, its options, its help, what it does. The options are a set of letters
 * (cli/options.c) and then, each after a blank, the names of those of its own; one that ends in `=`
 * takes a value, and without one `own` holds "". */
typedef struct command {
    const char *name;
    const char *allowed;
    const char *help;
    int (*run)(const options *o);
} command;

extern const command command_check, command_classify, command_explain, command_generate,
    command_cases, command_compare, command_validate, command_merge, command_motion,
    command_boundary, command_draw, command_certify;

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

/** The exit status for a number or a point that was refused: a limit or the machine's, or else
 * `otherwise`. */
int exit_for(graze_status status, int otherwise);

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
 * readable but illegal. `out` is freed by unload in either case. `trusted` is the SHA-256 of a
 * solid's file that was validated before (graze_solid_read_trusted), or NULL. */
int load(loaded *out, const options *o, int illegal, const unsigned char *trusted);
void unload(loaded *l);

#endif
