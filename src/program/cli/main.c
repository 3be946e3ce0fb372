/* graze: chooses the command.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "program/cli/cli.h"

#include <stdio.h>
#include <string.h>
#include "base/context/spelling.h"
#include "program/cli/values.h"
#include "program/io/io.h"

static const command *const commands[] = {
    &command_check, &command_classify, &command_merge,    &command_explain, &command_generate,
    &command_cases, &command_compare,  &command_validate, &command_motion,  &command_boundary,
    &command_draw,  &command_certify,  &command_convert,  &command_contact, &command_envelope,
    &command_mend,  &command_solid,    &command_collide,  &command_judge,   &command_outline};
enum { COMMANDS = sizeof commands / sizeof *commands };

static const char overview[] =
    "graze: exact classification of points against a solid swept by a motion\n"
    "\n"
    "Example: graze solid box --size 2,2,2 -o cube.off\n"
    "         graze motion line --by 8,0,0 -o move.json\n"
    "         graze generate cube.off move.json -n 1000 --seed 1 -o points.csv\n"
    "         graze classify cube.off move.json points.csv -o table.csv\n"
    "\n"
    "  graze check SOLID [MOTION]           is it legal, and why not\n"
    "  graze classify SOLID MOTION POINTS   a table: in, on, out and class of each point\n"
    "  graze merge PART...                  one table of the parts that shards have written\n"
    "  graze explain SOLID MOTION X Y [Z]   the whole reasoning for one point\n"
    "  graze generate SOLID MOTION -n N --seed K   query points, most of them degenerate\n"
    "  graze compare GOLDEN CANDIDATE       a candidate's answers against a golden table\n"
    "  graze validate SOLID MOTION --candidate CMD   run a candidate and judge it\n"
    "  graze draw SOLID MOTION [POINTS] -o FILE.svg   a picture: classes, positions, trajectories\n"
    "  graze motion KIND ...                exact motion files from lines, angles, joints, poses\n"
    "  graze solid KIND ...                 a milling tool, cylinder, ball or box as OFF\n"
    "  graze boundary SOLID MOTION --depth N   the boundary by adaptive sampling\n"
    "  graze certify SOLID MOTION POINTS -o FILE   answers with proofs, for graze-check\n"
    "  graze convert SOLID|MOTION -o FILE   exact OFF or WKT, plain pieces: what graze-check "
    "reads\n"
    "  graze mend SOLID -o FILE.off         a legal solid out of a mesh that is none\n"
    "  graze contact SOLID MOTION CONTACTS  boundary points at given times, and the envelope\n"
    "  graze envelope SOLID MOTION          when the contact with the envelope changes\n"
    "  graze collide MOVING MOTION FIXED    do two solids meet, when first, with which cells\n"
    "  graze outline SOLID MOTION           the exact boundary in the plane: arcs, holes, area\n"
    "  graze judge SOLID MOTION MESH        how far a mesh is from the boundary of the sweep\n"
    "  graze cases                          the golden cases and what they show\n"
    "  graze COMMAND --help                 examples on these files, options; or graze help "
    "COMMAND\n"
    "  graze --version                      versions of graze and its libraries\n"
    "\n"
    "SOLID is .off .obj .ply .stl .nef3 (3D), .wkt (2D), .csg or .csg.json, MOTION is JSON,\n"
    "POINTS is CSV or -, standard input; as a FILE to write - is standard output.\n"
    "\n"
    "Exit status: 0 done, 1 the answer is no, 2 wrong usage, 3 bad input, 4 a fault of graze,\n"
    "5 reading or writing failed, or memory ran out, 6 a limit was met.\n";

/* The names of all commands, as `a, b or c`. */
static const char *command_names(void) {
    static char names[256];
    size_t used = 0;
    for (size_t k = 0; k < COMMANDS; k++) {
        const char *between = k == 0 ? "" : k + 1 < COMMANDS ? ", " : " or ";
        used +=
            (size_t)snprintf(names + used, sizeof names - used, "%s%s", between, commands[k]->name);
    }
    return names;
}

static int complain_of_command(const char *word) {
    const char *best = NULL;
    for (size_t k = 0; k < COMMANDS; k++)
        near_take(&best, word, commands[k]->name);
    near_take(&best, word, "--version");
    near_take(&best, word, "--help");
    return complain(EXIT_USAGE, "%s: expected a command: %s%s%s%s", word, command_names(),
                    best ? "; did you mean " : "", best ? best : "", best ? "?" : "");
}

/* Is the command line `graze help` alone? `graze help COMMAND` becomes `graze COMMAND --help`. */
static int is_help(int argc, char **argv) {
    static char option[] = "--help";
    if (strcmp(argv[1], "help") != 0)
        return 0;
    if (argc > 2) {
        argv[1] = argv[2];
        argv[2] = option;
    }
    return argc == 2;
}

int main(int argc, char **argv) {
    memory_guard();
    output_guard_standard();
    if (interrupt_watch() != 0)
        return complain(EXIT_IO, "signals cannot be watched");
    if (argc < 2)
        return complain(EXIT_USAGE, "a command is missing: %s; see graze --help", command_names());
    if (is_help(argc, argv) || strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0)
        return output_text(NULL, overview);
    if (strcmp(argv[1], "--version") == 0)
        return output_text(NULL, graze_version());
    for (size_t k = 0; k < COMMANDS; k++) {
        if (strcmp(argv[1], commands[k]->name) != 0)
            continue;
        int status = command_run(commands[k], argc - 1, argv + 1);
        if (status == EXIT_SIGNAL)
            interrupt_die();
        return status;
    }
    return complain_of_command(argv[1]);
}
