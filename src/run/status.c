/* Exit status and messages of the programs.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "run/status.h"

#include <stdarg.h>
#include <stdio.h>

int complain(int status, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    fputs("graze: ", stderr);
    vfprintf(stderr, format, arguments);
    fputs("\n", stderr);
    va_end(arguments);
    return status;
}

static int exit_of(graze_status status) {
    switch (status) {
    case GRAZE_OK:
        return EXIT_DONE;
    case GRAZE_EINPUT:
    case GRAZE_EILLEGAL:
        return EXIT_INPUT;
    case GRAZE_ELIMIT:
        return EXIT_LIMIT;
    case GRAZE_ESYSTEM:
        return EXIT_IO;
    case GRAZE_ECANCELED:
        return EXIT_SIGNAL;
    default:
        return EXIT_FAULT;
    }
}

int complain_of(graze_status status, const graze_context *context) {
    int code = exit_of(status);
    if (code == EXIT_DONE || code == EXIT_SIGNAL)
        return code;
    return complain(code, "%s", graze_context_message(context));
}

int complain_of_use(graze_status status, const graze_context *context) {
    return status == GRAZE_EUSE ? complain(EXIT_USAGE, "%s", graze_context_message(context))
                                : complain_of(status, context);
}

int exit_for(graze_status status, int otherwise) {
    return status == GRAZE_ELIMIT || status == GRAZE_ESYSTEM ? exit_of(status) : otherwise;
}
