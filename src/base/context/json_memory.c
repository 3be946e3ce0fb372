/* Memory for yajl (json_memory.h).
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Invariant: the blocks that yajl holds are a list in both directions, the newest first.
 */
#include "base/context/json_memory.h"

#include <stdalign.h>
#include <stddef.h>
#include <stdlib.h>

typedef struct json_block {
    struct json_block *older, *newer;
    alignas(max_align_t) char bytes[];
} json_block;

static json_block *block_of(void *bytes) {
    return (json_block *)((char *)bytes - offsetof(json_block, bytes));
}

/* Make the list's neighbours of a block point to it: the block is new, or realloc has moved it. */
static void *link_in(json_memory *memory, json_block *block) {
    if (block->newer != NULL)
        block->newer->older = block;
    else
        memory->newest = block;
    if (block->older != NULL)
        block->older->newer = block;
    return block->bytes;
}

static void *json_allocate(void *data, size_t size) {
    json_memory *memory = data;
    json_block *block = malloc(sizeof *block + size);
    if (block == NULL)
        longjmp(memory->short_of, 1);
    *block = (json_block){.older = memory->newest, .newer = NULL};
    return link_in(memory, block);
}

static void *json_resize(void *data, void *bytes, size_t size) {
    json_memory *memory = data;
    if (bytes == NULL)
        return json_allocate(data, size);
    json_block *block = realloc(block_of(bytes), sizeof *block + size);
    if (block == NULL)
        longjmp(memory->short_of, 1);
    return link_in(memory, block);
}

static void release(void *data, void *bytes) {
    json_memory *memory = data;
    if (bytes == NULL)
        return;
    json_block *block = block_of(bytes);
    if (block->newer != NULL)
        block->newer->older = block->older;
    else
        memory->newest = block->older;
    if (block->older != NULL)
        block->older->newer = block->newer;
    free(block);
}

void json_memory_init(json_memory *memory) {
    memory->newest = NULL;
    memory->functions = (yajl_alloc_funcs){json_allocate, json_resize, release, memory};
}

void json_memory_clear(json_memory *memory) {
    while (memory->newest != NULL)
        release(memory, memory->newest->bytes);
}
