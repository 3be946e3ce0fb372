/* Shared by the fuzz targets. SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A target takes any bytes, hands them to public functions (or to a reader of the command line) and
 * holds the answer to what is promised of it. What breaks a promise ends the process. Contexts have
 * low limits, so that one execution is bounded in time and memory.
 */
#ifndef GRAZE_TESTS_FUZZ_H
#define GRAZE_TESTS_FUZZ_H

#include <stddef.h>
#include <stdint.h>
#include "graze.h"

/** A target: 1 if the bytes were taken for what they should be, 0 if they were refused. */
typedef int fuzz_run(const uint8_t *data, size_t size);

typedef struct fuzz_target {
    const char *name; /* and that of its folder of seeds */
    fuzz_run *run;
} fuzz_target;

/** All targets; the last one has no name. */
extern const fuzz_target fuzz_targets[];

fuzz_run fuzz_off, fuzz_obj, fuzz_ply, fuzz_stl, fuzz_nef3, fuzz_wkt, fuzz_csg, fuzz_scad,
    fuzz_arrays;
fuzz_run fuzz_number, fuzz_expression, fuzz_motion, fuzz_poses, fuzz_gcode, fuzz_joints;
fuzz_run fuzz_points, fuzz_grid, fuzz_options;
fuzz_run fuzz_compare, fuzz_export, fuzz_merge, fuzz_resume, fuzz_receipt;
fuzz_run fuzz_generate, fuzz_boundary, fuzz_draw;
fuzz_run fuzz_scene, fuzz_sweep, fuzz_check;

/* -------------------------------------------------------------------------------- promises */

/** End the process unless the promise holds. */
#define EXPECT(holds) ((holds) ? (void)0 : fuzz_broken(#holds, __FILE__, __LINE__))
void fuzz_broken(const char *promise, const char *file, int line) __attribute__((noreturn));

/** A call that takes the bytes or refuses them: 1 if it took them. A refusal has one of the causes
 * that bytes can have, no handle, and a message of one printable line. */
int fuzz_taken(graze_status status, const graze_context *context, const void *out);

/** The text is JSON. */
int fuzz_is_json(const char *text, size_t length);

/* ---------------------------------------------------------------------------------- inputs */

/** A context with low limits; the caller's. */
graze_context *fuzz_context(void);
/** Set the limits of an existing context low. */
void fuzz_limit(graze_context *context);
/** The limits of fuzz_limit for the command line: words for its argv, `count` of them. */
const char *const *fuzz_limit_words(int *count);

/** Write a file into this process's folder; the path is borrowed until the next call of the same
 * name. `name` is a literal. */
const char *fuzz_file(const char *name, const uint8_t *data, size_t size);
/** The bytes of a file: malloc'ed, with a NUL behind. */
char *fuzz_read(const char *path, size_t *size);

/** A part of the input, ended by a line `----`, or by the input's end. */
typedef struct section {
    const uint8_t *data;
    size_t size;
} section;
/** Cut the input into `count` sections; those that are not there are empty. */
void fuzz_sections(section *out, int count, const uint8_t *data, size_t size);
/** The section as text, malloc'ed, up to its first NUL. */
char *fuzz_text(section s);

/** Words, one a line, behind `name`, for a command's argv; those that name files to write or read
 * are left out. */
enum { FUZZ_WORDS = 40 };
typedef struct words {
    char *text;
    char *word[FUZZ_WORDS + 1];
    int count;
} words;
void fuzz_words(words *out, const char *name, section s);

/** Bytes taken one after the other; 0 where there are no more. */
typedef struct bytes {
    const uint8_t *at;
    size_t left;
} bytes;
unsigned take(bytes *b);
/** From low to high. */
int take_from(bytes *b, int low, int high);
/** Set to a small rational. */
void take_rational(mpq_t out, bytes *b);

/** A cube (a square) that moves along x, made once. */
const graze_scene *fuzz_still_scene(int dimension);

/** Solid, motion and scene as one thing to make and to free. */
typedef struct parts {
    graze_solid *solid;
    graze_motion *motion;
    graze_scene *scene;
} parts;
/** Behind a solid, whose reading gave the status `read`, a motion and the scene: 1 if all are
 * taken.
 */
int parts_complete(parts *p, graze_context *context, graze_status read, const char *json,
                   size_t length, const graze_options *o);
void parts_clear(parts *p);

/** Trace a point with the filter and without it, hold each to the other, and the word, counts and
 * class to the definitions. Returns 1 if the point was answered. */
int fuzz_point(graze_context *context, const graze_scene *scene, graze_rationals point);

#endif
