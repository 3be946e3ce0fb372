/* Reads a command's options with getopt_long.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Options may stand anywhere. A word that begins like a negative number is an operand, so that
 * `explain SOLID MOTION -1 2` needs no `--`.
 */
#include <ctype.h>
#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "cli/cli.h"
#include "cli/numbers.h"

/* The letter is the option's name in `allowed` and getopt_long's value. */
static const struct option long_options[] = {{"help", no_argument, NULL, 'h'},
                                             {"round", required_argument, NULL, 'r'},
                                             {"limit", required_argument, NULL, 'l'},
                                             {"triangulate", no_argument, NULL, 't'},
                                             {"overlap", required_argument, NULL, 'v'},
                                             {"folds", required_argument, NULL, 'f'},
                                             {"operation", required_argument, NULL, 'p'},
                                             {"format", required_argument, NULL, 'm'},
                                             {"grid", required_argument, NULL, 'g'},
                                             {"box", required_argument, NULL, 'b'},
                                             {"jobs", required_argument, NULL, 'j'},
                                             {"output", required_argument, NULL, 'o'},
                                             {"folder", required_argument, NULL, 'd'},
                                             {"seed", required_argument, NULL, 's'},
                                             {"strata", required_argument, NULL, 'a'},
                                             {"representable", required_argument, NULL, 'e'},
                                             {"question", required_argument, NULL, 'q'},
                                             {"on-as", required_argument, NULL, 'A'},
                                             {"candidate-has", required_argument, NULL, 'H'},
                                             {"show", required_argument, NULL, 'S'},
                                             {"solid", required_argument, NULL, 'D'},
                                             {"motion", required_argument, NULL, 'M'},
                                             {"candidate", required_argument, NULL, 'C'},
                                             {"points", required_argument, NULL, 'P'},
                                             {"keep", required_argument, NULL, 'K'},
                                             {"timeout", required_argument, NULL, 'T'},
                                             {"no-filter", no_argument, NULL, 'x'},
                                             {"quiet", no_argument, NULL, 'Q'},
                                             {"resume", required_argument, NULL, 'R'},
                                             {"shard", required_argument, NULL, 'N'},
                                             {"receipt", required_argument, NULL, 'Y'},
                                             {NULL, 0, NULL, 0}};

/* -p, whose letter is taken by a long option. */
enum { SHORT_POINT = '@' };

enum { SHARED = sizeof long_options / sizeof *long_options - 1, OWN_FIRST = 256, NAME = 32 };

/* What getopt_long is given: the shared options and the command's own. */
typedef struct option_table {
    struct option entries[SHARED + OWN_OPTIONS + 1];
    char names[OWN_OPTIONS][NAME];
} option_table;

static void table_make(option_table *t, const char *allowed) {
    memset(t, 0, sizeof *t);
    memcpy(t->entries, long_options, SHARED * sizeof *long_options);
    const char *at = strchr(allowed, ' ');
    for (int k = 0; at && k < OWN_OPTIONS; k++) {
        size_t length = strcspn(++at, " ");
        int valued = at[length - 1] == '=';
        snprintf(t->names[k], NAME, "%.*s", (int)length - valued, at);
        t->entries[SHARED + k] = (struct option){
            t->names[k], valued ? required_argument : no_argument, NULL, OWN_FIRST + k};
        at = at[length] ? at + length : NULL;
    }
}

static int allows(const command *c, int letter) {
    return letter >= OWN_FIRST || memchr(c->allowed, letter, strcspn(c->allowed, " ")) != NULL;
}

/* A value out of two or three words. */
static int choose(int *out, const char *option, const char *value, const char *const *names,
                  int count) {
    for (int k = 0; k < count; k++)
        if (strcmp(value, names[k]) == 0) {
            *out = k;
            return EXIT_DONE;
        }
    char list[64] = "";
    for (int k = 0; k < count; k++) {
        strcat(list, k == 0 ? "" : k + 1 < count ? ", " : " or ");
        strcat(list, names[k]);
    }
    return complain(EXIT_USAGE, "--%s %s: right is %s", option, value, list);
}

static int limit_names_complain(const char *value) {
    char list[256] = "";
    for (int k = 0; k < GRAZE_LIMIT_COUNT; k++) {
        strcat(list, k ? ", " : "");
        strcat(list, graze_limit_name((graze_limit)k));
    }
    return complain(EXIT_USAGE, "--limit %s: right is NAME=V, NAME one of %s", value, list);
}

static int read_limit(options *o, const char *value) {
    const char *equals = strchr(value, '=');
    if (!equals)
        return limit_names_complain(value);
    for (int k = 0; k < GRAZE_LIMIT_COUNT; k++) {
        const char *name = graze_limit_name((graze_limit)k);
        size_t length = strlen(name);
        if (length != (size_t)(equals - value) || memcmp(name, value, length) != 0)
            continue;
        if (!numbers_count(&o->limits[k], equals + 1, 1))
            return complain(EXIT_USAGE, "--limit %s: the value must be a whole number from 1 up",
                            value);
        return EXIT_DONE;
    }
    return limit_names_complain(value);
}

static int read_choice(options *o, int letter, const char *value) {
    static const char *const round[] = {"none", "binary64", "binary32"};
    static const char *const overlap[] = {"extend", "reject"};
    static const char *const folds[] = {"separate", "combined"};
    static const char *const operation[] = {"sweep", "unsweep"};
    static const char *const format[] = {"csv", "jsonl", "vtk", "npy"};
    int chosen = 0, status;
    switch (letter) {
    case 'r':
        status = choose(&chosen, "round", value, round, 3);
        o->rounding = (graze_rounding)chosen;
        return status;
    case 'v':
        status = choose(&chosen, "overlap", value, overlap, 2);
        o->scene.overlap = (graze_overlap)chosen;
        return status;
    case 'f':
        status = choose(&chosen, "folds", value, folds, 2);
        o->scene.folds = (graze_folds)chosen;
        return status;
    case 'p':
        status = choose(&chosen, "operation", value, operation, 2);
        o->scene.operation = (graze_operation)chosen;
        return status;
    default:
        status = choose(&chosen, "format", value, format, 4);
        o->exported = chosen == 2   ? GRAZE_EXPORT_VTK
                      : chosen == 3 ? GRAZE_EXPORT_NPY
                                    : GRAZE_EXPORT_NONE;
        o->format = chosen == 1 ? GRAZE_FORMAT_JSONL : GRAZE_FORMAT_CSV;
        return status;
    }
}

/* Options of compare and validate. */
static int read_comparison(options *o, int letter, const char *value) {
    static const char *const question[] = {"open", "closed"};
    static const char *const on_as[] = {"on", "any", "in", "out"};
    static const char *const has[] = {"columns", "sdf"};
    static const char *const format[] = {"text", "json"};
    int chosen = 0, status;
    unsigned long count;
    switch (letter) {
    case 'q':
        status = choose(&chosen, "question", value, question, 2);
        o->compare.question = (graze_question)chosen;
        return status;
    case 'A':
        status = choose(&chosen, "on-as", value, on_as, 4);
        o->compare.on_as = (graze_on_as)chosen;
        return status;
    case 'H':
        status = choose(&chosen, "candidate-has", value, has, 2);
        o->compare.has = (graze_candidate_has)chosen;
        return status;
    case 'F':
        status = choose(&chosen, "format", value, format, 2);
        o->report = (graze_comparison_format)chosen;
        return status;
    case 'S':
        if (!numbers_count(&count, value, 0) || count > 1000000)
            return complain(EXIT_USAGE, "--show %s: right is a whole number up to 1000000", value);
        o->compare.show = count;
        return EXIT_DONE;
    default:
        if (!numbers_count(&o->timeout, value, 1))
            return complain(EXIT_USAGE, "--timeout %s: right are whole seconds from 1 up", value);
        return EXIT_DONE;
    }
}

static int read_option(options *o, int letter, const char *value) {
    unsigned long jobs, seed;
    switch (letter) {
    case 'l':
        return read_limit(o, value);
    case 't':
        o->solid_flags |= GRAZE_SOLID_TRIANGULATE;
        return EXIT_DONE;
    case 'x':
        o->exact_only = 1;
        return EXIT_DONE;
    case 'Q':
        o->quiet = 1;
        return EXIT_DONE;
    case 'R':
        o->resume = value;
        return EXIT_DONE;
    case 'N':
        o->sharded = 1;
        if (!shard_read(&o->part, value))
            return complain(EXIT_USAGE, "--shard %s: right is i/n, 1 <= i <= n <= %d", value,
                            SHARDS_MOST);
        return EXIT_DONE;
    case 'Y':
        o->receipt = value;
        return EXIT_DONE;
    case 'g':
        o->grid = value;
        return EXIT_DONE;
    case 'b':
        o->box = value;
        return EXIT_DONE;
    case 'o':
        o->output = value;
        return EXIT_DONE;
    case 'd':
        o->folder = value;
        return EXIT_DONE;
    case 'a':
        o->strata = value;
        return EXIT_DONE;
    case 'n':
        if (!numbers_count(&o->count, value, 1))
            return complain(EXIT_USAGE, "-n %s: right is a whole number from 1 up", value);
        return EXIT_DONE;
    case 's':
        if (!numbers_count(&seed, value, 0))
            return complain(EXIT_USAGE, "--seed %s: right is a whole number from 0 to 2^64 - 1",
                            value);
        o->seed = seed;
        o->seeded = 1;
        return EXIT_DONE;
    case 'e':
        if (strcmp(value, "binary64") != 0)
            return complain(EXIT_USAGE, "--representable %s: right is binary64", value);
        o->representable = 1;
        return EXIT_DONE;
    case 'j':
        if (!numbers_count(&jobs, value, 1) || jobs > 1024)
            return complain(EXIT_USAGE, "--jobs %s: right is a whole number from 1 to 1024", value);
        o->jobs = (long)jobs;
        return EXIT_DONE;
    case 'D':
        o->compare.solid = value;
        return EXIT_DONE;
    case 'M':
        o->compare.motion = value;
        return EXIT_DONE;
    case 'C':
        o->candidate = value;
        return EXIT_DONE;
    case 'P':
        o->points = value;
        return EXIT_DONE;
    case 'K':
        o->keep = value;
        return EXIT_DONE;
    case SHORT_POINT:
        o->marks[o->mark_count++] = value;
        return EXIT_DONE;
    default:
        return strchr("qAHFST", letter) ? read_comparison(o, letter, value)
                                        : read_choice(o, letter, value);
    }
}

static int is_negative_number(const char *word) {
    return word[0] == '-' && (isdigit((unsigned char)word[1]) || word[1] == '.');
}

/* What getopt_long could not read. */
static int complain_of_word(const command *c, int letter, int code, char **argv) {
    const char *word = argv[optind - 1];
    if (code == ':')
        return complain(EXIT_USAGE, "%s: the option needs a value; see graze %s --help", word,
                        c->name);
    if (letter && strncmp(word, "--", 2) != 0)
        return complain(EXIT_USAGE, "-%c: there is no such option; see graze %s --help", letter,
                        c->name);
    if (letter)
        return complain(EXIT_USAGE, "%s: the option takes no value; see graze %s --help", word,
                        c->name);
    return complain(EXIT_USAGE, "%s: there is no such option; see graze %s --help", word, c->name);
}

int options_read(options *out, int *help, const command *c, int argc, char **argv) {
    memset(out, 0, sizeof *out);
    out->compare.show = 10;
    out->part.count = 1;
    *help = 0;
    option_table table;
    table_make(&table, c->allowed);
    out->operands = calloc((size_t)argc + 1, sizeof *out->operands);
    out->marks = calloc((size_t)argc + 1, sizeof *out->marks);
    if (!out->operands || !out->marks)
        return complain(EXIT_IO, "out of memory");
    opterr = 0;
    optind = 1;
    while (optind < argc) {
        if (is_negative_number(argv[optind])) {
            out->operands[out->operand_count++] = argv[optind++];
            continue;
        }
        int index = -1, letter = getopt_long(argc, argv, "-:hn:o:p:", table.entries, &index);
        const char short_name[] = {(char)letter, 0};
        if (letter == 'p' && index < 0)
            letter = SHORT_POINT;
        if (letter == -1) {
            while (optind < argc)
                out->operands[out->operand_count++] = argv[optind++];
        } else if (letter == 1) {
            out->operands[out->operand_count++] = optarg;
        } else if (letter == 'h') {
            *help = 1;
            return EXIT_DONE;
        } else if (letter == '?' || letter == ':') {
            return complain_of_word(c, optopt, letter, argv);
        } else if (!allows(c, letter)) {
            return complain(EXIT_USAGE, "%s has no option %s%s; see graze %s --help", c->name,
                            index < 0 ? "-" : "--",
                            index < 0 ? short_name : long_options[index].name, c->name);
        } else if (letter >= OWN_FIRST) {
            out->own[letter - OWN_FIRST] = optarg ? optarg : "";
        } else {
            int reports = letter == 'm' && allows(c, 'F');
            int status = read_option(out, reports ? 'F' : letter, optarg);
            if (status)
                return status;
        }
    }
    return EXIT_DONE;
}

void options_clear(options *o) {
    free(o->operands);
    free(o->marks);
    o->operands = NULL;
    o->marks = NULL;
}
