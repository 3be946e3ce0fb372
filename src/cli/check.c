/* graze check: is a pair of solid and motion legal.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>
#include "cli/commands.h"
#include "cli/values.h"
#include "run/output.h"
#include "run/receipt.h"

static const char check_help[] =
    "graze check SOLID MOTION: is the pair legal, and why not\n"
    "\n"
    "Reads both, checks them exactly, and describes them. Exit status 0: legal; 1: readable\n"
    "but illegal, the reason on standard error; 3: unreadable.\n"
    "\n"
    "  --triangulate        fan facets that are not planar from their first vertex\n"
    "  --overlap extend     S^0 and S^1 may meet (default)\n"
    "  --overlap reject     they may not, as [EI] assumes\n"
    "  --operation sweep|unsweep   in an unsweep S^0 and S^1 may always meet\n"
    "  --round none|binary64|binary32   round every number read to the nearest such float\n"
    "  --receipt FILE       write a receipt there if they are legal, for graze classify --receipt\n"
    "  --limit NAME=V       digits 10000, degree 200, pieces 10000, depth 100, line 10^7,\n"
    "                       cells 10^8, bytes 4*10^9, bits 100000, work 10^8\n"
    "\n"
    "Example: graze check cube.off move.json\n";

static const char *plural(size_t count, const char *one, const char *many) {
    return count == 1 ? one : many;
}

static int describe_scene(const loaded *l) {
    int d = graze_scene_dimension(l->scene);
    size_t vertices = graze_solid_vertex_count(l->solid);
    size_t facets = graze_solid_facet_count(l->solid);
    size_t components = graze_solid_component_count(l->solid);
    size_t pieces = graze_motion_piece_count(l->motion);
    char text[512];
    snprintf(text, sizeof text,
             "legal\n"
             "dimension %d\n"
             "solid: %zu vertices, %zu %s, %zu %s of the boundary\n"
             "motion: %zu %s\n"
             "S^0 and S^1 %s\n",
             d, vertices, facets, d == 2 ? "edges" : "facets", components,
             plural(components, "component", "components"), pieces,
             plural(pieces, "piece", "pieces"),
             graze_scene_ends_meet(l->scene) ? "meet" : "do not meet");
    return output_text(NULL, text);
}

typedef struct check_options {
    scene_options scene;
    const char *receipt; /* to write, or NULL */
} check_options;

static const option_entry check_table[] = {
    FLAG("triangulate", check_options, scene.solid_flags, value_triangulate),
    OPTION("overlap", check_options, scene.scene.overlap, value_overlap),
    OPTION("operation", check_options, scene.scene.operation, value_operation),
    OPTION("round", check_options, scene.context.rounding, value_rounding),
    OPTION("receipt", check_options, receipt, value_text),
    OPTION("limit", check_options, scene.context.limits, value_limit),
    {NULL, OPTION_FLAG, NULL, 0}};

static int run_check(void *options, const operands *given) {
    check_options *o = options;
    loaded l;
    if (given->count != 2)
        return complain(EXIT_USAGE,
                        "check takes SOLID and MOTION, %d given; see graze check --help",
                        given->count);
    o->scene.solid = given->item[0];
    o->scene.motion = given->item[1];
    int status = loaded_read(&l, &o->scene, EXIT_NO, NULL);
    if (!status && o->receipt)
        status = receipt_write(o->receipt, &l, &o->scene);
    if (!status)
        status = describe_scene(&l);
    loaded_clear(&l);
    return status;
}

const command command_check = {.name = "check",
                               .options = check_table,
                               .size = sizeof(check_options),
                               .help = check_help,
                               .run = run_check};
