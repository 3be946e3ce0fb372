/* The kind of a picture, by the extension of its file.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_DRAW_PICTURE_KIND_H
#define GRAZE_DRAW_PICTURE_KIND_H

#include "output/draw/canvas.h"

/** 1 if a name has an extension, which is given in small letters without its dot. */
int file_has_extension(const char *file, const char *extension);
/** Check before long work that canvas_create can make the picture: GRAZE_EUSE an extension other
 * than .svg, .png and .pdf, GRAZE_ESYSTEM no library for the last two. */
graze_status canvas_check(graze_context *context, const char *file);
/** The kind of a path's extension; what canvas_check returns, or GRAZE_ESYSTEM. */
graze_status canvas_create(canvas **out, graze_context *context, const char *file, double width,
                           double height);

#endif
