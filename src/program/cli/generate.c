/* graze generate: query points, most of them degenerate by construction.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "program/cli/cli.h"

#include "base/context/scope.h"
#include "program/cli/values.h"
#include "program/io/io.h"
#include "program/points/points.h"

static const char generate_help[] =
    "graze generate SOLID MOTION -n N --seed K: query points, most of them degenerate\n"
    "\n"
    "Example: graze generate cube.off move.json -n 1000 --seed 1 -o points.csv\n"
    "         graze generate cube.off move.json -n 9 --seed 1 --representable binary64\n"
    "\n"
    "A point is P = M(t) y with y on the boundary and t rational, so that its trajectory is at y\n"
    "at the time t. Columns: the point, id (its row), stratum, order of the contact (slide: in\n"
    "the facet's plane for good), cell of y, time t, and for displaced points k and side: by\n"
    "2^-k along the normal, out or in. The same seed gives the same bytes everywhere. A curved\n"
    "solid needs a box; its faces are those of its primitives, edges where two of their surfaces\n"
    "meet, vertices where more do, apexes, and points where surfaces touch; points whose pmc is\n"
    "undecided are left out.\n"
    "\n"
    "  -n N                 how many points (needed)\n"
    "  --seed K             any whole number (needed)\n"
    "  -o, --output FILE    write there instead of to standard output\n"
    "  --representable binary64     keep to points whose coordinates a double holds; strata of "
    "which\n"
    "                       a motion with other numbers than dyadic ones has none give their\n"
    "                       weight to rounded\n"
    "  --strata NAME=W,...  these strata only, with these weights: random, near, face, face-odd,\n"
    "                       edge, vertex, crossing, start, end, break, slide, miss, level\n"
    "                       (not without its name): beside a contact, |signed distance| proved to\n"
    "                       be in a decade, from the inradius to 1e-9 of the diagonal, in and\n"
    "                       out; a decade of which none is found stands in the head; rounded (not\n"
    "                       without its name): a contact's coordinates replaced by doubles next "
    "to\n"
    "                       them, named after its stratum, as rounded-edge, with the exact answer\n"
    "                       as side\n"
    "  --coordinates exact|decimal  of the points: integers and ratios (default), or finite\n"
    "                       decimals, which all points that a double holds have\n"
    "  --digits N           round these to N digits where they are longer\n"
    "  --plain              names and rows alone, no lines that begin with #\n"
    "  --round, --triangulate, --overlap, --operation, --limit, --quiet   as in graze classify\n"
    "\n"
    "Strata that the scene cannot have are named in the head of the table; their weight goes to\n"
    "the others. No two points are equal; a stratum without other points is named on standard\n"
    "error.\n";

static const option_entry generate_table[] = {
    OPTION("n", generate_options, count, value_count),
    OPTION("seed", generate_options, seed, value_seed),
    OPTION("strata", generate_options, strata, value_text),
    OPTION("representable", generate_options, representable, value_binary64),
    OPTION("coordinates", generate_options, coordinates.form, value_coordinates),
    OPTION("digits", generate_options, coordinates.digits, value_digits),
    FLAG("plain", generate_options, plain, value_flag),
    OUTPUT(generate_options, output, value_output),
    SCENE_OPTIONS(generate_options, scene),
    OPTION("operation", generate_options, scene.scene.operation, value_operation),
    FLAG("quiet", generate_options, quiet, value_quiet),
    OPTIONS_END};

static int run_generate(void *options, const operands *given) {
    generate_options *o = options;
    if (given->count != 2 || !o->count || !o->seed.given)
        return complain(EXIT_USAGE, "generate takes SOLID, MOTION, -n N and --seed K; see graze "
                                    "generate --help");
    if (o->coordinates.form == COORDINATES_AS_GIVEN)
        return complain(EXIT_USAGE, "--coordinates as-given: expected exact or decimal; points "
                                    "that are made are not given");
    TRY(coordinates_check(&o->coordinates));
    scene_files(&o->scene, given);
    return generate_run(NULL, o);
}

COMMAND(generate, generate_options, .reads = 2);
