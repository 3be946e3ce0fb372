/* Memory for yajl, which does not check for NULL.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * When memory runs out, the functions jump to the caller's setjmp instead of returning to yajl, and
 * json_memory_clear frees the blocks of yajl. The jump skips no code of Graze, since yajl allocates
 * outside of callbacks only.
 */
#ifndef GRAZE_CONTEXT_JSON_MEMORY_H
#define GRAZE_CONTEXT_JSON_MEMORY_H

#include <setjmp.h>
#include <yajl/yajl_common.h>

typedef struct json_memory {
    jmp_buf short_of;           /**< the caller's setjmp, called before yajl */
    struct json_block *newest;  /**< of the blocks of yajl */
    yajl_alloc_funcs functions; /**< for yajl_alloc and yajl_gen_alloc */
} json_memory;

/** `memory` must not be moved: yajl keeps its address. */
void json_memory_init(json_memory *memory);
/** Free all blocks of yajl; handles of yajl are invalid afterwards. */
void json_memory_clear(json_memory *memory);

#endif
