/* The kind of a picture, by the extension of its file.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/draw/picture_kind.h"

#include <ctype.h>
#include <string.h>
#include "output/draw/png_loader.h"
#include "output/draw/svg.h"

int file_has_extension(const char *file, const char *extension) {
    const char *dot = strrchr(file, '.');
    if (!dot || strlen(dot + 1) != strlen(extension))
        return 0;
    for (size_t k = 0; extension[k]; k++)
        if (tolower((unsigned char)dot[k + 1]) != extension[k])
            return 0;
    return 1;
}

graze_status canvas_check(graze_context *context, const char *file) {
    if (file_has_extension(file, "png") || file_has_extension(file, "pdf"))
        return canvas_check_png(context);
    if (file_has_extension(file, "svg"))
        return GRAZE_OK;
    return context_fail(
        context, GRAZE_EUSE,
        "%s: the extension is that of no picture; expected .svg, .png, .pdf or .html", file);
}

graze_status canvas_create(canvas **out, graze_context *context, const char *file, double width,
                           double height) {
    *out = NULL;
    graze_status status = canvas_check(context, file);
    if (status)
        return status;
    if (file_has_extension(file, "svg"))
        return canvas_create_svg(out, context, width, height);
    return canvas_create_png(out, context, width, height, file_has_extension(file, "pdf"));
}
