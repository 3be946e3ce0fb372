/* graze check: is a pair of solid and motion legal.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>
#include "cli/cli.h"
#include "cli/output.h"
#include "cli/receipt.h"

static const char help[] =
    "graze check SOLID MOTION: is the pair legal, and why not\n"
    "\n"
    "Reads both, checks them exactly, and says what they are. Exit status 0: legal; 1: readable\n"
    "but illegal, the reason on standard error; 3: unreadable.\n"
    "\n"
    "  --triangulate        fan facets that are not planar from their first vertex\n"
    "  --overlap extend     S^0 and S^1 may meet (default)\n"
    "  --overlap reject     they may not, as [EI] assumes\n"
    "  --operation sweep|unsweep   in an unsweep S^0 and S^1 may always meet\n"
    "  --round none|binary64|binary32   round every number read to the nearest such float\n"
    "  --receipt FILE       write a receipt there if they are legal, for graze classify --receipt\n"
    "  --limit NAME=V       digits 10000, degree 200, pieces 10000, depth 100, line 10^7,\n"
    "                       cells 10^8, bytes 4*10^9, bits 100000\n"
    "\n"
    "Example: graze check cube.off move.json\n";

static output out;

static const char *plural(size_t count, const char *one, const char *many) {
    return count == 1 ? one : many;
}

static int report(const loaded *l) {
    int d = graze_scene_dimension(l->scene), status = output_open(&out, NULL);
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
    output_put(&out, text);
    return status ? status : output_close(&out);
}

static int run(const options *o) {
    if (o->operand_count != 2)
        return complain(EXIT_USAGE,
                        "check takes SOLID and MOTION, %d given; see graze check --help",
                        o->operand_count);
    loaded l;
    int status = load(&l, o, EXIT_NO, NULL);
    if (!status && o->receipt)
        status = receipt_write(&l, o);
    if (!status)
        status = report(&l);
    unload(&l);
    return status;
}

const command command_check = {"check", "rltvpY", help, run};
