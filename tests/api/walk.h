/* Small scenes for the tests of the public functions.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_TESTS_API_WALK_H
#define GRAZE_TESTS_API_WALK_H

#include "../lib/harness.h"
#include <math.h>
#include "graze.h"

/* The square [0, 2]^2 and a translation by (8t, 0), t in [0, 1] (tests/examples/examples.txt, 1 to
 * 9). */
static const double square[] = {0, 0, 2, 0, 2, 2, 0, 2};
static const size_t square_sizes[] = {4};
static const size_t square_ring[] = {0, 1, 2, 3};
static const char slide[] = "{\"dimension\": 2, \"pieces\": [{\"t\": [0, 1], \"transform\": "
                            "{\"translate\": [\"8*t\", 0]}}]}";

/* Rows in these forms. */
static const graze_row_options as_csv = {.size = sizeof as_csv, .format = GRAZE_FORMAT_CSV};
static const graze_row_options as_jsonl = {.size = sizeof as_jsonl, .format = GRAZE_FORMAT_JSONL};

typedef struct scene {
    graze_context *context;
    graze_solid *solid;
    graze_motion *motion;
    graze_scene *scene;
} scene;

static inline void scene_open(scene *s, const char *motion, const graze_options *options) {
    assert_int_equal(graze_context_create(&s->context), GRAZE_OK);
    assert_int_equal(graze_solid_from_doubles(&s->solid, s->context, 2, square, 4, square_sizes, 1,
                                              square_ring, 0),
                     GRAZE_OK);
    assert_int_equal(graze_motion_from_json(&s->motion, s->context, motion, strlen(motion)),
                     GRAZE_OK);
    assert_int_equal(graze_scene_create(&s->scene, s->context, s->solid, s->motion, options),
                     GRAZE_OK);
}

static inline void scene_close(scene *s) {
    graze_scene_destroy(s->scene);
    graze_motion_destroy(s->motion);
    graze_solid_destroy(s->solid);
    graze_context_destroy(s->context);
    graze_thread_finish();
}

#endif
