/* Buffered output to standard output or a file, whose every failure is noticed.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_RUN_OUTPUT_H
#define GRAZE_RUN_OUTPUT_H

#include <gmp.h>
#include <stddef.h>

/** Once a write has failed `error` holds its errno and nothing more is written; a plain file is cut
 * off after its last whole line then. */
typedef struct output {
    int fd;
    const char *name; /* for messages */
    int error;
    size_t open_line; /* bytes written of a line without its end */
    size_t used;
    char buffer[1 << 16];
} output;

/** Is this a name of standard output: `-`, or `-` and an ending, which is the form of what is
 * written? 0 for NULL. */
int output_is_standard(const char *path);
/** The name itself, but for `-` the name with an ending, such as `-.svg`. */
const char *output_name(const char *path, const char *standard);
/** Send output without a name to this file from now on, or to standard error where it is NULL;
 * before that it goes to standard output. */
void output_unnamed(const char *path);
/** Open `path`, or where output without a name goes if it is NULL; an existing file is emptied.
 * Returns an exit status and says what is wrong. */
int output_open(output *out, const char *path);
/** Open a file without changing it, to go on from a place in it; it is made if it is not there.
 * Returns an exit status and says what is wrong. */
int output_continue(output *out, const char *path);
/** Lock the file until it or any other descriptor of it is closed. EXIT_IO: another process has
 * locked it. */
int output_lock(output *out);
/** Cut the file off at that byte and go on from there. */
void output_from(output *out, long long byte);
void output_put(output *out, const char *text);
void output_bytes(output *out, const char *text, size_t length);
/** output_bytes as the function of a sink (output/table/sink.h) whose data is the output. */
void output_sink(void *out, const char *text, size_t length);
/** An integer, or a ratio in lowest terms. */
void output_number(output *out, const mpq_t value);
void output_flush(output *out);
/** Drop what is not written yet, and empty a plain file that was opened by its name: a file in a
 * form that is useless in parts is written whole or not at all. */
void output_drop(output *out);
/** Flush and close. Returns an exit status and says what went wrong since it was opened. */
int output_close(output *out);

/** Write a text to `path`, or to standard output where it is NULL. Returns an exit status and says
 * what is wrong. */
int output_text(const char *path, const char *text);

/** Has the path this extension, such as ".vtk", and a name before it? */
int path_has_extension(const char *path, const char *extension);

/** Make sure that file descriptors 0, 1 and 2 are in use, so that no file opened later takes the
 * place of a closed one; reading or writing one that was closed fails. */
void output_guard_standard(void);

#endif
