/* Enclosures of distances in rows that were written.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_RUN_ENCLOSED_H
#define GRAZE_RUN_ENCLOSED_H

#include "input/delimited/field.h"
#include "graze.h"

/** 1 if three columns are an enclosure with the sign of an answer, and a time. */
int enclosed_fits(graze_pmc pmc, field low, field high, field time);

/** 1 if the enclosure of a row, of CSV with so many columns behind it or of JSON, is wider than the
 * tolerance. */
int enclosed_is_wide(field row, double tolerance, int behind);

#endif
