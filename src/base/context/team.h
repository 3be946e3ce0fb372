/* Work on many indices by several threads.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CONTEXT_TEAM_H
#define GRAZE_CONTEXT_TEAM_H

#include "base/context/context.h"

/** Most members of a team. */
enum { TEAM_MOST = 1024 };

/** Work on one index. `member` counts from 0 to `threads` - 1, for what a thread keeps to itself;
 * the context is that thread's. */
typedef graze_status (*team_work)(void *data, graze_context *context, int member, size_t index);

/**
 * Do the work on the indices from 0 to `count` - 1, in any order, by the calling thread and up to
 * `threads` - 1 more. Threads that cannot be started are done without.
 * @return GRAZE_ECANCELED if `context` was asked to stop, else the first failure by index, with its
 * message in `context`
 */
graze_status team_run(graze_context *context, int threads, size_t count, team_work work,
                      void *data);

#endif
