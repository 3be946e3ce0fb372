/* graze compare: a candidate's answers against a golden table.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>
#include "cli/cli.h"
#include "cli/output.h"

static const char help[] =
    "graze compare GOLDEN CANDIDATE: a candidate's answers against a golden table\n"
    "\n"
    "GOLDEN is a whole table of graze classify. CANDIDATE is CSV with a line of column names: x, "
    "y\n"
    "(and z) or id, and those of pmc, class, i, t, word that it answers. Rows stand in the order "
    "of\n"
    "the golden table; a missing or an extra row is a difference. Either may be -. Printed are "
    "the\n"
    "confusion matrices, the errors by stratum, k, class, definition and case (as far as GOLDEN "
    "has\n"
    "these columns), and the first disagreements, each with the command that explains it.\n"
    "Exit status 0: no difference; 1: differences.\n"
    "\n"
    "  --question open      pmc as Graze gives it (default)\n"
    "  --question closed    position in the closed sweep: `on` with topo `interior` counts as "
    "`in`;\n"
    "                       without that column rows that may be seams are counted apart\n"
    "  --on-as on           `on` is an answer of its own (default)\n"
    "  --on-as any|in|out   for candidates that only know in and out\n"
    "  --candidate-has sdf  a column sdf: a signed distance, negative inside, 0 on\n"
    "  --round none|binary64|binary32   round the points of both tables before they are matched\n"
    "  --show N             how many disagreements (10)\n"
    "  --solid FILE, --motion FILE      names for the commands that explain\n"
    "  --format text|json   text is Markdown (default)\n"
    "  --output FILE        write there instead of to standard output\n"
    "  --limit NAME=V       digits 10000, line 10^7\n"
    "\n"
    "Example: graze compare golden.csv mine.csv --solid cube.off --motion move.json\n";

static output out;

/* 1 if the tables differ. */
static int differ(const graze_comparison *c) {
    graze_comparison_counts n = graze_comparison_count(c);
    return n.wrong + n.missing + n.extra > 0;
}

static int put_report(const options *o, graze_context *context, const graze_comparison *c) {
    char *text = NULL;
    graze_status made = graze_comparison_report(&text, context, c, o->report);
    int status = complain_of(made, context);
    if (!status)
        status = output_open(&out, o->output);
    if (!status) {
        output_put(&out, text);
        status = output_close(&out);
    }
    graze_free(text);
    return status ? status : differ(c) ? EXIT_NO : EXIT_DONE;
}

static int run(const options *o) {
    if (o->operand_count != 2)
        return complain(EXIT_USAGE,
                        "compare takes GOLDEN and CANDIDATE, %d given; see graze compare --help",
                        o->operand_count);
    if (strcmp(o->operands[0], "-") == 0 && strcmp(o->operands[1], "-") == 0)
        return complain(EXIT_USAGE, "GOLDEN and CANDIDATE cannot both be standard input");
    graze_context *context = NULL;
    graze_comparison *c = NULL;
    graze_status status = context_for(&context, o);
    if (!context)
        return complain(EXIT_IO, "out of memory");
    int code;
    if (status) {
        code = complain(EXIT_USAGE, "%s", graze_context_message(context));
    } else {
        status = graze_compare(&c, context, o->operands[0], o->operands[1], &o->compare);
        code = status ? complain_of(status, context) : put_report(o, context, c);
    }
    graze_comparison_destroy(c);
    graze_context_destroy(context);
    graze_thread_finish();
    return code;
}

const command command_compare = {"compare", "rlmFoqAHSDM", help, run};
