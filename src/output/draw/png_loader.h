/* PNG and PDF canvases, made by a shared object of the same version that is loaded at need.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_DRAW_PNG_LOADER_H
#define GRAZE_DRAW_PNG_LOADER_H

#include "output/draw/canvas.h"

/** The shared object, which stands beside libgraze.so. */
#define PNG_LIBRARY "libgraze-png-" GRAZE_VERSION ".so"

/** Its function: a new canvas of a size in pixels, or NULL without memory. */
canvas *graze_png_create(double width, double height, int pdf);

#endif
