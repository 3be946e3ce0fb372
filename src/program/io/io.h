/* io: files, messages and exit status of the programs; contexts and scenes made by options.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_PROGRAM_IO_H
#define GRAZE_PROGRAM_IO_H

#include <gmp.h>
#include <stddef.h>
#include "base/number/text.h"
#include "graze.h"

/* Handles of the library that one command makes for itself. */

/** OWNED(graze_mesh, mesh): `graze_mesh *mesh`, NULL, destroyed at the end of the scope
 * (base/context/scope.h). */
#define OWNED(type, name) __attribute__((cleanup(owned_##type))) type *name = NULL

#define OWNED_DESTROYS(type)                                                                       \
    static inline void owned_##type(type **held) {                                                 \
        type##_destroy(*held);                                                                     \
    }

OWNED_DESTROYS(graze_boundary)
OWNED_DESTROYS(graze_comparison)
OWNED_DESTROYS(graze_context)
OWNED_DESTROYS(graze_curve)
OWNED_DESTROYS(graze_envelope)
OWNED_DESTROYS(graze_generator)
OWNED_DESTROYS(graze_judgement)
OWNED_DESTROYS(graze_mesh)
OWNED_DESTROYS(graze_motion)
OWNED_DESTROYS(graze_outline)
OWNED_DESTROYS(graze_pair)
OWNED_DESTROYS(graze_patches)
OWNED_DESTROYS(graze_scene)
OWNED_DESTROYS(graze_site)
OWNED_DESTROYS(graze_solid)
OWNED_DESTROYS(graze_trace)

/* Files that a command reads and writes, compared before it opens one for writing.
 *
 * Two names are one file if device and inode are equal; for a file that does not exist yet, if the
 * folder and the name in it are equal. Pipes, devices and folders are not compared. */

/** How a file is used; GUARD_INPUT: read, where `-` is standard input. */
typedef enum guard_use { GUARD_READ, GUARD_INPUT, GUARD_WRITTEN } guard_use;

/** Zeroed, and guard_clear. Strings are borrowed. */
typedef struct guard {
    struct guarded *item;
    size_t count, room;
    int failed; /* memory ran out */
} guard;

/**
 * Add a file.
 * @param option the option that names it, without `--`; NULL: an operand
 * @param path   its name; NULL, or `-` for a file to be written: standard output
 * @param ending stands behind the path, "" for none
 */
void guard_add(guard *g, guard_use use, const char *option, const char *path, const char *ending);

/** Refuse a file to be written that is named twice: EXIT_USAGE, with a message. EXIT_IO: memory. */
int guard_check(const guard *g);

void guard_clear(guard *g);

/* Exit status and messages of the programs. */

/** Exit status (src/program/cli/formats.md, Exit status). */
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

/** Write `graze: MESSAGE` and a line end to standard error; returns `status`. With EXIT_LIMIT the
 * option that raises the limit stands behind the message. */
int complain(int status, const char *format, ...) __attribute__((format(printf, 2, 3)));

/** From now on complain writes no notes: messages with EXIT_DONE. */
void complain_of_faults_alone(void);

/** The context's message without the name of the public function that it begins with, which users
 * of commands do not know. Valid as long as the message. */
const char *complaint_of(const graze_context *context);

/** Write the context's message, but nothing for GRAZE_OK or a cancel; returns the exit status for
 * `status` (EXIT_SIGNAL for a cancel). */
int complain_of(graze_status status, const graze_context *context);

/** As complain_of, but GRAZE_EUSE is a fault of the command line: EXIT_USAGE. */
int complain_of_use(graze_status status, const graze_context *context);

/** The exit status for a number or a point that was refused with `status`: that of a limit or of a
 * failing machine, for other causes `otherwise`. */
int exit_for(graze_status status, int otherwise);

/* Contexts and scenes as the options ask for them. */

/** Options of a context. Zeroed: no rounding, the filter, default limits. */
typedef struct context_options {
    graze_rounding rounding;
    int exact_only;                          /* --no-filter */
    unsigned long limits[GRAZE_LIMIT_COUNT]; /* 0: the default */
} context_options;

/** Options of a scene, its files, and what rows of it show. Strings are borrowed; the sizes of
 * options are set when the scene is read. */
typedef struct scene_options {
    const char *solid, *motion; /* motion NULL: the solid alone is read, and there is no scene
                                 unless rows are at_rest */
    unsigned solid_flags;
    graze_options scene;
    graze_row_options rows;
    int sdf_relative; /* rows.sdf is a fraction of the diagonal */
    context_options context;
} scene_options;

/** Make a context with these options, canceled by a signal. On failure says why; `*out` is to be
 * destroyed in either case. */
int context_make(graze_context **out, const context_options *o);

/** Solid, motion and scene, made and freed together; and a certifier, or NULL. Its rows' sdf is a
 * width. */
typedef struct loaded {
    graze_context *context;
    graze_solid *solid;
    graze_motion *motion;
    graze_scene *scene;
    graze_certifier *certifier;
    graze_row_options rows;
} loaded;

/**
 * Read the files of a scene. On failure says why and returns an exit status.
 * @param[out] out for loaded_clear in either case
 * @param illegal  the exit status of a scene that is readable but illegal
 * @param trusted  SHA-256 of a solid's file that was validated before (graze_solid_read_trusted),
 *                 or NULL
 */
int loaded_read(loaded *out, const scene_options *o, int illegal, const unsigned char *trusted);
/** Kinds of solids that a command or an option takes. */
enum { TAKES_POLYGONS = 1, TAKES_POLYHEDRA = 2, TAKES_STRAIGHT = 3 };
/** Refuse a solid of a kind that `what`, a command or an option, does not take: EXIT_INPUT, with a
 * message. */
int load_takes(const graze_solid *solid, const char *path, const char *what, unsigned kinds);
/** The line of a table's head that says whether facets were cut. Static. */
const char *load_note(const scene_options *o);
void loaded_clear(loaded *l);

/* Checksums of 64 bits over bytes, against accidents. */

/** Zeroed it is the checksum of no bytes. How the bytes are divided among calls does not matter. */
typedef struct checksum {
    unsigned long long sum, held; /* held: the last length % 8 bytes, the first one lowest */
    unsigned long long length;
} checksum;

void checksum_add(checksum *c, const char *bytes, size_t length);
/** The value for the bytes so far. */
unsigned long long checksum_value(const checksum *c);

/* SIGINT, SIGTERM and SIGHUP as a flag that long work asks for. */

/** Catch SIGINT, SIGTERM and SIGHUP, unless they are ignored already; ignore SIGPIPE and SIGXFSZ,
 * so that a write fails instead. A process that still works ten seconds after a caught signal dies
 * of it. 0 on success. */
int interrupt_watch(void);

/** The signal that came, or 0. Any thread may ask. */
int interrupt_signal(void);

/** Report the signal that came and die of it, so that the shell sees it. */
void interrupt_die(void);

/* The end of the program where memory runs out and no status can be returned. */

/** Have GMP, MPFR and FLINT end the program with a message and EXIT_IO when they get no memory.
 * By default they abort, and FLINT's message would be written into the table. To be called before
 * their first use. */
void memory_guard(void);

/** Have `what` called before memory_guard ends the program; NULL: nothing. It runs in any thread
 * and may neither allocate memory nor take locks. */
void memory_before_end(void (*what)(void));

/* Numbers on the command line, and as text. */

/**
 * Read `count` numbers between commas.
 * @param[out] out     initialised rationals
 * @param name         the option, for the message
 * @return EXIT_USAGE, EXIT_LIMIT, EXIT_IO
 */
int numbers_read(mpq_t *out, graze_context *context, const char *name, const char *text,
                 size_t length, int count);

/** numbers_read of a whole text; nothing where it is NULL. */
int numbers_given(mpq_t *out, graze_context *context, const char *name, const char *text,
                  int count);

/** Rationals of a command: HELD(rationals, n, 3) has n.at[0] to n.at[2], all 0. */
enum { NUMBERS_MOST = 24 };
typedef struct rationals {
    int count;
    mpq_t at[NUMBERS_MOST];
} rationals;
void rationals_init(rationals *n, int count);
void rationals_clear(rationals *n);

/** Read a whole number of digits alone that is at least `low`; 0 if the text is none. */
int numbers_count(unsigned long *out, const char *text, unsigned long low);

/** An integer, or a ratio in lowest terms: malloc'ed; NULL when out of memory. */
char *numbers_text(const mpq_t value);

/* Buffered output to standard output or a file, whose every failure is noticed. */

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
/** The name itself; for `-` the name `standard`, which has an ending, such as `-.svg`. */
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
/** Cut the file off after its first `byte` bytes, and write on from there. */
void output_from(output *out, long long byte);
void output_put(output *out, const char *text);
/** Put a text of at most 255 bytes. */
void output_format(output *out, const char *format, ...) __attribute__((format(printf, 2, 3)));
void output_bytes(output *out, const char *text, size_t length);
/** output_bytes as the function of a sink (output/table/table.h) whose data is the output. */
void output_sink(void *out, const char *text, size_t length);
/** An integer, or a ratio in lowest terms. */
void output_number(output *out, const mpq_t value);
void output_flush(output *out);
/** Drop the bytes that are not written yet, and empty a plain file that was opened by its name: for
 * formats in which a part is useless. */
void output_drop(output *out);
/** Flush and close. Returns an exit status and says what went wrong since it was opened. */
int output_close(output *out);

/** output_close after work that ended with `status`, which is returned unless it is 0. */
int output_end(output *out, int status);

/** Write a text to `path`, or where output without a name goes (output_unnamed) where it is NULL.
 * Returns an exit status and says
 * what is wrong. */
int output_text(const char *path, const char *text);
/** output_text, or EXIT_IO with a message where memory ran short while the text was made. */
int output_made(const char *path, const text *made);

/** Has the path this extension, such as ".vtk", and a name before it? */
int path_has_extension(const char *path, const char *extension);

/** Make sure that file descriptors 0, 1 and 2 are in use, so that no file opened later takes the
 * place of a closed one; reading or writing one that was closed fails. */
void output_guard_standard(void);

/* A line that grows on standard error, where it is a terminal: rows, rate and, where the end is
 * known, per cent and the time left. */

/** How far the work is: `done` of `whole`, in any unit; `whole` is 0 if the end is unknown. */
typedef struct portion {
    unsigned long done, whole;
} portion;

typedef struct progress {
    int silent;
    double start, shown;  /* seconds of the monotonic clock */
    unsigned long rows;   /* rows at the start */
    unsigned long before; /* the portion done at the start */
} progress;

/** Seconds of the monotonic clock. */
double clock_seconds(void);

/** Begin, where `rows` rows are there already; `quiet` shows nothing. */
void progress_start(progress *p, int quiet, unsigned long rows, portion reached);
/** Show how many rows are there now, at most once a second. */
void progress_show(progress *p, unsigned long rows, portion reached);
/** Show the end and close the line. */
void progress_end(progress *p, unsigned long rows, portion reached);

/* The seconds a command has worked, on standard error where it is a terminal.
 *
 * For commands whose work has no rows to count. One thread starts and clears; any may show. */

/** From now on waiting_show shows the time since then; until then it does nothing. */
void waiting_start(void);
/** Show the seconds worked, at most once a second, after the first two. */
void waiting_show(void);
/** Take the line away, so that a message or an answer can stand there. */
void waiting_clear(void);

#endif
