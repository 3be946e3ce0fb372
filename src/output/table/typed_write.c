/* A typed table in one of its forms.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/table/table.h"

graze_status typed_write(const typed_table *t, graze_format form, sink to) {
    return form == GRAZE_FORMAT_VTK ? typed_write_vtk(t, to) : typed_write_npy(t, to);
}
