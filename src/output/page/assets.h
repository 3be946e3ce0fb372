/* The files of a page, which the library holds.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_PAGE_ASSETS_H
#define GRAZE_PAGE_ASSETS_H

#include "output/report/sentences.h"

/** Texts, each ended by a NUL: page.html, three.js, and its licence. */
extern const char asset_template[] ASSET, asset_three[] ASSET, asset_licence[] ASSET;
/** The page's own scripts in their order, ended by NULL. */
extern const char *const asset_program[];

#endif
