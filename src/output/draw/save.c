/* The file of a picture.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/draw/save.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

graze_status save_file(graze_context *context, const char *file, const text *bytes) {
    int standard = strncmp(file, "-.", 2) == 0 && !strchr(file, '/');
    const char *name = standard ? "standard output" : file;
    FILE *stream = standard ? fdopen(dup(STDOUT_FILENO), "wb") : fopen(file, "wb");
    if (!stream)
        return context_fail_in(context, GRAZE_ESYSTEM, name, 0, "cannot be opened for writing: %s",
                               strerror(errno));
    int wrong = fwrite(bytes->data, 1, bytes->length, stream) != bytes->length ? errno : 0;
    if (fclose(stream) != 0 && !wrong)
        wrong = errno;
    if (wrong)
        return context_fail_in(context, GRAZE_ESYSTEM, name, 0, "writing failed: %s",
                               strerror(wrong));
    return GRAZE_OK;
}
