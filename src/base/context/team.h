/* Work on many indices by several threads.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CONTEXT_TEAM_H
#define GRAZE_CONTEXT_TEAM_H

#include "base/context/context.h"

/** Most members of a team. */
enum { TEAM_MOST = 1024 };

/** Work on one index. `member`, from 0 to `threads` - 1, is the number of the thread that works,
 * and `context` is the thread's own. */
typedef graze_status (*team_work)(void *data, graze_context *context, int member, size_t index);

/**
 * Do the work on the indices from 0 to `count` - 1, in any order, by the calling thread and up to
 * `threads` - 1 more. If a thread cannot be started, fewer do the work.
 * @return GRAZE_ECANCELED if the cancel callback asked to stop, else the failure at the least
 * index, with its message in `context`, or GRAZE_OK
 */
graze_status team_run(graze_context *context, int threads, size_t count, team_work work,
                      void *data);

#endif
