/* crew.h - work dealt out to several threads: one function for every index of a range.
 * The one place where the program starts threads.
 *
 * Indices are dealt out in their order, one at a time or by handfuls, to whoever has nothing
 * to do.
 * What each gives has to be its own, so that the result does not depend on who does
 * what; what is added up over them is added up afterwards, in their order.
 *
 * The caller is a member and works too. The others are started with the first work that
 * has more than one index and sleep in between, and nobody waits for a member that has
 * not woken up yet: on a machine whose processors are busy with other things, several
 * threads do not take longer than one.
 */
#ifndef PP_MODEL_BASE_CREW_H
#define PP_MODEL_BASE_CREW_H

#include <stdbool.h>

#include "model/base/error.h"

struct pp_crew;

/* A crew of `threads` members; 0 or less: one for each processor that this process may
 * use. Members that the system refuses are done without. */
enum pp_status pp_crew_create(struct pp_crew **crew, int threads, struct pp_error *err);
void pp_crew_destroy(struct pp_crew *crew); /* NULL is allowed */

/* How many members it has, 1 or more. */
int pp_crew_size(const struct pp_crew *crew);

/* The work of one index. `member`, from 0 to the crew's size - 1, is who does it: two
 * that work at the same time differ. False: no further index is dealt out. */
typedef bool pp_crew_work(void *data, int member, int index);

/* Does first, first + 1, ... up to `end`, which is not of them. Returns the index after
 * the last that was dealt out, once all before it are done: `end`, unless the work has
 * stopped it. By one thread at a time, and not from within the crew's work. */
int pp_crew_run(struct pp_crew *crew, int first, int end, pp_crew_work *work,
                void *data);

/* The same for work of microseconds: members take several indices at once, where there are
 * many, as what they count by and write to side by side is in each other's caches. Which is
 * the last that was dealt out depends on how many there are and on the crew's size. */
int pp_crew_run_small(struct pp_crew *crew, int first, int end, pp_crew_work *work,
                      void *data);

/* Around what one member at a time may do, within the crew's work. */
void pp_crew_lock(struct pp_crew *crew);
void pp_crew_unlock(struct pp_crew *crew);

#endif
