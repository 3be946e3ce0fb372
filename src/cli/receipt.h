/* Receipts: graze check says in a file what it found legal, so that graze classify need not look
 * for facets that meet again.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A receipt is a text that the scene and the options that shape it determine: version, hashes of
 * both files and of the scene, rounding, triangulation; and last a checksum of itself, against
 * accidents. It holds for a run that would write the same one.
 */
#ifndef GRAZE_CLI_RECEIPT_H
#define GRAZE_CLI_RECEIPT_H

#include "cli/cli.h"

/** Write the receipt of a legal scene to o->receipt. */
int receipt_write(const loaded *l, const options *o);

/** Load a scene, sparing what the receipt o->receipt answers for. EXIT_INPUT: it is none, or not
 * one of this scene. `out` is freed by unload in either case. */
int receipt_load(loaded *out, const options *o);

#endif
