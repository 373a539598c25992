/* heap.c - by the settings of the C library, and by the machine's call for pages ahead. */
#include "model/base/heap.h"

#include <malloc.h>
#include <stdint.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <unistd.h>

enum { GROWTH = 1 << 20, LARGEST_ARRAY = 4 << 20, KEPT = 8 << 20 };

/* A page that is given back and asked for again was a sixth of a plan's pages. */
void pp_heap_keep(void)
{
#ifdef M_TOP_PAD
    mallopt(M_TOP_PAD, GROWTH);
    mallopt(M_MMAP_THRESHOLD, LARGEST_ARRAY);
    mallopt(M_TRIM_THRESHOLD, KEPT);
#endif
}

void pp_heap_fill(void *block, size_t size)
{
#ifdef MADV_POPULATE_WRITE
    size_t page = (size_t)sysconf(_SC_PAGESIZE);
    size_t before = page - (uintptr_t)block % page;
    if (size >= before + page)
        madvise((char *)block + before, (size - before) / page * page,
                MADV_POPULATE_WRITE);
#else
    (void)block, (void)size;
#endif
}

/* A block as large stands where the next ones are going to. */
void pp_heap_expect(size_t size)
{
    size = size < LARGEST_ARRAY / 2 ? size : LARGEST_ARRAY / 2;
    char *block = malloc(size);
    if (block)
        pp_heap_fill(block, size);
    free(block);
}
