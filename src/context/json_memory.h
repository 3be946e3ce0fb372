/* Memory for yajl, which writes into what it gets without a look whether it got any.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * When memory runs out the functions do not return to yajl but to the setjmp of the caller. What
 * yajl held then is freed by json_memory_clear. Nothing of ours lies between the two: yajl asks for
 * memory itself, and never from within a callback.
 */
#ifndef GRAZE_CONTEXT_JSON_MEMORY_H
#define GRAZE_CONTEXT_JSON_MEMORY_H

#include <setjmp.h>
#include <yajl/yajl_common.h>

typedef struct json_memory {
    jmp_buf short_of;           /**< set by the caller before yajl is called */
    struct json_block *newest;  /**< what yajl holds */
    yajl_alloc_funcs functions; /**< for yajl_alloc and yajl_gen_alloc */
} json_memory;

/** The memory stays where it is: yajl keeps its address. */
void json_memory_init(json_memory *memory);
/** Free what yajl has not freed; then none of yajl's handles is left. */
void json_memory_clear(json_memory *memory);

#endif
