/* graze: chooses the command.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "program/cli/values.h"

#include <stdio.h>
#include <string.h>
#include "base/context/spelling.h"

static const command *const commands[] = {
    &command_check, &command_classify, &command_merge,    &command_explain, &command_generate,
    &command_cases, &command_compare,  &command_validate, &command_motion,  &command_boundary,
    &command_draw,  &command_certify,  &command_convert,  &command_contact, &command_envelope,
    &command_mend,  &command_solid,    &command_collide,  &command_judge,   &command_outline};
enum { COMMANDS = sizeof commands / sizeof *commands };

HELP(overview);

/* The names of all commands, as `a, b or c`. */
static const char *command_names(void) {
    static char names[256];
    size_t used = 0;
    for (size_t k = 0; k < COMMANDS; k++) {
        const char *between = k == 0 ? "" : k + 1 < COMMANDS ? ", " : " or ";
        used +=
            (size_t)snprintf(names + used, sizeof names - used, "%s%s", between, commands[k]->name);
    }
    return names;
}

static int complain_of_command(const char *word) {
    const char *best = NULL;
    for (size_t k = 0; k < COMMANDS; k++)
        near_take(&best, word, commands[k]->name);
    near_take(&best, word, "--version");
    near_take(&best, word, "--help");
    return complain(EXIT_USAGE, "%s: expected a command: %s%s%s%s", word, command_names(),
                    best ? "; did you mean " : "", best ? best : "", best ? "?" : "");
}

/* Is the command line `graze help` alone? `graze help COMMAND` becomes `graze COMMAND --help`. */
static int is_help(int argc, char **argv) {
    static char option[] = "--help";
    if (strcmp(argv[1], "help") != 0)
        return 0;
    if (argc > 2) {
        argv[1] = argv[2];
        argv[2] = option;
    }
    return argc == 2;
}

int main(int argc, char **argv) {
    memory_guard();
    output_guard_standard();
    if (interrupt_watch() != 0)
        return complain(EXIT_IO, "signals cannot be watched");
    if (argc < 2)
        return complain(EXIT_USAGE, "a command is missing: %s; see graze --help", command_names());
    if (is_help(argc, argv) || strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0)
        return output_text(NULL, overview_help);
    if (strcmp(argv[1], "--version") == 0)
        return output_text(NULL, graze_version());
    for (size_t k = 0; k < COMMANDS; k++) {
        if (strcmp(argv[1], commands[k]->name) != 0)
            continue;
        int status = command_run(commands[k], argc - 1, argv + 1);
        if (status == EXIT_SIGNAL)
            interrupt_die();
        return status;
    }
    return complain_of_command(argv[1]);
}
