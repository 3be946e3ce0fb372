/* Receipts: files in which graze check records a legal scene, so that graze classify need not
 * search for facets that meet again. SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A receipt is a text that the scene and the options that shape it determine: version, hashes of
 * both files and of the scene, rounding, triangulation; and last a checksum of itself, against
 * accidents. It holds for a run that would write the same one.
 */
#ifndef GRAZE_RUN_RECEIPT_H
#define GRAZE_RUN_RECEIPT_H

#include "program/run/load.h"

/** Write the receipt of a legal scene to a file. */
int receipt_write(const char *path, const loaded *l, const scene_options *o);

/** Read a scene, without the checks that its receipt covers; with all of them where `path` is NULL.
 * EXIT_INPUT: the file is no receipt, or not one of this scene. `out` is for loaded_clear in either
 * case. */
int receipt_load(loaded *out, const char *path, const scene_options *o);

#endif
