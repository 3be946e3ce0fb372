/* The kind of a picture, by the extension of its file.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/draw/draw.h"

#include <ctype.h>
#include <dlfcn.h>
#include <stdlib.h>
#include <string.h>
#include "base/context/scope.h"
#include "output/draw/views.h"

int file_has_extension(const char *file, const char *extension) {
    const char *dot = strrchr(file, '.');
    if (!dot || strlen(dot + 1) != strlen(extension))
        return 0;
    for (size_t k = 0; extension[k]; k++)
        if (tolower((unsigned char)dot[k + 1]) != extension[k])
            return 0;
    return 1;
}

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
    TRY(check_room(context));
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

/* With `out` NULL only checked. */
static graze_status create_png(canvas **out, graze_context *context, double width, double height,
                               int pdf) {
    canvas *(*create)(double, double, int) = NULL;
    graze_status status = load_library(&create, context);
    if (status || !out)
        return status;
    *out = create(width, height, pdf);
    return *out ? GRAZE_OK : context_fail(context, GRAZE_ESYSTEM, "out of memory for a picture");
}

graze_status canvas_check(graze_context *context, const char *file) {
    if (file_has_extension(file, "png") || file_has_extension(file, "pdf"))
        return create_png(NULL, context, 0, 0, 0);
    if (file_has_extension(file, "svg"))
        return GRAZE_OK;
    return context_fail(
        context, GRAZE_EUSE,
        "%s: the extension is that of no picture; expected .svg, .png, .pdf or .html", file);
}

graze_status canvas_create(canvas **out, graze_context *context, const char *file, double width,
                           double height) {
    *out = NULL;
    TRY(canvas_check(context, file));
    if (file_has_extension(file, "svg"))
        return canvas_create_svg(out, context, width, height);
    return create_png(out, context, width, height, file_has_extension(file, "pdf"));
}
