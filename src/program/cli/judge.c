/* graze judge: how far a mesh is from the boundary of a sweep.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <string.h>
#include "program/cli/commands.h"
#include "program/cli/values.h"
#include "program/run/load.h"
#include "program/run/output.h"

static const char judge_help[] =
    "graze judge SOLID MOTION MESH: how far is a mesh from the boundary of the sweep?\n"
    "\n"
    "MESH may be open, cross itself or have no orientation: what it lacks is reported. Then come,\n"
    "as proved bounds, the greatest distance of the mesh to the sweep (where it is outside), to\n"
    "the outside (where it is inside), and of the sweep's boundary to the mesh, each with a "
    "place;\n"
    "and the volumes.\n"
    "Exit status: 0 a report is made; with --fail-above 1 where a distance is certainly greater.\n"
    "\n"
    "  --within W         width of the distances' bounds (default 1e-2r); W or, of the diagonal\n"
    "                     of the solid's box, Wr\n"
    "  --budget N         ask about at most N cubes of space and points (default 10^7); the "
    "bounds\n"
    "                     are those that are known then\n"
    "  --fail-above X     exit status 1 if a distance is certainly greater than X\n"
    "  --format text|markdown|json\n"
    "  --triangulate, --round, --limit NAME=V   as in graze classify\n"
    "\n"
    "Example: graze judge tool.off motion.json swept.obj --within 1e-3r\n";

typedef struct judge_given {
    scene_options scene; /* rows.sdf is the width */
    unsigned long budget;
    const char *fail_above;
    int format;
} judge_given;

static int value_form(void *to, const char *name, const char *value) {
    static const char *const words[] = {"text", "markdown", "json"};
    return value_choice(to, name, value, words, 3);
}

static const option_entry judge_table[] = {
    OPTION("within", judge_given, scene, value_sdf),
    OPTION("budget", judge_given, budget, value_count),
    OPTION("fail-above", judge_given, fail_above, value_width),
    OPTION("format", judge_given, format, value_form),
    FLAG("triangulate", judge_given, scene.solid_flags, value_triangulate),
    OPTION("round", judge_given, scene.context.rounding, value_rounding),
    OPTION("limit", judge_given, scene.context.limits, value_limit),
    {NULL, OPTION_FLAG, NULL, 0}};

static int print_judgement(graze_context *context, const graze_judgement *judgement,
                           const judge_given *o) {
    char *report = NULL;
    int code = complain_of(
        graze_judgement_report(&report, context, judgement, (graze_judgement_format)o->format),
        context);
    if (!code)
        code = output_text(NULL, report);
    graze_free(report);
    return code;
}

/* Is a distance certainly more than allowed? The text was read as a number before. */
static int is_too_far(graze_context *context, const graze_judgement *judgement, const char *limit) {
    int far = 0;
    mpq_t most, low;
    mpq_inits(most, low, NULL);
    graze_status status = graze_number_parse(most, context, limit, strlen(limit));
    for (int k = 0; k < GRAZE_JUDGED_COUNT && !status; k++) {
        double least = graze_judgement_distance(judgement, (graze_judged)k).low;
        if (least <= DBL_MAX)
            mpq_set_d(low, least);
        far |= least > DBL_MAX || mpq_cmp(low, most) > 0;
    }
    mpq_clears(most, low, NULL);
    return far;
}

static int judge_mesh(const loaded *l, const judge_given *o, const char *path) {
    graze_mesh *mesh = NULL;
    graze_judgement *judgement = NULL;
    graze_judge_options options = {
        .size = sizeof options, .within = l->rows.sdf, .budget = o->budget};
    int code =
        complain_of(graze_mesh_read(&mesh, l->context, path, o->scene.solid_flags), l->context);
    if (!code)
        code =
            complain_of(graze_judge(&judgement, l->context, l->scene, mesh, &options), l->context);
    if (!code)
        code = print_judgement(l->context, judgement, o);
    if (!code && o->fail_above && is_too_far(l->context, judgement, o->fail_above))
        code = EXIT_NO;
    graze_judgement_destroy(judgement);
    graze_mesh_destroy(mesh);
    return code;
}

static int run_judge(void *options, const operands *given) {
    judge_given *o = options;
    loaded l;
    if (given->count != 3)
        return complain(EXIT_USAGE,
                        "judge takes SOLID, MOTION and MESH, %d operands given; see graze judge "
                        "--help",
                        given->count);
    o->scene.solid = given->item[0];
    o->scene.motion = given->item[1];
    if (!(o->scene.rows.sdf > 0)) {
        o->scene.rows.sdf = 1e-2;
        o->scene.sdf_relative = 1;
    }
    int code = loaded_read(&l, &o->scene, EXIT_INPUT, NULL);
    if (!code)
        code = judge_mesh(&l, o, given->item[2]);
    loaded_clear(&l);
    return code;
}

const command command_judge = {.name = "judge",
                               .options = judge_table,
                               .size = sizeof(judge_given),
                               .reads = 3,
                               .help = judge_help,
                               .run = run_judge};
