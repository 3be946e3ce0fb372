/* graze solid: tools and simple bodies as polyhedra.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "program/cli/values.h"

#include <stdio.h>
#include "base/context/scope.h"

HELP(solid);

enum { DIAMETER, LENGTH, CORNER, TAPER, TOLERANCE, SIZE, AT, OWN };

typedef struct solid_options {
    context_options context;
    const char *own[OWN]; /* NULL: not given */
    const char *output, *inside, *outside;
    int exact;
} solid_options;

static const option_entry solid_table[] = {
    [DIAMETER] = OPTION("diameter", solid_options, own[DIAMETER], value_text),
    [LENGTH] = OPTION("length", solid_options, own[LENGTH], value_text),
    [CORNER] = OPTION("corner", solid_options, own[CORNER], value_text),
    [TAPER] = OPTION("taper", solid_options, own[TAPER], value_text),
    [TOLERANCE] = OPTION("tolerance", solid_options, own[TOLERANCE], value_text),
    [SIZE] = OPTION("size", solid_options, own[SIZE], value_text),
    [AT] = OPTION("at", solid_options, own[AT], value_text),
    [OWN] = OUTPUT(solid_options, output, value_text),
    FILE_WRITTEN("inside", solid_options, inside),
    FILE_WRITTEN("outside", solid_options, outside),
    FLAG("exact", solid_options, exact, value_flag),
    OPTION("limit", solid_options, context.limits, value_limit),
    OPTIONS_END};

/* The kinds of solids, the options that each kind takes, and those that it needs. */
static const struct {
    const char *name;
    graze_shape_kind kind;
    unsigned taken, needed;
} kinds[] = {{"box", GRAZE_SHAPE_BOX, 1 << SIZE, 1 << SIZE},
             {"ball", GRAZE_SHAPE_BALL, 1 << DIAMETER | 1 << TOLERANCE, 1 << DIAMETER},
             {"cylinder", GRAZE_SHAPE_CYLINDER, 1 << DIAMETER | 1 << LENGTH | 1 << TOLERANCE,
              1 << DIAMETER | 1 << LENGTH},
             {"cutter", GRAZE_SHAPE_CUTTER,
              1 << DIAMETER | 1 << LENGTH | 1 << TOLERANCE | 1 << CORNER | 1 << TAPER,
              1 << DIAMETER | 1 << LENGTH}};
enum { KINDS = sizeof kinds / sizeof *kinds };

static int check_own(int kind, const char *const *own) {
    for (int k = 0; k < OWN; k++) {
        if (own[k] && k != AT && !(kinds[kind].taken >> k & 1))
            return complain(EXIT_USAGE, "%s takes no --%s; see graze solid --help",
                            kinds[kind].name, solid_table[k].name);
        if (!own[k] && kinds[kind].needed >> k & 1)
            return complain(EXIT_USAGE, "%s needs --%s; see graze solid --help", kinds[kind].name,
                            solid_table[k].name);
    }
    return EXIT_DONE;
}

static int write_solid(const solid_options *o, const char *inside, const char *outside,
                       const char *report) {
    waiting_clear();
    fputs(report, stderr);
    if (o->output || o->inside || !o->outside)
        TRY(output_text(o->output ? o->output : o->inside, inside));
    return o->outside ? output_text(o->outside, outside) : EXIT_DONE;
}

static int make_shape(const solid_options *o, graze_context *context, int kind) {
    HELD(rationals, given, 3 * OWN);
    mpq_t *number[OWN];
    FREED(char, inside, NULL);
    FREED(char, outside, NULL);
    FREED(char, report, NULL);
    for (int k = 0; k < OWN; k++) {
        number[k] = given.at + 3 * k;
        TRY(numbers_given(number[k], context, solid_table[k].name, o->own[k],
                          k == SIZE || k == AT ? 3 : 1));
    }
    if (!o->own[TOLERANCE]) {
        mpq_set_ui(number[TOLERANCE][1], 1, 200);
        mpq_mul(number[TOLERANCE][0], number[DIAMETER][0], number[TOLERANCE][1]);
    }
    graze_shape shape = {.kind = kinds[kind].kind,
                         .box = number[SIZE],
                         .diameter = number[DIAMETER][0],
                         .length = number[LENGTH][0],
                         .corner = number[CORNER][0],
                         .taper = number[TAPER][0],
                         .at = number[AT]};
    graze_status made = o->exact ? graze_solid_write_exact_shape(&inside, &report, context, &shape)
                                 : graze_solid_write_shape(&inside, &outside, &report, context,
                                                           &shape, number[TOLERANCE][0]);
    TRY(complain_of_use(made, context));
    return write_solid(o, inside, outside, report);
}

static int run_solid(void *options, const operands *given) {
    const solid_options *o = options;
    OWNED(graze_context, context);
    int kind = 0;
    while (kind < KINDS && (given->count != 1 || strcmp(given->item[0], kinds[kind].name) != 0))
        kind++;
    if (kind == KINDS)
        return complain(EXIT_USAGE,
                        "solid takes box, ball, cylinder or cutter; see graze solid --help");
    TRY(check_own(kind, o->own));
    if (o->exact && (o->own[TOLERANCE] || o->inside || o->outside))
        return complain(EXIT_USAGE, "--exact writes no polyhedron: it takes no --tolerance, "
                                    "--inside or --outside");
    if (o->output && o->inside)
        return complain(EXIT_USAGE, "--output and --inside name one file; expected one of them");
    TRY(context_make(&context, &o->context));
    return make_shape(o, context, kind);
}

COMMAND(solid, solid_options, .reads = 0);
