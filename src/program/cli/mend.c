/* graze mend: a legal solid out of a mesh that is none.
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

static const option_entry mend_table[] = {
    FLAG("triangulate", mend_options, solid_flags, value_triangulate),
    OPTION("round", mend_options, context.rounding, value_rounding),
    OPTION("limit", mend_options, context.limits, value_limit),
    OPTION("weld", mend_options, weld, value_positive),
    OUTPUT(mend_options, output, value_text),
    {NULL, OPTION_FLAG, NULL, 0}};

static int mend_file(const mend_options *o, graze_context *context, const char *path) {
    char *text = NULL, *report = NULL;
    LOCAL(mpq, weld);
    int status = o->weld ? numbers_read(&weld, context, "--weld", o->weld, strlen(o->weld), 1) : 0;
    graze_status made = GRAZE_EUSE;
    if (!status) {
        made =
            graze_solid_mend(&text, &report, context, path, o->weld ? weld : NULL, o->solid_flags);
        status = complain_of(made, context);
    }
    if (made == GRAZE_EILLEGAL)
        status = EXIT_NO;
    if (report && (*report || !made)) {
        int told = output_text(NULL, *report ? report : "nothing to mend\n");
        status = told ? told : status;
    }
    if (text && !status)
        status = output_text(o->output, text);
    graze_free(text);
    graze_free(report);
    return status;
}

static int run_mend(void *options, const operands *given) {
    mend_options *o = options;
    graze_context *context = NULL;
    if (given->count != 1 || !o->output)
        return complain(EXIT_USAGE, "mend takes SOLID and -o FILE; see graze mend --help");
    o->output = output_name(o->output, "-.off");
    size_t length = strlen(o->output);
    if (length < 5 || strcasecmp(o->output + length - 4, ".off") != 0)
        return complain(EXIT_USAGE, "--output %s: expected a name that ends in .off", o->output);
    int status = context_make(&context, &o->context);
    if (!status)
        status = mend_file(o, context, given->item[0]);
    graze_context_destroy(context);
    graze_thread_finish();
    return status;
}

const command command_mend = {.name = "mend",
                              .options = mend_table,
                              .size = sizeof(mend_options),
                              .reads = 1,
                              .help = mend_help,
                              .run = run_mend};
