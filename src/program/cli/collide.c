/* graze collide: a moving solid against a fixed one.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "program/cli/cli.h"

#include <string.h>
#include "base/context/scope.h"
#include "program/cli/values.h"
#include "program/io/io.h"

static const char collide_help[] =
    "graze collide MOVING MOTION FIXED: does a moving solid meet a fixed one, when, with what\n"
    "\n"
    "Example: graze solid box --size 2,2,2 --at 9,0,0 -o post.off\n"
    "         graze collide cube.off move.json post.off\n"
    "         graze collide cube.off move.json post.off --first --format json\n"
    "\n"
    "Prints `clear`, `touch` or `overlap`, and the pair word: a letter for each state in order of\n"
    "time, O apart, B only the boundaries meet, I the interiors meet. Then each contact, a time "
    "or\n"
    "an interval of B, exactly, with all pairs of cells that meet when it begins.\n"
    "Exit status: 0 clear, 1 touch, overlap or, with --first, meets.\n"
    "\n"
    "Both are polyhedra or polygons, or balls and capsules of a .csg.json or .csg and unions of "
    "them.\n"
    "\n"
    "  --first              stop just after the first contact begins, which is much cheaper:\n"
    "                       `clear`, `overlap` from the start or `meets`; the word: OBI, OBO,\n"
    "                       or OB where the contact lasts or the motion ends\n"
    "  --clearance R        letters tell the distance: O above R, B at R, I below R; cells are "
    "those\n"
    "                       with points at distance R. Both keep R >= 0 apart (default 0: as "
    "above)\n"
    "  --closest TOL        also the least distance, between two numbers at most TOL apart (1e-10, "
    "or\n"
    "                       1e-10r of both sizes; else `wide`), with a time and a point of each\n"
    "  --ask any|overlap    what exit status 1 tells: touch or overlap (default), overlap alone\n"
    "  --inside             does MOVING stay inside FIXED? `inside`, `inside, touching`, or when "
    "it\n"
    "                       leaves; the word is that with the closed complement of FIXED. With\n"
    "                       --first also `touches at` a time, and what follows\n"
    "  --motion-of-fixed MOTION   FIXED moves too; times are those that both motions have\n"
    "  --format text|json   json: one object, with all pairs of cells and exact times\n"
    "  -o, --output FILE    write there instead of to standard output\n"
    "  --triangulate, --round, --limit NAME=V   as in graze classify\n";

typedef struct collide_given {
    context_options context;
    unsigned solid_flags;
    graze_pair_options pair;
    int overlap_alone;
    graze_comparison_format format; /* as in graze compare */
    const char *motion_of_fixed;
    const char *clearance; /* NULL: 0 */
} collide_given;

static option_read value_ask;
VALUE_OF_WORDS(value_ask, int, "any", "overlap")

static const option_entry collide_table[] = {
    FLAG("first", collide_given, pair.first, value_flag),
    OPTION("ask", collide_given, overlap_alone, value_ask),
    FLAG("inside", collide_given, pair.question, value_flag),
    OPTION("closest", collide_given, pair, value_closest),
    OPTION("clearance", collide_given, clearance, value_width),
    FILE_READ("motion-of-fixed", collide_given, motion_of_fixed),
    OPTION("format", collide_given, format, value_report),
    SOLID_OPTIONS(collide_given, solid_flags, context),
    OPTIONS_END};

static int read_side(graze_solid **out, graze_context *context, const char *path, unsigned flags) {
    return complain_of(graze_solid_read(out, context, path, flags), context);
}

static int print_pair(graze_context *context, const graze_pair *pair, int json) {
    FREED(char, written, NULL);
    TRY(complain_of(json ? graze_pair_json(&written, context, pair)
                         : graze_pair_text(&written, context, pair),
                    context));
    return output_text(NULL, written);
}

static int run_collide(void *given_options, const operands *given) {
    const collide_given *o = given_options;
    char **file = given->item;
    if (o->pair.first && o->overlap_alone)
        return complain(EXIT_USAGE, "--first ends before an overlap is known; expected --first or "
                                    "--ask overlap");
    if (o->pair.closest > 0 && (o->pair.first || o->overlap_alone || o->pair.question))
        return complain(EXIT_USAGE, "--closest looks at the whole motion of one solid outside the "
                                    "other; expected no --first, --ask overlap or --inside");
    OWNED(graze_context, context);
    OWNED(graze_solid, moving);
    OWNED(graze_solid, fixed);
    OWNED(graze_motion, motion);
    OWNED(graze_motion, motion_of_fixed);
    OWNED(graze_pair, pair);
    TRY(context_make(&context, &o->context));
    TRY(read_side(&moving, context, file[0], o->solid_flags));
    TRY(complain_of(graze_motion_read(&motion, context, file[1]), context));
    TRY(read_side(&fixed, context, file[2], o->solid_flags));
    if (o->motion_of_fixed)
        TRY(complain_of(graze_motion_read(&motion_of_fixed, context, o->motion_of_fixed), context));
    LOCAL(mpq, clearance);
    graze_pair_options options = o->pair;
    options.size = sizeof options;
    if (o->clearance)
        TRY(complain_of(graze_number_parse(clearance, context, o->clearance, strlen(o->clearance)),
                        context));
    options.clearance = clearance;
    TRY(complain_of(
        graze_pair_create(&pair, context, moving, motion, fixed, motion_of_fixed, &options),
        context));
    TRY(print_pair(context, pair, o->format == GRAZE_COMPARISON_JSON));
    graze_pair_verdict least = o->overlap_alone ? GRAZE_PAIR_OVERLAP : GRAZE_PAIR_TOUCH;
    return graze_pair_get_verdict(pair) >= least ? EXIT_NO : EXIT_DONE;
}

COMMAND(collide, collide_given, .takes = "MOVING, MOTION and FIXED", .least = 3, .reads = 3);
