/* Memory for yajl, which does not check for NULL.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * When memory runs out the functions return to the setjmp of the caller instead of to yajl, and
 * json_memory_clear frees the blocks of yajl. No code of Graze lies between the two: yajl allocates
 * outside of callbacks only.
 */
#ifndef GRAZE_CONTEXT_JSON_MEMORY_H
#define GRAZE_CONTEXT_JSON_MEMORY_H

#include <setjmp.h>
#include <yajl/yajl_common.h>

typedef struct json_memory {
    jmp_buf short_of;           /**< set by the caller before yajl is called */
    struct json_block *newest;  /**< of the blocks of yajl */
    yajl_alloc_funcs functions; /**< for yajl_alloc and yajl_gen_alloc */
} json_memory;

/** `memory` must not be moved: yajl keeps its address. */
void json_memory_init(json_memory *memory);
/** Free all blocks of yajl; its handles are invalid then. */
void json_memory_clear(json_memory *memory);

#endif
