/* Loads what makes PNG and PDF canvases. SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/draw/png_loader.h"

#include <dlfcn.h>
#include <stdlib.h>
#include <string.h>

/* Fontconfig and pixman crash when memory runs out within them. This much is more than they and the
 * library's code take; for the image itself cairo reports it. */
enum { ROOM = 64 << 20 };

static graze_status check_room(graze_context *context) {
    void *volatile room = malloc(ROOM); /* or the compiler would leave both calls out */
    if (!room)
        return context_fail(
            context, GRAZE_ESYSTEM,
            "out of memory for a picture: a PNG or PDF takes %d MB; expected more memory, "
            "or an .svg picture",
            ROOM >> 20);
    free(room);
    return GRAZE_OK;
}

/* The shared object stays loaded until the process ends. */
static graze_status load_library(canvas *(**create)(double, double, int), graze_context *context) {
    graze_status status = check_room(context);
    if (status)
        return status;
    void *library = dlopen(PNG_LIBRARY, RTLD_NOW | RTLD_LOCAL);
    void *symbol = library ? dlsym(library, "graze_png_create") : NULL;
    if (!symbol)
        return context_fail(context, GRAZE_ESYSTEM,
                            "PNG and PDF pictures need " PNG_LIBRARY
                            ", which cannot be loaded (%s); it is "
                            "built where cairo's headers are (Debian: libcairo2-dev); expected "
                            "that library, or an .svg picture",
                            dlerror());
    /* POSIX: a symbol's address is a function's, which C has no conversion for. */
    memcpy(create, &symbol, sizeof symbol);
    return GRAZE_OK;
}

graze_status canvas_check_png(graze_context *context) {
    canvas *(*create)(double, double, int);
    return load_library(&create, context);
}

graze_status canvas_create_png(canvas **out, graze_context *context, double width, double height,
                               int pdf) {
    canvas *(*create)(double, double, int);
    graze_status status = load_library(&create, context);
    if (status)
        return status;
    *out = create(width, height, pdf);
    return *out ? GRAZE_OK : context_fail(context, GRAZE_ESYSTEM, "out of memory for a picture");
}
