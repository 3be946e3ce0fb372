/* Cuts a command into words, runs it, and checks for the file that it had to write.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#define _XOPEN_SOURCE 700 /* nftw */
#include <errno.h>
#include <ftw.h>
#include <signal.h>
#include <spawn.h>
#include <stdio.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>
#include "base/context/scope.h"
#include "program/cli/values.h"

extern char **environ;

/* Copy one word, without its quotes, to `to`; returns the end of the word, or NULL if a quote is
 * left open. */
static const char *cut_command_word(char *to, const char *at) {
    char quote = 0;
    for (; *at && (quote || !strchr(" \t\n", *at)); at++) {
        int escapes = *at == '\\' && quote != '\'' && (!quote || at[1] == '"' || at[1] == '\\');
        if (escapes && !at[1])
            return NULL;
        if (escapes)
            *to++ = *++at;
        else if (!quote && (*at == '\'' || *at == '"'))
            quote = *at;
        else if (quote && *at == quote)
            quote = 0;
        else
            *to++ = *at;
    }
    *to = '\0';
    return quote ? NULL : at;
}

/* The value of a word that is a placeholder, else the word; NULL with a complaint if a placeholder
 * is only a part of the word. */
static const char *fill_placeholder(const char *word, const candidate_paths *paths, int *seen) {
    static const char *const names[] = {"{solid}", "{motion}", "{points}", "{out}"};
    const char *const values[] = {paths->solid, paths->motion, paths->points, paths->out};
    for (int k = 0; k < 4; k++) {
        if (strcmp(word, names[k]) == 0) {
            seen[k] = 1;
            return values[k];
        }
        if (strstr(word, names[k])) {
            complain(EXIT_USAGE, "--candidate: %s inside the word '%s'; expected a word of its own",
                     names[k], word);
            return NULL;
        }
    }
    return word;
}

static int split_command(char **words, const char *command, char *buffer,
                         const candidate_paths *paths) {
    int seen[4] = {0};
    size_t count = 0;
    for (const char *at = command;;) {
        at += strspn(at, " \t\n");
        if (!*at)
            break;
        at = cut_command_word(buffer, at);
        if (!at)
            return complain(EXIT_USAGE, "--candidate: a quote or a backslash is left open");
        const char *word = fill_placeholder(buffer, paths, seen);
        if (!word)
            return EXIT_USAGE;
        words[count] = strdup(word);
        if (!words[count++])
            return complain(EXIT_IO, "out of memory");
    }
    if (!seen[2] || !seen[3])
        return complain(EXIT_USAGE,
                        "--candidate: %s is missing; expected 'CMD {solid} {motion} "
                        "{points} {out}'",
                        seen[2] ? "{out}" : "{points}");
    return EXIT_DONE;
}

int candidate_split(char ***words, const char *command, const candidate_paths *paths) {
    size_t length = strlen(command);
    FREED(char, buffer, malloc(length + 1));
    *words = calloc(length / 2 + 2, sizeof **words);
    int status = buffer && *words ? split_command(*words, command, buffer, paths)
                                  : complain(EXIT_IO, "out of memory");
    if (status) {
        candidate_free(*words);
        *words = NULL;
    }
    return status;
}

void candidate_free(char **words) {
    for (size_t k = 0; words && words[k]; k++)
        free(words[k]);
    free(words);
}

/* Start the command in a process group of its own, with empty standard input. */
static int start_candidate(pid_t *child, char **words) {
    posix_spawn_file_actions_t files;
    posix_spawnattr_t attributes;
    sigset_t ignored;
    sigemptyset(&ignored);
    sigaddset(&ignored, SIGPIPE);
    if (posix_spawn_file_actions_init(&files) != 0)
        return ENOMEM;
    if (posix_spawnattr_init(&attributes) != 0) {
        posix_spawn_file_actions_destroy(&files);
        return ENOMEM;
    }
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);
    posix_spawnattr_setsigdefault(&attributes, &ignored);
    posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", 0, 0);
    posix_spawn_file_actions_adddup2(&files, STDERR_FILENO, STDOUT_FILENO);
    int error = posix_spawnp(child, words[0], &files, &attributes, words, environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&files);
    return error;
}

static void end_candidate(pid_t child) {
    int ignored;
    kill(-child, SIGKILL);
    while (waitpid(child, &ignored, 0) < 0 && errno == EINTR)
        continue;
}

/* Wait for the candidate by a look every millisecond, since a blocking wait could miss a signal
 * that comes just before it. */
static int wait_for_candidate(double *seconds, const char *name, pid_t child, unsigned long timeout,
                              const char *hint) {
    const struct timespec pause = {0, 1000000};
    double begin = clock_seconds();
    int state = 0;
    while (waitpid(child, &state, WNOHANG) != child) {
        int late = clock_seconds() - begin > (double)timeout;
        if (interrupt_signal() || late)
            end_candidate(child);
        if (interrupt_signal())
            return EXIT_SIGNAL;
        if (late)
            return complain(EXIT_INPUT,
                            "the candidate %s took more than %lu s; --timeout V raises it", name,
                            timeout);
        nanosleep(&pause, NULL);
    }
    *seconds = clock_seconds() - begin;
    if (WIFSIGNALED(state))
        return complain(EXIT_INPUT, "the candidate %s was ended by signal %d", name,
                        WTERMSIG(state));
    if (WEXITSTATUS(state))
        return complain(EXIT_INPUT, "the candidate %s ended with status %d; expected 0%s", name,
                        WEXITSTATUS(state), hint);
    return EXIT_DONE;
}

int candidate_run(double *seconds, char **words, unsigned long timeout, const char *hint) {
    pid_t child;
    int error = start_candidate(&child, words);
    *seconds = 0;
    if (error)
        return complain(EXIT_INPUT, "the candidate %s cannot be run: %s", words[0],
                        strerror(error));
    return wait_for_candidate(seconds, words[0], child, timeout, hint);
}

int candidate_wrote(const char *name, const char *path) {
    struct stat about;
    if (stat(path, &about) != 0 || access(path, R_OK) != 0)
        return complain(EXIT_INPUT, "the candidate %s has written no table to {out}", name);
    if (S_ISREG(about.st_mode))
        return EXIT_DONE;
    return complain(EXIT_INPUT, "the candidate %s has left a %s at {out}; expected a file", name,
                    S_ISDIR(about.st_mode)    ? "folder"
                    : S_ISFIFO(about.st_mode) ? "FIFO"
                    : S_ISSOCK(about.st_mode) ? "socket"
                                              : "device");
}

static int remove_entry(const char *path, const struct stat *about, int type, struct FTW *where) {
    (void)about, (void)type, (void)where;
    remove(path);
    return 0;
}

void candidate_remove(const char *folder) {
    enum { OPEN_FOLDERS = 16 };
    nftw(folder, remove_entry, OPEN_FOLDERS, FTW_DEPTH | FTW_PHYS);
}
