/* The sentences of explanations, for texts and for pages: sentences.json, a line for each key.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_REPORT_SENTENCES_H
#define GRAZE_REPORT_SENTENCES_H

#include "base/number/text.h"
#include "output/report/asset.h"

/** That file. */
extern const char sentences[] ASSET;

/** Add integers as a vector, `(1, -2)`. */
void sentence_vector(text *out, const fmpz *v, int dimension);
/** Add a sentence, each % filled by a text, # by an unsigned long, @ by a rational, ~ by a point and
 * & by a vector with their dimensions, $ by the sentence of a key, whose own fillings follow. */
void sentence_put(text *out, const char *key, ...);

#endif
