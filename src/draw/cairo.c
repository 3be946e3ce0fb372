/* Finds cairo's functions.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "draw/cairo.h"

#include <dlfcn.h>
#include <stddef.h>
#include <string.h>

static const struct {
    const char *name;
    size_t place;
} wanted[] = {
    {"cairo_image_surface_create", offsetof(cairo_functions, image_surface_create)},
    {"cairo_surface_write_to_png_stream", offsetof(cairo_functions, surface_write_to_png_stream)},
    {"cairo_surface_destroy", offsetof(cairo_functions, surface_destroy)},
    {"cairo_create", offsetof(cairo_functions, create)},
    {"cairo_destroy", offsetof(cairo_functions, destroy)},
    {"cairo_status", offsetof(cairo_functions, status)},
    {"cairo_save", offsetof(cairo_functions, save)},
    {"cairo_restore", offsetof(cairo_functions, restore)},
    {"cairo_scale", offsetof(cairo_functions, scale)},
    {"cairo_set_source_rgba", offsetof(cairo_functions, set_source_rgba)},
    {"cairo_set_line_width", offsetof(cairo_functions, set_line_width)},
    {"cairo_set_line_join", offsetof(cairo_functions, set_line_join)},
    {"cairo_set_dash", offsetof(cairo_functions, set_dash)},
    {"cairo_set_fill_rule", offsetof(cairo_functions, set_fill_rule)},
    {"cairo_set_antialias", offsetof(cairo_functions, set_antialias)},
    {"cairo_new_path", offsetof(cairo_functions, new_path)},
    {"cairo_move_to", offsetof(cairo_functions, move_to)},
    {"cairo_line_to", offsetof(cairo_functions, line_to)},
    {"cairo_close_path", offsetof(cairo_functions, close_path)},
    {"cairo_arc", offsetof(cairo_functions, arc)},
    {"cairo_rectangle", offsetof(cairo_functions, rectangle)},
    {"cairo_clip", offsetof(cairo_functions, clip)},
    {"cairo_fill_preserve", offsetof(cairo_functions, fill_preserve)},
    {"cairo_stroke", offsetof(cairo_functions, stroke)},
    {"cairo_paint", offsetof(cairo_functions, paint)},
    {"cairo_select_font_face", offsetof(cairo_functions, select_font_face)},
    {"cairo_set_font_size", offsetof(cairo_functions, set_font_size)},
    {"cairo_text_path", offsetof(cairo_functions, text_path)},
    {"cairo_text_extents", offsetof(cairo_functions, text_extents)},
};

graze_status cairo_find(cairo_functions *out, graze_context *context) {
    void *library = dlopen("libcairo.so.2", RTLD_NOW | RTLD_LOCAL);
    if (!library)
        return context_fail(context, GRAZE_ESYSTEM,
                            "PNG pictures need the library libcairo.so.2 (Debian: libcairo2), "
                            "which is not here; right is to install it, or an .svg picture");
    for (size_t k = 0; k < sizeof wanted / sizeof *wanted; k++) {
        void *symbol = dlsym(library, wanted[k].name);
        if (!symbol)
            return context_fail(context, GRAZE_ESYSTEM,
                                "the library libcairo.so.2 here has no %s; right is a whole cairo "
                                "1.x with PNG, or an .svg picture",
                                wanted[k].name);
        /* POSIX: a symbol's address is a function's, which C has no conversion for. */
        memcpy((char *)out + wanted[k].place, &symbol, sizeof symbol);
    }
    return GRAZE_OK;
}
