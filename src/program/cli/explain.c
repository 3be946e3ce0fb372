/* graze explain: the whole reasoning for one point.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "program/cli/values.h"

#include "base/context/scope.h"

HELP(explain);

typedef struct explain_given {
    scene_options scene;
    const char *picture; /* a file, or NULL */
} explain_given;

static int draw_point(const loaded *l, const char *file, graze_rationals point,
                      const graze_trace *trace) {
    graze_status status = graze_draw_cones(l->context, l->scene, file, point, trace);
    return status ? complain(exit_for(status, EXIT_USAGE), "--svg: %s", complaint_of(l->context))
                  : EXIT_DONE;
}

static int explain_point(const loaded *l, graze_rationals point, const char *picture) {
    OWNED(graze_trace, trace);
    FREED(char, text, NULL);
    TRY(complain_of(graze_trace_create(&trace, l->context, l->scene, point), l->context));
    TRY(complain_of(graze_report_explain(&text, l->context, l->scene, point, trace, &l->rows),
                    l->context));
    if (picture)
        TRY(draw_point(l, picture, point, trace));
    return output_text(NULL, text);
}

/* Read the coordinates from the command line. */
static int read_coordinates(mpq_t *point, const loaded *l, const operands *given) {
    static const char *const names[] = {"X", "Y", "Z"};
    int d = graze_scene_dimension(l->scene);
    if (given->count != 2 + d)
        return complain(EXIT_USAGE, "the scene has dimension %d: expected SOLID MOTION %s", d,
                        d == 2 ? "X Y" : "X Y Z");
    for (int k = 0; k < d; k++) {
        const char *word = given->item[2 + k];
        graze_status status = graze_number_parse(point[k], l->context, word, strlen(word));
        if (status)
            return complain(exit_for(status, EXIT_USAGE), "%s: %s", names[k],
                            graze_context_message(l->context));
    }
    return EXIT_DONE;
}

static const option_entry explain_table[] = {
    SCENE_OPTIONS(explain_given, scene),
    FLAG("no-filter", explain_given, scene.context.exact_only, value_flag),
    OPTION("folds", explain_given, scene.scene.folds, value_folds),
    OPTION("operation", explain_given, scene.scene.operation, value_operation),
    OPTION("sdf", explain_given, scene, value_sdf),
    FLAG("topo", explain_given, scene.rows.topo, value_flag),
    FLAG("regular", explain_given, scene.rows.regular, value_flag),
    FILE_WRITTEN("svg", explain_given, picture),
    OPTIONS_END};

static int run_explain(void *options, const operands *given) {
    explain_given *all = options;
    scene_options *o = &all->scene;
    ZEROED(loaded, l);
    HELD(rationals, point, 3);
    if (given->count < 4 || given->count > 5)
        return complain(EXIT_USAGE,
                        "explain takes SOLID, MOTION and 2 or 3 coordinates, each a word of its "
                        "own, as 1/2 -1 0.25; %d operands given; see graze explain --help",
                        given->count);
    all->picture = output_name(all->picture, "-.svg");
    scene_files(o, given);
    TRY(loaded_read(&l, o, EXIT_INPUT, NULL));
    if (all->picture)
        TRY(load_takes(l.solid, o->solid, "--svg", TAKES_POLYGONS));
    TRY(read_coordinates(point.at, &l, given));
    return explain_point(&l, (graze_rationals)point.at, all->picture);
}

COMMAND(explain, explain_given, .reads = 2);
