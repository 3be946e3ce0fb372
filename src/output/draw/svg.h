/* Canvases that are SVG texts.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_DRAW_SVG_H
#define GRAZE_DRAW_SVG_H

#include "output/draw/canvas.h"

/** A new canvas of a size in pixels; GRAZE_ESYSTEM without memory. */
graze_status canvas_create_svg(canvas **out, graze_context *context, double width, double height);

#endif
