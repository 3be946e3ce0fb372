/* Exit status and messages of the programs.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "program/io/io.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* The name of the limit that a message names as `the limit NAME=`; NULL if it names none. */
static const char *limit_named(const char *message) {
    static const char before[] = "the limit ";
    const char *at = strstr(message, before);
    for (int k = 0; at && k < GRAZE_LIMIT_COUNT; k++) {
        const char *name = graze_limit_name((graze_limit)k);
        size_t length = strlen(name);
        const char *there = at + strlen(before);
        if (strncmp(there, name, length) == 0 && there[length] == '=')
            return name;
    }
    return NULL;
}

static int faults_alone;

void complain_of_faults_alone(void) {
    faults_alone = 1;
}

int complain(int status, const char *format, ...) {
    char message[1 << 14];
    if (faults_alone && status == EXIT_DONE)
        return status;
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);
    waiting_clear();
    const char *limit = status == EXIT_LIMIT ? limit_named(message) : NULL;
    if (limit)
        fprintf(stderr, "graze: %s; --limit %s=V raises it\n", message, limit);
    else
        fprintf(stderr, "graze: %s\n", message);
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

const char *complaint_of(const graze_context *context) {
    const char *message = graze_context_message(context);
    size_t n = strncmp(message, "graze_", 6) ? 0 : strspn(message, "abcdefghijklmnopqrstuvwxyz_");
    return n && strncmp(message + n, ": ", 2) == 0 ? message + n + 2 : message;
}

int complain_of(graze_status status, const graze_context *context) {
    int code = exit_of(status);
    if (code == EXIT_DONE || code == EXIT_SIGNAL)
        return code;
    return complain(code, "%s",
                    code == EXIT_FAULT ? graze_context_message(context) : complaint_of(context));
}

int complain_of_use(graze_status status, const graze_context *context) {
    return status == GRAZE_EUSE ? complain(EXIT_USAGE, "%s", complaint_of(context))
                                : complain_of(status, context);
}

int exit_for(graze_status status, int otherwise) {
    return status == GRAZE_ELIMIT || status == GRAZE_ESYSTEM ? exit_of(status) : otherwise;
}
