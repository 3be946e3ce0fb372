/* Messages, exit status, contexts, and a scene from two files.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include "cli/cli.h"
#include "cli/interrupt.h"

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

int exit_for(graze_status status, int otherwise) {
    return status == GRAZE_ELIMIT || status == GRAZE_ESYSTEM ? exit_of(status) : otherwise;
}

static int interrupted(void *data) {
    (void)data;
    return interrupt_signal() != 0;
}

graze_status context_for(graze_context **out, const options *o) {
    graze_status status = graze_context_create(out);
    if (status)
        return status;
    graze_context_set_cancel(*out, interrupted, NULL);
    graze_context_set_filter(*out, !o->exact_only);
    status = graze_context_set_rounding(*out, o->rounding);
    for (int k = 0; k < GRAZE_LIMIT_COUNT && !status; k++)
        if (o->limits[k])
            status = graze_context_set_limit(*out, (graze_limit)k, o->limits[k]);
    return status;
}

int load(loaded *out, const options *o, int illegal, const unsigned char *trusted) {
    memset(out, 0, sizeof *out);
    graze_status status = context_for(&out->context, o);
    if (!out->context)
        return complain(EXIT_IO, "out of memory");
    if (status)
        return complain(EXIT_USAGE, "%s", graze_context_message(out->context));
    const char *path = o->operands[0];
    status =
        trusted ? graze_solid_read_trusted(&out->solid, out->context, path, o->solid_flags, trusted)
                : graze_solid_read(&out->solid, out->context, path, o->solid_flags);
    if (!status && *graze_solid_note(out->solid))
        complain(EXIT_DONE, "note: %s: %s", path, graze_solid_note(out->solid));
    if (!status)
        status = graze_motion_read(&out->motion, out->context, o->operands[1]);
    if (!status)
        status = graze_scene_create(&out->scene, out->context, out->solid, out->motion, &o->scene);
    int code = complain_of(status, out->context);
    return status == GRAZE_EILLEGAL ? illegal : code;
}

void unload(loaded *l) {
    graze_scene_destroy(l->scene);
    graze_motion_destroy(l->motion);
    graze_solid_destroy(l->solid);
    graze_context_destroy(l->context);
    graze_thread_finish();
}
