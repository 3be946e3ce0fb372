/* A typed table as a numpy array.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TABLE_TYPED_NPY_H
#define GRAZE_TABLE_TYPED_NPY_H

#include "output/table/typed.h"

/** As a structured numpy array. */
graze_status typed_write_npy(const typed_table *t, sink to);

#endif
