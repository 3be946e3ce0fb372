/* graze generate: query points, most of them degenerate by construction.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "program/cli/values.h"

#include "base/context/scope.h"

HELP(generate);

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
