/* Frees simplices. SPDX-License-Identifier: GPL-3.0-or-later */
#include "input/validate/validate.h"

#include <stdlib.h>
#include <string.h>
#include "input/soup/soup.h"

void simplices_clear(simplices *cut) {
    free(cut->item);
    cell_names_clear(&cut->names);
    memset(cut, 0, sizeof *cut);
}
