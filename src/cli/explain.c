/* graze explain: the whole reasoning for one point.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>
#include "cli/commands.h"
#include "cli/values.h"
#include "run/load.h"
#include "run/output.h"

static const char explain_help[] =
    "graze explain SOLID MOTION X Y [Z]: the whole reasoning for one point\n"
    "\n"
    "Gives the position of the point at the ends of the motion, its inverted trajectory, each\n"
    "contact with the boundary in order of time and why it is an intersection or a tangency, the\n"
    "counts, and the definition and case that apply. Numbers: -12, 0.1, 1.5e-3, 22/7, all exact.\n"
    "\n"
    "  --triangulate, --round, --overlap extend|reject, --limit NAME=V,\n"
    "  --no-filter          as in graze classify\n"
    "  --folds separate     Definitions 6 and 7 (default)\n"
    "  --folds combined     Definitions 10 and 11 in their place\n"
    "  --sdf TOL            the signed distance too, as in graze classify\n"
    "  --topo               the position relative to the closed sweep too\n"
    "  --operation sweep    the set swept by the solid (default)\n"
    "  --operation unsweep  the points that stay in the solid\n"
    "\n"
    "Example: graze explain cube.off move.json 1/2 -1 0.25\n";

static int explain_point(const loaded *l, graze_rationals point) {
    graze_trace *trace = NULL;
    char *text = NULL;
    graze_status status = graze_trace_create(&trace, l->context, l->scene, point);
    if (!status)
        status = graze_report_explain(&text, l->context, l->scene, point, trace);
    int code = complain_of(status, l->context);
    if (!code)
        code = output_text(NULL, text);
    graze_free(text);
    graze_trace_destroy(trace);
    return code;
}

/* The coordinates from the command line. */
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
    FLAG("triangulate", scene_options, solid_flags, value_triangulate),
    OPTION("round", scene_options, context.rounding, value_rounding),
    OPTION("overlap", scene_options, scene.overlap, value_overlap),
    OPTION("limit", scene_options, context.limits, value_limit),
    FLAG("no-filter", scene_options, context.exact_only, value_flag),
    OPTION("folds", scene_options, scene.folds, value_folds),
    OPTION("operation", scene_options, scene.operation, value_operation),
    OPTION("sdf", scene_options, scene, value_sdf),
    FLAG("topo", scene_options, scene.topo, value_flag),
    {NULL, OPTION_FLAG, NULL, 0}};

static int run_explain(void *options, const operands *given) {
    scene_options *o = options;
    loaded l;
    mpq_t point[3];
    if (given->count < 4 || given->count > 5)
        return complain(EXIT_USAGE,
                        "explain takes SOLID, MOTION and 2 or 3 coordinates, %d operands given; "
                        "see graze explain --help",
                        given->count);
    o->scene.size = sizeof o->scene;
    o->solid = given->item[0];
    o->motion = given->item[1];
    mpq_inits(point[0], point[1], point[2], NULL);
    int status = loaded_read(&l, o, EXIT_INPUT, NULL);
    if (!status)
        status = read_coordinates(point, &l, given);
    if (!status)
        status = explain_point(&l, point);
    mpq_clears(point[0], point[1], point[2], NULL);
    loaded_clear(&l);
    return status;
}

const command command_explain = {.name = "explain",
                                 .options = explain_table,
                                 .size = sizeof(scene_options),
                                 .help = explain_help,
                                 .run = run_explain};
