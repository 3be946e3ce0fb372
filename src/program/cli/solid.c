/* graze solid: tools and simple bodies as polyhedra.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "program/cli/cli.h"

#include <stdio.h>
#include <string.h>
#include "program/cli/values.h"
#include "program/io/io.h"

static const char solid_help[] =
    "graze solid KIND ...: a tool or a simple body: a polyhedron as OFF, or exactly\n"
    "\n"
    "Example: graze solid box --size 2,2,2 -o cube.off\n"
    "         graze solid cutter --diameter 6 --corner 3 --length 20 --outside ball-end.off\n"
    "\n"
    "  cutter --diameter D --length L [--corner R] [--taper A]   a milling tool: its tip is the\n"
    "                       origin, its axis z; R = D/2 is a ball end; A degrees between side and\n"
    "                       axis, positive where it is wider above; D where the corner is widest\n"
    "  cylinder --diameter D --length L   about the z axis, from z = 0 up\n"
    "  ball --diameter D    on the plane z = 0, above the origin\n"
    "  box --size X,Y,Z     from the origin up; exact\n"
    "\n"
    "  -o, --output FILE    write there instead of to standard output\n"
    "  --at X,Y,Z           moved by this\n"
    "  --exact              the body itself as .csg.json, no polyhedron\n"
    "  --tolerance E        no point of the surface is further from the true one (D/200)\n"
    "  --inside FILE        the polyhedron that is a part of the body, as -o\n"
    "  --outside FILE       the one that the body is a part of; with --inside both\n"
    "  --limit NAME=V       cells 100000000, digits 10000\n"
    "\n"
    "Both are convex, and proved to be within E; standard error has the error.\n";

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
    {NULL, OPTION_FLAG, NULL, 0}};

/* The kinds, the options each has a use for, and those it needs. */
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

/* The numbers of options, three for each. */
static int read_shape_numbers(mpq_t number[OWN][3], graze_context *context,
                              const char *const *own) {
    int status = EXIT_DONE;
    for (int k = 0; k < OWN && !status; k++)
        if (own[k])
            status = numbers_read(number[k], context, solid_table[k].name, own[k], strlen(own[k]),
                                  k == SIZE || k == AT ? 3 : 1);
    return status;
}

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
    int status = EXIT_DONE;
    waiting_clear();
    fputs(report, stderr);
    if (o->output || o->inside || !o->outside)
        status = output_text(o->output ? o->output : o->inside, inside);
    return !status && o->outside ? output_text(o->outside, outside) : status;
}

static int make_shape(const solid_options *o, graze_context *context, int kind) {
    mpq_t number[OWN][3];
    char *inside = NULL, *outside = NULL, *report = NULL;
    for (int k = 0; k < OWN; k++)
        mpq_inits(number[k][0], number[k][1], number[k][2], NULL);
    int status = read_shape_numbers(number, context, o->own);
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
    graze_status made = GRAZE_OK;
    if (!status && o->exact)
        made = graze_solid_write_exact_shape(&inside, &report, context, &shape);
    else if (!status)
        made = graze_solid_write_shape(&inside, &outside, &report, context, &shape,
                                       number[TOLERANCE][0]);
    if (!status)
        status = complain_of_use(made, context);
    if (!status)
        status = write_solid(o, inside, outside, report);
    graze_free(inside);
    graze_free(outside);
    graze_free(report);
    for (int k = 0; k < OWN; k++)
        mpq_clears(number[k][0], number[k][1], number[k][2], NULL);
    return status;
}

static int run_solid(void *options, const operands *given) {
    const solid_options *o = options;
    graze_context *context = NULL;
    int kind = 0;
    while (kind < KINDS && (given->count != 1 || strcmp(given->item[0], kinds[kind].name) != 0))
        kind++;
    if (kind == KINDS)
        return complain(EXIT_USAGE,
                        "solid takes box, ball, cylinder or cutter; see graze solid --help");
    int status = check_own(kind, o->own);
    if (!status && o->exact && (o->own[TOLERANCE] || o->inside || o->outside))
        status = complain(EXIT_USAGE, "--exact writes no polyhedron: it takes no --tolerance, "
                                      "--inside or --outside");
    if (!status && o->output && o->inside)
        status = complain(EXIT_USAGE, "--output and --inside name one file; expected one of them");
    if (!status)
        status = context_make(&context, &o->context);
    if (!status)
        status = make_shape(o, context, kind);
    graze_context_destroy(context);
    graze_thread_finish();
    return status;
}

const command command_solid = {.name = "solid",
                               .options = solid_table,
                               .size = sizeof(solid_options),
                               .help = solid_help,
                               .run = run_solid};
