/* graze envelope: events of the envelope.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "program/cli/cli.h"

#include "program/cli/values.h"
#include "program/io/io.h"

static const char envelope_help[] =
    "graze envelope SOLID MOTION: when the contact of the moving solid with its envelope changes\n"
    "\n"
    "Example: graze envelope cube.off turn.json\n"
    "         graze envelope cube.off turn.json --events events.csv -n 100 --points contacts.csv\n"
    "\n"
    "At a time the contact points are a slice of each facet, where the boundary's speed along its\n"
    "normal is 0, and runs on convex edges. Prints how many events there are of each kind, and\n"
    "whether the envelope is decomposable, yes, no or undecided, and why: whether every contact\n"
    "point stays away in time from the solid's interior.\n"
    "\n"
    "  --events FILE        a table of all events, with exact times: time,time_near,kind,facet,\n"
    "                       cell,before,after; kinds are saddle, reach, meet, cusp, turn, "
    "singular\n"
    "  --at T,... --curve FILE   the contact points at times within the motion: slices, runs, "
    "points\n"
    "                       and whole facets with their ends, verdicts and chains\n"
    "  --patches FILE       facets, edges and vertices over the intervals in which they carry "
    "contact,\n"
    "                       with a sample of each; --joints FILE   which of them meet, where and "
    "when\n"
    "  -n N --points FILE   N contact points spread over the motion, as rows of graze contact;\n"
    "  --seed K             their seed (1)\n"
    "  -o, --output FILE    write there instead of to standard output\n"
    "  --operation sweep    the one that has an envelope; unsweep is refused\n"
    "  --round, --triangulate, --overlap, --limit NAME=V   as in graze classify\n";

typedef struct envelope_given {
    envelope_options run;
    seed_value seed;
} envelope_given;

static const option_entry envelope_table[] = {
    FILE_WRITTEN("events", envelope_given, run.events),
    OPTION("at", envelope_given, run.at, value_text),
    FILE_WRITTEN("curve", envelope_given, run.curve),
    FILE_WRITTEN("patches", envelope_given, run.patches),
    FILE_WRITTEN("joints", envelope_given, run.joints),
    OPTION("n", envelope_given, run.count, value_count),
    OPTION("seed", envelope_given, seed, value_seed),
    FILE_WRITTEN("points", envelope_given, run.points),
    OPTION("operation", envelope_given, run.scene.scene.operation, value_operation),
    OPTION("round", envelope_given, run.scene.context.rounding, value_rounding),
    FLAG("triangulate", envelope_given, run.scene.solid_flags, value_triangulate),
    OPTION("overlap", envelope_given, run.scene.scene.overlap, value_overlap),
    OPTION("limit", envelope_given, run.scene.context.limits, value_limit),
    {NULL, OPTION_FLAG, NULL, 0}};

static int run_envelope(void *options, const operands *given) {
    envelope_given *o = options;
    if (given->count != 2)
        return complain(EXIT_USAGE,
                        "envelope takes SOLID and MOTION, %d operands given; see graze envelope "
                        "--help",
                        given->count);
    o->run.scene.solid = given->item[0];
    o->run.scene.motion = given->item[1];
    o->run.seed = o->seed.given ? o->seed.seed : 1;
    return envelope_run(&o->run);
}

const command command_envelope = {.name = "envelope",
                                  .options = envelope_table,
                                  .size = sizeof(envelope_given),
                                  .reads = 2,
                                  .help = envelope_help,
                                  .run = run_envelope};
