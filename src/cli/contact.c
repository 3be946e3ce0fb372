/* graze contact: contact points of the envelope.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "run/contact.h"

#include "cli/commands.h"
#include "cli/values.h"

static const char contact_help[] =
    "graze contact SOLID MOTION CONTACTS: boundary points at given times, and the envelope\n"
    "\n"
    "CONTACTS is a CSV file or - for standard input, with a line of names: time,bx,by[,bz] for a\n"
    "boundary point in the solid's own frame, or time,x,y[,z] for where it is then. Other columns\n"
    "are kept. A row says what the point is for the envelope at that time (role: contact, egress,\n"
    "ingress, hidden), order, curvature and orientation of a contact within a facet, the states "
    "of\n"
    "its trajectory before and after, whether the solid covers it at another time and when, the\n"
    "nearest times, and the word.\n"
    "\n"
    "  --format csv|jsonl   a table (default; whole only with its last line # complete N), or a\n"
    "                       line of JSON per point with the values of each facet\n"
    "  --output FILE        write there instead of to standard output\n"
    "  --quiet              no progress on the terminal\n"
    "  --round, --triangulate, --overlap, --no-filter, --limit NAME=V   as in graze classify\n"
    "\n"
    "Example: graze contact block.wkt turn.json contacts.csv > table.csv\n";

static int value_rows(void *to, const char *name, const char *value) {
    static const char *const words[] = {"csv", "jsonl"};
    static const graze_format formats[] = {GRAZE_FORMAT_CSV, GRAZE_FORMAT_JSONL};
    int chosen = 0, status = value_choice(&chosen, name, value, words, 2);
    *(graze_format *)to = formats[chosen];
    return status;
}

static const option_entry contact_table[] = {
    OPTION("format", contact_options, format, value_rows),
    OPTION("output", contact_options, output, value_text),
    OPTION("o", contact_options, output, value_text),
    OPTION("round", contact_options, scene.context.rounding, value_rounding),
    FLAG("triangulate", contact_options, scene.solid_flags, value_triangulate),
    OPTION("overlap", contact_options, scene.scene.overlap, value_overlap),
    FLAG("no-filter", contact_options, scene.context.exact_only, value_flag),
    OPTION("limit", contact_options, scene.context.limits, value_limit),
    FLAG("quiet", contact_options, quiet, value_flag),
    {NULL, OPTION_FLAG, NULL, 0}};

static int run_contact(void *options, const operands *given) {
    contact_options *o = options;
    if (given->count != 3)
        return complain(EXIT_USAGE,
                        "contact takes SOLID, MOTION and CONTACTS, %d operands given; see graze "
                        "contact --help",
                        given->count);
    o->scene.solid = given->item[0];
    o->scene.motion = given->item[1];
    o->contacts = given->item[2];
    return contact_run(o);
}

const command command_contact = {.name = "contact",
                                 .options = contact_table,
                                 .size = sizeof(contact_options),
                                 .help = contact_help,
                                 .run = run_contact};
