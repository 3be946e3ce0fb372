/* graze explain: the whole reasoning for one point.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>
#include "cli/cli.h"
#include "cli/output.h"

static const char help[] =
    "graze explain SOLID MOTION X Y [Z]: the whole reasoning for one point\n"
    "\n"
    "Says where the point is at the ends of the motion, its inverted trajectory, each contact\n"
    "with the boundary in order of time and why it counts as what it does, the counts, and the\n"
    "definition and case that apply. Numbers: -12, 0.1, 1.5e-3, 22/7, all exact.\n"
    "\n"
    "  --triangulate, --round, --overlap extend|reject, --limit NAME=V,\n"
    "  --no-filter          as in graze classify\n"
    "  --folds separate     Definitions 6 and 7 (default)\n"
    "  --folds combined     Definitions 10 and 11 in their place\n"
    "  --operation sweep    the set swept by the solid (default)\n"
    "  --operation unsweep  the points that stay in the solid\n"
    "\n"
    "Example: graze explain cube.off move.json 1/2 -1 0.25\n";

static output out;

static int explain(const loaded *l, const mpq_t *point) {
    graze_trace *trace = NULL;
    char *text = NULL;
    graze_status status = graze_trace_create(&trace, l->context, l->scene, point);
    if (!status)
        status = graze_report_explain(&text, l->context, l->scene, point, trace);
    int code = complain_of(status, l->context);
    if (!status)
        code = output_open(&out, NULL);
    if (!code) {
        output_put(&out, text);
        code = output_close(&out);
    }
    graze_free(text);
    graze_trace_destroy(trace);
    return code;
}

/* The coordinates from the command line. */
static int read_point(mpq_t *point, const loaded *l, const options *o) {
    static const char *const names[] = {"X", "Y", "Z"};
    int d = graze_scene_dimension(l->scene);
    if (o->operand_count != 2 + d)
        return complain(EXIT_USAGE, "the scene has dimension %d: right is SOLID MOTION %s", d,
                        d == 2 ? "X Y" : "X Y Z");
    for (int k = 0; k < d; k++) {
        const char *word = o->operands[2 + k];
        graze_status status = graze_number_parse(point[k], l->context, word, strlen(word));
        if (status)
            return complain(exit_for(status, EXIT_USAGE), "%s: %s", names[k],
                            graze_context_message(l->context));
    }
    return EXIT_DONE;
}

static int run(const options *o) {
    if (o->operand_count < 4 || o->operand_count > 5)
        return complain(EXIT_USAGE,
                        "explain takes SOLID, MOTION and 2 or 3 coordinates, %d operands given; "
                        "see graze explain --help",
                        o->operand_count);
    loaded l;
    mpq_t point[3];
    for (int k = 0; k < 3; k++)
        mpq_init(point[k]);
    int status = load(&l, o, EXIT_INPUT, NULL);
    if (!status)
        status = read_point(point, &l, o);
    if (!status)
        status = explain(&l, point);
    for (int k = 0; k < 3; k++)
        mpq_clear(point[k]);
    unload(&l);
    return status;
}

const command command_explain = {"explain", "rltvfpx", help, run};
