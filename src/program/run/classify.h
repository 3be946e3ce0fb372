/* One run of graze classify or graze certify: points of a file or a grid into a table, a
 * certificate or both.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_RUN_CLASSIFY_H
#define GRAZE_RUN_CLASSIFY_H

#include "program/run/files.h"

/** Classify the points and write the table, the certificate or both. Returns an exit status and
 * says what is wrong. */
int classify_run(const classify_options *o);

#endif
