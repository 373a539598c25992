/* heap.h - how the memory of a process is taken from the machine and kept.
 *
 * A page that is asked for by its first use takes the longer, on a virtual machine 25 times as
 * long as one of many that are asked for at once: a twelfth of the processor's time for a
 * room's daylight factors by all hand methods, a thirtieth of that for a grid by simulation.
 */
#ifndef PP_MODEL_BASE_HEAP_H
#define PP_MODEL_BASE_HEAP_H

#include <stddef.h>

/* From now on memory is taken by megabytes, and given back beyond eight. For main(), before it
 * does anything else. */
void pp_heap_keep(void);

/* About so many bytes are going to be allocated and filled: has the machine give them at once,
 * up to two megabytes. Where it can't, nothing happens. */
void pp_heap_expect(size_t size);

/* The same for the block itself, of any size, whose every byte is going to be written. */
void pp_heap_fill(void *block, size_t size);

#endif
