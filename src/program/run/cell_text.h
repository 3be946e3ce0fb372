/* Boundary cells in sentences. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_RUN_CELL_TEXT_H
#define GRAZE_RUN_CELL_TEXT_H

#include "base/number/text.h"

/** `face 3`, `edge 1-2`, `vertex 5`. */
void text_cell(text *t, const graze_cell *cell);

#endif
