/* Reads a command's options with getopt_long.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Options may stand anywhere. A word that begins like a negative number is an operand, so that
 * `explain SOLID MOTION -1 2` needs no `--`.
 */
#include "program/cli/values.h"

#include <ctype.h>
#include <getopt.h>
#include "base/context/scope.h"
#include "base/context/spelling.h"

enum { HELP = 256, FIRST_OPTION };

/* The arguments of getopt_long; an option's value is its place in the command's table. */
typedef struct option_table {
    struct option entries[OPTIONS_MOST + 3];
    char letters[2 * OPTIONS_MOST + 8];
} option_table;

static void make_option_table(option_table *t, const option_entry *options) {
    memset(t, 0, sizeof *t);
    strcpy(t->letters, "-:h");
    t->entries[0] = (struct option){"help", no_argument, NULL, HELP};
    struct option *next = t->entries + 1;
    for (int k = 0; options[k].name; k++) {
        int argument = options[k].kind == OPTION_FLAG    ? no_argument
                       : options[k].kind == OPTION_MAYBE ? optional_argument
                                                         : required_argument;
        if (options[k].name[1])
            *next++ = (struct option){options[k].name, argument, NULL, FIRST_OPTION + k};
        else
            strcat(strcat(t->letters, options[k].name), argument == no_argument ? "" : ":");
    }
    if (!strchr(t->letters, 'o')) {
        *next = (struct option){"output", required_argument, NULL, 'o'};
        strcat(t->letters, "o:");
    }
}

/* The entry of the table that getopt_long's answer means; NULL: `--output` of a command whose table
 * lacks it. */
static const option_entry *find_option(const option_entry *options, int code) {
    if (code >= FIRST_OPTION)
        return options + (code - FIRST_OPTION);
    while (options->name && (options->name[1] || *options->name != code))
        options++;
    return options->name ? options : NULL;
}

static int is_negative_number(const char *word) {
    return word[0] == '-' && (isdigit((unsigned char)word[1]) || word[1] == '.');
}

/* Complain of a word that getopt_long could not read. */
static int complain_of_word(const command *c, int code, const char *word) {
    if (code == ':')
        return complain(EXIT_USAGE, "%s: the option needs a value; see graze %s --help", word,
                        c->name);
    if (optopt >= HELP)
        return complain(EXIT_USAGE, "%s: the option takes no value; see graze %s --help", word,
                        c->name);
    if (optopt && strncmp(word, "--", 2) != 0)
        return complain(EXIT_USAGE, "-%c: %s has no such option; see graze %s --help", optopt,
                        c->name, c->name);
    const char *best = NULL;
    for (const option_entry *e = c->options; e->name && strncmp(word, "--", 2) == 0; e++)
        near_take(&best, word + 2, e->name);
    return complain(EXIT_USAGE, "%s: %s has no such option; %s%s%ssee graze %s --help", word,
                    c->name, best ? "did you mean --" : "", best ? best : "", best ? "? " : "",
                    c->name);
}

static int read_option(operands *given, void *options, const command *c,
                       const option_entry *entry) {
    if (!entry) {
        given->output = optarg;
        return EXIT_DONE;
    }
    given->options |= 1ull << (entry - c->options);
    const char *value = entry->kind == OPTION_FLAG || !optarg ? "" : optarg;
    if (entry->read)
        return entry->read((char *)options + entry->offset, entry->name, value);
    given->repeated[given->repeated_count++] = value;
    return EXIT_DONE;
}

int command_read(operands *given, void *options, int *help, const command *c, int argc,
                 char **argv) {
    option_table table;
    int status = EXIT_DONE;
    make_option_table(&table, c->options);
    if (c->initial)
        memcpy(options, c->initial, c->size);
    else
        memset(options, 0, c->size);
    *help = 0;
    *given = (operands){.item = calloc((size_t)argc + 1, sizeof *given->item),
                        .repeated = calloc((size_t)argc + 1, sizeof *given->repeated)};
    if (!given->item || !given->repeated)
        return complain(EXIT_IO, "out of memory");
    opterr = 0;
    optind = 1;
    while (!status && !*help && optind < argc) {
        if (is_negative_number(argv[optind])) {
            given->item[given->count++] = argv[optind++];
            continue;
        }
        int code = getopt_long(argc, argv, table.letters, table.entries, NULL);
        if (code == -1)
            while (optind < argc)
                given->item[given->count++] = argv[optind++];
        else if (code == 1)
            given->item[given->count++] = optarg;
        else if (code == '?' || code == ':')
            status = complain_of_word(c, code, argv[optind - 1]);
        else if (code == 'h' || code == HELP)
            *help = 1;
        else
            status = read_option(given, options, c, find_option(c->options, code));
    }
    return status;
}

void operands_clear(operands *given) {
    free(given->item);
    free(given->repeated);
    *given = (operands){.item = NULL};
}

void scene_files(scene_options *o, const operands *given) {
    o->solid = given->item[0];
    o->motion = given->item[1];
}

/* Does the option name a file that takes the place of standard output? */
static int is_for_output(const option_entry *entry) {
    return strcmp(entry->name, "output") == 0 || strcmp(entry->name, "resume") == 0 ||
           strcmp(entry->name, "inside") == 0 || strcmp(entry->name, "outside") == 0;
}

int command_guard(const command *c, const void *options, const operands *given) {
    ZEROED(guard, g);
    int prints = !given->output, product = 0, yields = 0;
    for (int k = 0; k < given->count && k < c->reads; k++)
        guard_add(&g, k < c->reads - c->inputs ? GUARD_READ : GUARD_INPUT, NULL, given->item[k],
                  "");
    for (const option_entry *e = c->options; e->name; e++) {
        int is_file = e->kind == OPTION_READ || e->kind == OPTION_WRITTEN;
        if (!is_file && !is_for_output(e))
            continue;
        const char *path = *(const char *const *)((const char *)options + e->offset);
        if (path && is_file)
            guard_add(&g, e->kind == OPTION_READ ? GUARD_READ : GUARD_WRITTEN, e->name, path, "");
        prints &= !path || !is_for_output(e);
        product |= is_for_output(e);
        yields |= e->kind == OPTION_WRITTEN && output_is_standard(path);
    }
    if (c->add_files)
        c->add_files(&g, options, given);
    if (given->output)
        guard_add(&g, GUARD_WRITTEN, "output", given->output, "");
    if (prints && (product || !yields)) /* a report goes to standard error where it has to yield */
        guard_add(&g, GUARD_WRITTEN, NULL, NULL, "");
    TRY(guard_check(&g));
    if (yields || given->output)
        output_unnamed(given->output);
    return EXIT_DONE;
}

static int check_count(const command *c, const operands *given) {
    if (!c->takes || (given->count >= c->least && given->count <= c->reads))
        return EXIT_DONE;
    return complain(EXIT_USAGE, "%s takes %s, %d operands given; see graze %s --help", c->name,
                    c->takes, given->count, c->name);
}

/* Does a command show its progress in rows? Commands with --quiet do. */
static int counts_rows(const command *c) {
    for (const option_entry *e = c->options; e->name; e++)
        if (strcmp(e->name, "quiet") == 0)
            return 1;
    return 0;
}

int command_run(const command *c, int argc, char **argv) {
    int help;
    ZEROED(operands, given);
    FREED(void, options, malloc(c->size + !c->size));
    if (!options)
        return complain(EXIT_IO, "out of memory");
    int status = command_read(&given, options, &help, c, argc, argv);
    if (!status && !help)
        status = command_guard(c, options, &given);
    if (!status && !help)
        status = check_count(c, &given);
    if (!counts_rows(c))
        waiting_start();
    if (!status)
        status = help ? output_text(NULL, c->help) : c->run(options, &given);
    waiting_clear();
    graze_thread_finish();
    return status;
}
