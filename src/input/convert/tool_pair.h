/* Two polyhedra about a tool.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CONVERT_TOOL_PAIR_H
#define GRAZE_CONVERT_TOOL_PAIR_H

#include "input/convert/tool.h"

/** A profile from the bottom to the top: `count` pairs r, z. */
typedef struct profile {
    size_t count;
    fmpq *point;
} profile;

/** Both polyhedra: `sides` corners u_k of an inscribed polygon; those outside have the corners
 * stretch u_k, and the same number of profile points, each near its counterpart. */
typedef struct tool_pair {
    profile in, out;
    size_t sides;
    fmpq *corner;
    fmpq_t stretch;
} tool_pair;

/** Make both with that many sides and pieces of the arc, coordinates of directions on a grid of
 * 2^-bits. tool_pair_clear in any case. */
void tool_pair_make(tool_pair *out, const tool *s, size_t sides, size_t pieces, slong bits);
void tool_pair_clear(tool_pair *p);

#endif
