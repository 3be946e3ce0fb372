/* The links of a selective Nef complex.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_READ_NEF3_LINKS_H
#define GRAZE_READ_NEF3_LINKS_H

#include "input/read/nef3_text.h"

/** GRAZE_EINPUT unless all links answer one another and the lists name each thing once. */
graze_status nef_check_links(const nef *n);

#endif
