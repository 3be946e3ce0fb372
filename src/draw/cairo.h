/* The few functions of libcairo that a PNG picture needs, found while the program runs.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Only pictures need cairo, and it brings a window system's libraries along: so neither the build
 * nor the library depends on it. The declarations are those of cairo 1, which keeps them.
 */
#ifndef GRAZE_DRAW_CAIRO_H
#define GRAZE_DRAW_CAIRO_H

#include "context/context.h"

typedef struct _cairo cairo_t;
typedef struct _cairo_surface cairo_surface_t;

/** Values of cairo's enumerations, which C passes as integers. */
enum {
    CAIRO_RGB24 = 1,
    CAIRO_WINDING = 0,
    CAIRO_EVEN_ODD = 1,
    CAIRO_ANTIALIAS_ON = 0,
    CAIRO_ANTIALIAS_OFF = 1,
    CAIRO_JOIN_ROUND = 1,
    CAIRO_SLANT_NONE = 0
};

typedef struct cairo_extents {
    double x_bearing, y_bearing, width, height, x_advance, y_advance;
} cairo_extents;

typedef struct cairo_functions {
    cairo_surface_t *(*image_surface_create)(int format, int width, int height);
    unsigned (*surface_write_to_png_stream)(cairo_surface_t *,
                                            unsigned (*write)(void *closure,
                                                              const unsigned char *data,
                                                              unsigned length),
                                            void *closure);
    void (*surface_destroy)(cairo_surface_t *);
    cairo_t *(*create)(cairo_surface_t *);
    void (*destroy)(cairo_t *);
    unsigned (*status)(cairo_t *);
    void (*save)(cairo_t *);
    void (*restore)(cairo_t *);
    void (*scale)(cairo_t *, double x, double y);
    void (*set_source_rgba)(cairo_t *, double red, double green, double blue, double alpha);
    void (*set_line_width)(cairo_t *, double);
    void (*set_line_join)(cairo_t *, unsigned);
    void (*set_dash)(cairo_t *, const double *lengths, int count, double offset);
    void (*set_fill_rule)(cairo_t *, unsigned);
    void (*set_antialias)(cairo_t *, unsigned);
    void (*new_path)(cairo_t *);
    void (*move_to)(cairo_t *, double x, double y);
    void (*line_to)(cairo_t *, double x, double y);
    void (*close_path)(cairo_t *);
    void (*arc)(cairo_t *, double x, double y, double radius, double from, double to);
    void (*rectangle)(cairo_t *, double x, double y, double width, double height);
    void (*clip)(cairo_t *);
    void (*fill_preserve)(cairo_t *);
    void (*stroke)(cairo_t *);
    void (*paint)(cairo_t *);
    void (*select_font_face)(cairo_t *, const char *family, unsigned slant, unsigned weight);
    void (*set_font_size)(cairo_t *, double);
    void (*text_path)(cairo_t *, const char *utf8);
    void (*text_extents)(cairo_t *, const char *utf8, cairo_extents *);
} cairo_functions;

/**
 * Find the functions. The library stays loaded until the process ends.
 * @return GRAZE_ESYSTEM libcairo.so.2 is not there, or lacks one of them
 */
graze_status cairo_find(cairo_functions *out, graze_context *context);

#endif
