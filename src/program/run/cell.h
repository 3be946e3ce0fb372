/* Boundary cells as graze generate spells them.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_RUN_CELL_H
#define GRAZE_RUN_CELL_H

#include "input/delimited/field.h"

/** The form, for messages. */
#define CELL_FORM "`face 3`, `edge 1-2` or `vertex 5`"

/** Read CELL_FORM, of an edge the lower end first; 0 if the text is none. */
int cell_read(graze_cell *out, field text);

#endif
