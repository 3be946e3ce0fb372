/* graze mend: makes a legal solid from a mesh that is not one.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "program/cli/values.h"

#include <strings.h>
#include "base/context/scope.h"

HELP(mend);

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
