/* A program of someone who has Graze installed: a cube moves past three points, and an open one is
 * refused. SPDX-License-Identifier: GPL-3.0-or-later
 *
 * It has a function named like one of Graze's inner ones, which must not come in each other's way.
 */
#include <graze.h>
#include <stdio.h>
#include <string.h>

static const double corners[] = {0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0,
                                 0, 0, 2, 2, 0, 2, 2, 2, 2, 0, 2, 2};
static const size_t sizes[] = {4, 4, 4, 4, 4, 4};
static const size_t facets[] = {0, 3, 2, 1, 4, 5, 6, 7, 0, 1, 5, 4,
                                1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7};
static const char motion_text[] = "{\"dimension\": 3, \"pieces\": [{\"t\": [0, 1], "
                                  "\"transform\": {\"translate\": [\"8*t\", 0, 0]}}]}";
static const double points[3][3] = {{5, 1, 1}, {5, 1, 2}, {5, 3, 1}};

int context_fail(void);
int context_fail(void) {
    return 7;
}

/* Prints class and word of a point. */
static graze_status show(graze_context *context, const graze_scene *scene, const double *point) {
    mpq_t p[3];
    for (int k = 0; k < 3; k++) {
        mpq_init(p[k]);
        mpq_set_d(p[k], point[k]);
    }
    graze_trace *trace = NULL;
    graze_status status = graze_trace_create(&trace, context, scene, p);
    if (!status)
        printf("%s %s\n", graze_class_name(graze_trace_verdict(trace).class_),
               graze_trace_word(trace));
    graze_trace_destroy(trace);
    for (int k = 0; k < 3; k++)
        mpq_clear(p[k]);
    return status;
}

int main(void) {
    graze_context *context = NULL;
    graze_solid *solid = NULL, *open = NULL;
    graze_motion *motion = NULL;
    graze_scene *scene = NULL;
    int bad = graze_context_create(&context) ||
              graze_solid_from_doubles(&solid, context, 3, corners, 8, sizes, 6, facets, 0) ||
              graze_motion_from_json(&motion, context, motion_text, strlen(motion_text)) ||
              graze_scene_create(&scene, context, solid, motion, NULL);
    for (int k = 0; !bad && k < 3; k++)
        bad = show(context, scene, points[k]) != GRAZE_OK;
    if (bad)
        puts(graze_context_message(context));
    graze_status refused =
        graze_solid_from_doubles(&open, context, 3, corners, 8, sizes, 5, facets, 0);
    printf("%s\n", refused == GRAZE_EILLEGAL && *graze_context_message(context) ? "refused" : "?");
    printf("%d\n", context_fail());
    graze_scene_destroy(scene);
    graze_motion_destroy(motion);
    graze_solid_destroy(solid);
    graze_context_destroy(context);
    return 0;
}
