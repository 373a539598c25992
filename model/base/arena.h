/* arena.h - a pool of memory whose pieces are freed together. */
#ifndef PP_MODEL_BASE_ARENA_H
#define PP_MODEL_BASE_ARENA_H

#include <stddef.h>

/* Initialise with zeros. */
struct pp_arena {
    struct pp_arena_block *blocks;
};

/* Allocates a piece, aligned for any type; NULL if memory runs out. */
void *pp_arena_take(struct pp_arena *arena, size_t size);

/* Copies a text and adds a NUL; NULL if memory runs out. */
char *pp_arena_take_text(struct pp_arena *arena, const char *text, size_t length);

void pp_arena_clear(struct pp_arena *arena);

#endif
