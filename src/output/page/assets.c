/* The bytes of the page's files, put into the library by the assembler.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/page/page.h"

#include <stddef.h>

#define FILE_AS(name, path) ASSET_FILE(name, "src/output/page/" path)

FILE_AS(asset_template, "page.html");
FILE_AS(asset_three, "three/three.min.js");
FILE_AS(asset_licence, "three/LICENSE");
FILE_AS(asset_numbers, "numbers.js");
FILE_AS(asset_motion, "motion.js");
FILE_AS(asset_points, "points.js");
FILE_AS(asset_sentences, "sentences.js");
FILE_AS(asset_paper, "paper.js");
FILE_AS(asset_axes, "axes.js");
FILE_AS(asset_view, "view.js");
FILE_AS(asset_world, "world.js");
FILE_AS(asset_panel, "panel.js");
FILE_AS(asset_main, "main.js");

extern const char asset_numbers[] ASSET, asset_motion[] ASSET, asset_points[] ASSET;
extern const char asset_sentences[] ASSET, asset_paper[] ASSET, asset_axes[] ASSET;
extern const char asset_view[] ASSET, asset_world[] ASSET, asset_panel[] ASSET, asset_main[] ASSET;

const char *const asset_program[] = {"const SAYS = ", sentences,    ";\n",           asset_numbers,
                                     asset_motion,    asset_points, asset_sentences, asset_paper,
                                     asset_axes,      asset_view,   asset_world,     asset_panel,
                                     asset_main,      NULL};
