/* arena.h - pieces of memory that are freed together. */
#ifndef PP_MODEL_BASE_ARENA_H
#define PP_MODEL_BASE_ARENA_H

#include <stddef.h>

/* Zeroed at first. */
struct pp_arena {
    struct pp_arena_block *blocks;
};

/* A piece of that size, of any alignment; NULL: no memory. */
void *pp_arena_take(struct pp_arena *arena, size_t size);

/* A copy of the text, with a NUL behind it; NULL: no memory. */
char *pp_arena_take_text(struct pp_arena *arena, const char *text, size_t length);

void pp_arena_clear(struct pp_arena *arena);

#endif
