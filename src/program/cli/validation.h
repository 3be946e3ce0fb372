/* One run of graze validate: options, files and what was found.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CLI_VALIDATION_H
#define GRAZE_CLI_VALIDATION_H

#include "program/cli/values.h"
#include "program/run/classify.h"
#include "program/run/generate.h"

/** Files of the folder. */
enum { POINTS, GOLDEN, ANSWERS, FILE_COUNT };

typedef struct validate_options {
    const char *candidate;
    const char *points; /* NULL: points are generated */
    const char *keep;   /* NULL: a folder that goes when all is done */
    const char *output;
    unsigned long timeout; /* seconds; 0: an hour */
    seed_value seed;
    generate_options generate;
    classify_options classify;
    graze_compare_options compare;
    graze_comparison_format format;
} validate_options;

typedef struct validation {
    char *folder;
    int temporary;           /* the folder goes when all is done */
    char *files[FILE_COUNT]; /* in the folder */
    char **words;
    double seconds;
    int deep; /* the golden table has distances */
    generated made;
    graze_context *context;
    graze_comparison *comparison;
} validation;

#endif
