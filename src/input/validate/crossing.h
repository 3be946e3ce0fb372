/* The crossings of a ring of area zero with itself, for the readers' messages.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_VALIDATE_CROSSING_H
#define GRAZE_VALIDATE_CROSSING_H

#include "input/soup/soup.h"

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Name the two edges or the vertex in which a ring of E^2 with area zero crosses itself.
 * @param cycle the ring in the soup, which need not be whole
 * @return GRAZE_EILLEGAL naming the edges; GRAZE_OK if it crosses nowhere, or only in edges that
 * lie on one another; GRAZE_ECANCELED; GRAZE_EINTERNAL
 */
graze_status validate_crossing(graze_context *context, const soup *s, size_t cycle);

#ifdef __cplusplus
}
#endif
#endif
