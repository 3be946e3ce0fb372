/* Rows in reports: how they were matched, shares, conventions for `on`, and how deep errors are.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_COMPARE_REPORT_ROWS_H
#define GRAZE_COMPARE_REPORT_ROWS_H

#include "base/number/json.h"
#include "output/compare/comparison.h"

/** A share with two digits, rounded to nearest, from whole numbers: it does not depend on the
 * locale. */
void put_share(text *out, unsigned long part, unsigned long whole);

/** A line on the columns by which points were matched; of contact points none. Where nothing but
 * the order told, it says how far the points are apart. */
void put_matched(text *out, const graze_comparison *c);

/** The share of wrong rows and their number by column; where rows are missing there is no share. */
void put_wrong_rows(text *out, const graze_comparison *c);

/** A line on the points that lie on a mesh; of tables none. */
void put_apart(text *out, const graze_comparison *c);

/** A line on the wrong rows under every convention for `on`, if the candidate never answers it. */
void put_conventions(text *out, const graze_comparison *c);

/** A table of the sizes of the wrong rows' signed distances, by the golden answer; nothing where
 * none was taken. */
void put_depths(text *out, const graze_comparison *c);

/** Rows as members of a JSON object. */
void put_json_rows(json_writer *w, const graze_comparison *c);

#endif
