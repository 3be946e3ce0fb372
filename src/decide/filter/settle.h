/* From the findings of a search to disjoint windows: what is not certainly apart is asked together.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_FILTER_SETTLE_H
#define GRAZE_FILTER_SETTLE_H

#include "decide/filter/findings.h"

/** Make of crossings and candidates, in any order, disjoint windows and crossings in order of time:
 * what is not certainly apart is asked together (proofs/filter.md C37). 0 without memory. */
int findings_settle(findings *found);

#endif
