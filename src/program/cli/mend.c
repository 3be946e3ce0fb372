/* graze mend: makes a legal solid from a mesh that is not one.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "program/cli/cli.h"

#include <string.h>
#include <strings.h>
#include "base/context/scope.h"
#include "program/cli/values.h"
#include "program/io/io.h"

static const char mend_help[] =
    "graze mend SOLID -o FILE.off: a legal solid out of a mesh that is none\n"
    "\n"
    "Example: graze mend part.stl -o part.off\n"
    "         graze mend part.stl --weld 1e-6 -o part.off\n"
    "\n"
    "Reads a mesh in .off, .obj, .ply or .stl and takes the steps that move no point: equal\n"
    "vertices become one, facets without area go, edges are split at vertices in their middle\n"
    "(T-junctions), and where the mesh is not legal yet, facets are turned so that shells face\n"
    "outward and cavities inward. Each thing that was done is a line on standard output. The\n"
    "result is validated and then written, cut into triangles.\n"
    "Holes, facets that cross or lie on one another and surfaces with one side are not mended.\n"
    "Exit status 0: the solid is written; 1: it is not legal after that, and what is left is on\n"
    "standard error.\n"
    "\n"
    "  -o, --output FILE    the file to write (needed), not SOLID itself\n"
    "  --weld EPS           make vertices one that lie within EPS, in units of the file; this\n"
    "                       changes the solid: a line says by how much at most, which graze\n"
    "                       classify and compare take as an error of the motion\n"
    "  --triangulate, --round binary64|binary32, --limit NAME=V   as in graze classify\n";

typedef struct mend_options {
    const char *output;
    const char *weld;
    unsigned solid_flags;
    context_options context;
} mend_options;

static const option_entry mend_table[] = {SOLID_OPTIONS(mend_options, solid_flags, context),
                                          OPTION("weld", mend_options, weld, value_positive),
                                          OUTPUT(mend_options, output, value_text), OPTIONS_END};

static int mend_file(const mend_options *o, graze_context *context, const char *path) {
    FREED(char, text, NULL);
    FREED(char, report, NULL);
    HELD(rationals, weld, 1);
    TRY(numbers_given(weld.at, context, "--weld", o->weld, 1));
    graze_status made = graze_solid_mend(&text, &report, context, path, o->weld ? weld.at[0] : NULL,
                                         o->solid_flags);
    int status = complain_of(made, context);
    if (made == GRAZE_EILLEGAL)
        status = EXIT_NO;
    if (report && (*report || !made))
        TRY(output_text(NULL, *report ? report : "nothing to mend\n"));
    return text && !status ? output_text(o->output, text) : status;
}

static int run_mend(void *options, const operands *given) {
    mend_options *o = options;
    OWNED(graze_context, context);
    if (given->count != 1 || !o->output)
        return complain(EXIT_USAGE, "mend takes SOLID and -o FILE; see graze mend --help");
    o->output = output_name(o->output, "-.off");
    size_t length = strlen(o->output);
    if (length < 5 || strcasecmp(o->output + length - 4, ".off") != 0)
        return complain(EXIT_USAGE, "--output %s: expected a name that ends in .off", o->output);
    TRY(context_make(&context, &o->context));
    return mend_file(o, context, given->item[0]);
}

COMMAND(mend, mend_options, .reads = 1);
