/* api: the functions of the public headers, of everything below.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_API_H
#define GRAZE_API_H

#include <stddef.h>
#include "base/context/context.h"
#include "base/context/scope.h"
#include "base/number/text.h"
#include "decide/lattice/lattice.h"
#include "decide/scene/scene.h"
#include "decide/trace/trace.h"
#include "graze.h"
#include "graze/core.h"
#include "input/solid/solid.h"

/* The head of a public function, whose context is called `context`. */

/** *out becomes NULL or 0; nothing happens where `out` is NULL. */
#define EMPTY(out) api_empty(out, sizeof *(out))

/** Refuse NULL among these arguments, plain names with `, ` between them, by their names. */
#define GIVEN(...) GIVEN_TO(__func__, __VA_ARGS__)

/** GIVEN of what several public functions share; the message names the one that was called. */
#define GIVEN_TO(function, ...)                                                                    \
    TRY(api_given(context, function, #__VA_ARGS__, (const void *const[]){__VA_ARGS__}))

/** GIVEN, and the floating-point environment to the function's end. */
#define PUBLIC(...)                                                                                \
    GIVEN(__VA_ARGS__);                                                                            \
    IN_ENVIRONMENT()

/** PUBLIC of a function that has one output, which is emptied first. */
#define PUBLIC_OUT(out, ...)                                                                       \
    EMPTY(out);                                                                                    \
    PUBLIC(out, __VA_ARGS__)

/** Refuse a wrong call by GRAZE_EUSE: the condition holds. */
#define REFUSED(condition, reason)                                                                 \
    TRY((condition) ? api_misuse(context, __func__, reason) : GRAZE_OK)

/** The end of a public function: `made` is allocated, zeroed, and `fill` fills it; *out becomes it,
 * or it is dropped and the status of `fill` returned. `drop` takes NULL: `free` where `fill` leaves
 * nothing after a failure, else the destroyer of the handle, which clears what is there. */
#define CREATE(out, made, drop, fill)                                                              \
    do {                                                                                           \
        __typeof__(*(out)) made = calloc(1, sizeof *made);                                         \
        graze_status filled =                                                                      \
            made ? (fill) : context_fail(context, GRAZE_ESYSTEM, "out of memory");                 \
        if (filled)                                                                                \
            drop(made);                                                                            \
        else                                                                                       \
            *(out) = made;                                                                         \
        return filled;                                                                             \
    } while (0)

/** Define the destroyer of a handle, for which NULL is harmless: `clear`, an expression in `of`,
 * frees what the handle has. */
#define DESTROYER(type, clear)                                                                     \
    void type##_destroy(type *of) {                                                                \
        if (of)                                                                                    \
            clear;                                                                                 \
        free(of);                                                                                  \
    }

/** Define a public function that tells a fact, an expression in `of`, of a handle; for NULL it is
 * `none`. */
#define FACT(returned, function, handle, fact, none)                                               \
    returned function(const handle *of) {                                                          \
        return of ? fact : none;                                                                   \
    }

/** The message of a wrong call; GRAZE_EUSE also where there is no context to hold it. */
graze_status api_misuse(graze_context *context, const char *function, const char *reason);

void api_empty(void *out, size_t size);

/** @param names the names of the pointers `given`, with commas between them */
graze_status api_given(graze_context *context, const char *function, const char *names,
                       const void *const *given);

/**
 * Refuse a solid of a kind that a public function does not take.
 * @param name the function, an argument of it, "FUNCTION: ARGUMENT", or a column of rows
 * @return GRAZE_EINPUT a curved solid, or one without a box where that is needed; GRAZE_EILLEGAL
 * one of another dimension
 */
graze_status api_takes(graze_context *context, const char *name, const graze_solid *solid);

/**
 * Check a caller's rational.
 * @return GRAZE_EUSE it is not in lowest terms with a positive denominator; GRAZE_ELIMIT it has
 * more digits than the limit allows
 */
graze_status api_rational_check(graze_context *context, const mpq_t value);

/** Check a caller's rational and take it over. */
graze_status api_rational(fmpq_t out, graze_context *context, const mpq_t value);

/** Check a caller's point and take it over, into d rationals; the place of a failure is recorded.
 */
graze_status api_point(fmpq *out, graze_context *context, const graze_scene *scene,
                       graze_rationals point);

/** Put item and coordinate before a message and record the place; `item` may be NULL. */
graze_status api_coordinate(graze_context *context, graze_status status, const char *item,
                            size_t index, size_t coordinate);

/**
 * Copy the caller's options, whose first member is their size in bytes; the other members become
 * zero, and all do for NULL.
 * @param known size of the struct in this version
 * @return GRAZE_EUSE a size too small, or members that this version does not know
 */
graze_status api_options(void *out, size_t known, graze_context *context, const char *function,
                         const void *options);

/** Hand a point to the caller's initialised variables. */
void api_point_out(mpq_t *out, const fmpq *point, int dimension);

/** As graze_classify, of rationals or, if these are NULL, of doubles. */
graze_status api_classify(graze_verdict *out, graze_context *context, const graze_scene *scene,
                          graze_rationals rationals, const double *doubles, size_t n,
                          graze_columns columns);

/** Add vertices of the soup's dimension, rationals or, if these are NULL, doubles. */
graze_status api_vertices(soup *s, graze_context *context, graze_rationals rationals,
                          const double *doubles, size_t count);

/* The enclosure of one point's distance, for public functions of more than one file. */

/** As graze_distances, of one point, whose number is not told. */
graze_status api_enclose(graze_enclosure *out, graze_context *context, const graze_scene *scene,
                         const fmpq *point, double tolerance);

/* Grids, for the public functions of other files. */

/** Answers that are computed when they are first asked for; under locks of their own. */
typedef struct grid_memory {
    bricks bricks;
    axis_texts texts;
} grid_memory;

struct graze_grid {
    lattice lattice;
    grid_memory *memory;
};

/* Rows, for the public functions of other files. */

/** Take the caller's options of rows over. GRAZE_EUSE: unknown, or not together. */
graze_status api_rows(graze_row_options *out, graze_context *context, const char *function,
                      const graze_row_options *options);

struct certifier;

/**
 * Trace points and make their rows: of a table in out[0], unless that is NULL, and with a certifier
 * those of its certificate in out[1].
 * @param[out] length, done the bytes of each, and the points whose rows are whole; no other row is
 * handed over
 */
graze_status api_points(char **const out[2], size_t *const length[2], size_t *done,
                        graze_row_totals *totals, graze_context *context, const graze_scene *scene,
                        const struct certifier *certifier, graze_rationals points, size_t n,
                        const graze_row_texts *texts, const graze_row_options *shown);

/* Solids of OpenSCAD's `.csg` files. */

/** Read a file and take everything as it stands. `sha256` is that of a file read before, or
 * NULL. */
graze_status api_scad_solid(graze_solid **out, graze_context *context, const char *path,
                            const unsigned char *sha256);

#endif
