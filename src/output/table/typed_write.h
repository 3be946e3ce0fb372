/* A typed table in one of its forms.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TABLE_TYPED_WRITE_H
#define GRAZE_TABLE_TYPED_WRITE_H

#include "output/table/typed.h"

/** Write a whole table in one of the binary forms. GRAZE_ELIMIT, GRAZE_ESYSTEM. */
graze_status typed_write(const typed_table *t, graze_format form, sink to);

#endif
