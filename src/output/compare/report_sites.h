/* The part of a comparison's report that is of contact points alone; empty for other tables.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_COMPARE_REPORT_SITES_H
#define GRAZE_COMPARE_REPORT_SITES_H

#include "base/number/json.h"
#include "output/compare/comparison.h"

/** By what rows are matched, and which columns are not judged. */
void put_sites(text *out, const graze_comparison *c);
/** How many rows of both tables agree in each column. */
void put_sites_by_column(text *out, const graze_comparison *c);

/** Sites as members of a JSON object, which has the errors by column anyway. */
void put_json_sites(json_writer *w, const graze_comparison *c);

#endif
