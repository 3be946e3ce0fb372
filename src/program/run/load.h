/* Contexts and scenes as the options ask for them.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_RUN_LOAD_H
#define GRAZE_RUN_LOAD_H

#include "program/run/status.h"

/** Options of a context. Zeroed: no rounding, the filter, default limits. */
typedef struct context_options {
    graze_rounding rounding;
    int exact_only;                          /* --no-filter */
    unsigned long limits[GRAZE_LIMIT_COUNT]; /* 0: the default */
} context_options;

/** Options of a scene, its files, and what rows of it show. Strings are borrowed; the sizes of
 * options are set when the scene is read. */
typedef struct scene_options {
    const char *solid, *motion; /* motion NULL: the solid alone is read, and there is no scene */
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
/** Refuse a curved solid, which `what`, a command or an option, does not take: EXIT_INPUT, with a
 * message. */
int load_straight(const graze_solid *solid, const char *path, const char *what);
/** The line of a table's head that says whether facets were cut. Static. */
const char *load_note(const scene_options *o);
void loaded_clear(loaded *l);

#endif
