/* Golden points, the candidate's wrong answers, and the scene that the table's head describes.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include "base/context/scope.h"
#include "program/cli/values.h"
#include "program/io/io.h"

/* The options of the golden table's head, as they stand behind `graze explain`. */
static void take_scene_options(scene_options *to, const char *head) {
    if (strstr(head, " --round binary64"))
        to->context.rounding = GRAZE_ROUND_BINARY64;
    if (strstr(head, " --round binary32"))
        to->context.rounding = GRAZE_ROUND_BINARY32;
    if (strstr(head, " --folds combined"))
        to->scene.folds = GRAZE_FOLDS_COMBINED;
    if (strstr(head, " --operation unsweep"))
        to->scene.operation = GRAZE_UNSWEEP;
    if (strstr(head, " --triangulate"))
        to->solid_flags |= GRAZE_SOLID_TRIANGULATE;
}

/* The answer for each point on which the candidate is wrong. */
static void take_answers(const char **answers, size_t count, const graze_comparison *c) {
    graze_disagreement wrong;
    for (size_t k = 0; (wrong = graze_comparison_disagreement(c, k)).point; k++)
        if (wrong.golden && wrong.row < count)
            answers[wrong.row] = wrong.candidate ? wrong.candidate : "nothing";
}

static int draw_compared(const char *file, const loaded *l, const char *golden,
                         const graze_comparison *c) {
    ZEROED(marks, m);
    m.dimension = graze_scene_dimension(l->scene);
    TRY(marks_read(&m, golden, l->context));
    FREED(const char *, answers, calloc(m.count + 1, sizeof *answers));
    if (!answers)
        return complain(EXIT_IO, "out of memory");
    graze_draw_options what = {.title = golden, .size = sizeof what};
    take_answers(answers, m.count, c);
    marks_give(&what, &m);
    what.answers = answers;
    return complain_of_use(graze_draw(l->context, l->scene, file, &what), l->context);
}

int compare_page(const char *file, const char *golden, const char *candidate,
                 const graze_compare_options *options, const context_options *context) {
    graze_compare_options all = *options;
    graze_context *comparing = NULL;
    graze_comparison *c = NULL;
    loaded l = {.scene = NULL};
    scene_options scene = {.solid = options->solid, .motion = options->motion};
    all.show = SIZE_MAX;
    int status = context_make(&comparing, context);
    if (!status)
        status = complain_of(graze_compare(&c, comparing, golden, candidate, &all), comparing);
    if (!status) {
        take_scene_options(&scene, graze_comparison_head(c));
        memcpy(scene.context.limits, context->limits, sizeof scene.context.limits);
        status = loaded_read(&l, &scene, EXIT_INPUT, NULL);
    }
    if (!status)
        status = draw_compared(file, &l, golden, c);
    loaded_clear(&l);
    graze_comparison_destroy(c);
    graze_context_destroy(comparing);
    return status;
}
