/* The plane of a picture.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CLI_PLANE_H
#define GRAZE_CLI_PLANE_H

#include "graze.h"

/** Numbers of the option --plane, and what is computed from them. */
typedef struct plane_numbers {
    mpq_t given[9], normal[3], place;
} plane_numbers;

void plane_init(plane_numbers *p);
void plane_clear(plane_numbers *p);

/** Read `z=1/2`, the four numbers of an equation, a point and a normal, or three points. Returns an
 * exit status and says what is wrong.
 * @param[out] out its plane, plane_axis and normal; they point into `p` */
int plane_read(graze_draw_options *out, plane_numbers *p, graze_context *context, const char *text);

#endif
