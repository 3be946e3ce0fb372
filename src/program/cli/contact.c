/* graze contact: contact points of the envelope.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "program/cli/cli.h"

#include "base/context/scope.h"
#include "program/cli/values.h"
#include "program/io/io.h"
#include "program/points/points.h"
#include "program/run/run.h"

static const char contact_help[] =
    "graze contact SOLID MOTION CONTACTS: boundary points at given times, and the envelope\n"
    "\n"
    "Example: graze envelope cube.off turn.json -n 100 --points contacts.csv\n"
    "         graze contact cube.off turn.json contacts.csv -o states.csv\n"
    "\n"
    "CONTACTS is a CSV file or - for standard input, with a line of names: time,bx,by[,bz] for a\n"
    "boundary point in the solid's own frame, or time,x,y[,z] for where it is then. Other\n"
    "columns are kept. A row says what the point is for the envelope at that time (role:\n"
    "contact, egress, ingress, hidden), order, curvature and orientation of a contact within a\n"
    "facet, the states of its trajectory before and after, whether the solid covers it at\n"
    "another time and when, the nearest times, and the word.\n"
    "\n"
    "  -o, --output FILE    write there instead of to standard output\n"
    "  --format csv|jsonl   a table (default; whole only with its last line # complete N), or a\n"
    "                       line of JSON per point with the values of each facet\n"
    "  --snap               move each point to the nearest one of its column cell (face 3, edge "
    "1-2,\n"
    "                       vertex 5) that is in contact then; column shift: squared distance\n"
    "  --jobs N             threads, at most one a core (default); any N gives the same output\n"
    "  --resume FILE        continue the table in FILE, if there is one, after its last whole row\n"
    "  --shard i/n          rows i, i + n, i + 2n, ... only; graze merge makes one table of them\n"
    "  --quiet              no progress on the terminal, and no notes\n"
    "  --round, --triangulate, --overlap, --no-filter, --limit NAME=V   as in graze classify\n";

static const option_entry contact_table[] = {
    FLAG("snap", classify_options, sites.snap, value_flag),
    OPTION("format", classify_options, scene.rows.format, value_rows),
    OPTION("jobs", classify_options, threads, value_jobs),
    OUTPUT(classify_options, output, value_output),
    FILE_WRITTEN("resume", classify_options, resume),
    OPTION("shard", classify_options, shard, value_shard),
    SCENE_OPTIONS(classify_options, scene),
    FLAG("no-filter", classify_options, scene.context.exact_only, value_flag),
    FLAG("quiet", classify_options, quiet, value_quiet),
    OPTIONS_END};

static int run_contact(void *options, const operands *given) {
    classify_options *o = options;
    TRY(classify_check_files(o));
    TRY(classify_check_table(o));
    scene_files(&o->scene, given);
    o->points = given->item[2];
    return classify_run(o);
}

static const classify_options whole_run = {.shard.part = {0, 1}, .sites.wanted = 1};

COMMAND(contact, classify_options, .initial = &whole_run, .takes = "SOLID, MOTION and CONTACTS",
        .least = 3, .reads = 3, .inputs = 1, .add_files = classify_add_record);
