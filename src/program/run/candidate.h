/* A candidate's command: cut into words, its placeholders filled, run and timed, and what it
 * leaves. SPDX-License-Identifier: GPL-3.0-or-later
 *
 * No shell is started. Blanks separate words; '...' is taken as it is, in "..." a backslash
 * stands before " and \, elsewhere before any byte. Nothing is expanded. A placeholder is a word of
 * its own and becomes one argument, with any bytes.
 */
#ifndef GRAZE_RUN_CANDIDATE_H
#define GRAZE_RUN_CANDIDATE_H

/** Values of {solid}, {motion}, {points}, {out}. */
typedef struct candidate_paths {
    const char *solid, *motion, *points, *out;
} candidate_paths;

/**
 * Cut a command into words and fill its placeholders.
 * @param[out] words NULL-ended, for candidate_free; NULL on failure
 * @return EXIT_USAGE a quote left open, a placeholder inside a word or unknown, {points} or {out}
 * missing
 */
int candidate_split(char ***words, const char *command, const candidate_paths *paths);
void candidate_free(char **words);

/** Put a fact into the environment of the candidate. EXIT_IO. */
int candidate_tell(const char *name, const char *value);

/**
 * Run the words and wait, at most `timeout` seconds. Its standard output goes to the standard error
 * of graze.
 * @param[out] seconds of the clock, from start to end
 * @param hint behind the message on a status other than 0; may be empty
 * @return EXIT_INPUT it cannot be run, fails or takes too long; EXIT_SIGNAL
 */
int candidate_run(double *seconds, char **words, unsigned long timeout, const char *hint);

/** Whether a file, or a link to one, is at `path` that can be read; a FIFO could be waited on for
 * ever.
 * @return EXIT_INPUT if not
 */
int candidate_wrote(const char *name, const char *path);
/** Remove a folder with all that is in it; links are not followed. */
void candidate_remove(const char *folder);

#endif
