/* arena.c - see arena.h. */
#include "model/base/arena.h"

#include <stdlib.h>
#include <string.h>

struct pp_arena_block {
    struct pp_arena_block *next;
    size_t used, size;
    _Alignas(max_align_t) char bytes[];
};

enum { BLOCK_BYTES = 1 << 16 };

void *pp_arena_take(struct pp_arena *arena, size_t size)
{
    size = (size + sizeof(max_align_t) - 1) / sizeof(max_align_t) * sizeof(max_align_t);
    struct pp_arena_block *block = arena->blocks;
    if (!block || block->size - block->used < size) {
        size_t bytes = size > BLOCK_BYTES ? size : BLOCK_BYTES;
        block = malloc(sizeof *block + bytes);
        if (!block)
            return NULL;
        *block = (struct pp_arena_block){.next = arena->blocks, .size = bytes};
        arena->blocks = block;
    }
    void *taken = block->bytes + block->used;
    block->used += size;
    return taken;
}

char *pp_arena_take_text(struct pp_arena *arena, const char *text, size_t length)
{
    char *copy = pp_arena_take(arena, length + 1);
    if (copy) {
        memcpy(copy, text, length);
        copy[length] = '\0';
    }
    return copy;
}

void pp_arena_clear(struct pp_arena *arena)
{
    while (arena->blocks) {
        struct pp_arena_block *next = arena->blocks->next;
        free(arena->blocks);
        arena->blocks = next;
    }
}
