/* year_store.h - randomisations of the coefficients of rooms, stored in a file. They
 * contain no weather: an interrupted calculation continues from the file, and a finished
 * one serves any other weather file, schedule or target.
 *
 * Least significant byte first:
 *
 *     8 bytes   "PPDCOEFF"
 *     u32       version
 *   then for each randomisation:
 *     u32 x 2   number of the room, and of the state of its windows
 *     64 bytes  name of the room, filled with zeros
 *     u64 x 4   hashes of geometry and materials, of ground and sky, of the points and
 *               of the window groups
 *     f64       bearing of the y axis
 *     u32 x 4   numbers of points, window groups, sky patches and light paths
 *     u64       seed
 *     u32       index of the randomisation
 *     u64       size of its data
 *     u64       hash of this head
 *     data      (year_batch_bytes.h)
 *     u64       hash of the data
 *
 * Randomisations are added as they are finished. If a run ended while it was adding one,
 * the next run overwrites that one.
 */
#ifndef PP_SIMULATE_YEAR_YEAR_STORE_H
#define PP_SIMULATE_YEAR_YEAR_STORE_H

#include <stdio.h>

#include "simulate/year/year_batch.h"

/* Everything that the coefficients of a room depend on, and its name for messages. */
struct pp_year_origin {
    int room;  /* its number in the command, from 0 */
    int state; /* of its windows: 0 open, 1 with their devices, 2 open with trees
                * without leaves */
    char name[64];
    uint64_t scene, light, points, groups; /* hashes */
    double north_rad;
    int point_count, group_count, patches, paths;
    uint64_t seed;
};

enum pp_year_store_use {
    PP_YEAR_STORE_READ,   /* every randomisation must be there */
    PP_YEAR_STORE_UPDATE, /* missing ones are added */
    PP_YEAR_STORE_WRITE,  /* all are added to a new file */
};

struct pp_year_store;

/* Reads the heads of the file. file: as `use` needs it, not owned; it must be seekable
 * except for PP_YEAR_STORE_WRITE. title: its name in messages, not owned. PP_BAD_INPUT if
 * it is no such file, is of another version, or is damaged. */
enum pp_status pp_year_store_create(struct pp_year_store **store, FILE *file,
                                    const char *title, enum pp_year_store_use use,
                                    struct pp_error *err);
void pp_year_store_destroy(struct pp_year_store *store); /* NULL is allowed */

/* PP_BAD_INPUT if the store has the room and state with another origin; the message
 * names the first difference. The number of paths may differ. PP_YEAR_STORE_READ: the
 * store must have all randomisations, or none if the state is not 0 (open). Their
 * number of paths must be *paths; if that is 0, *paths becomes their number. */
enum pp_status pp_year_store_check(const struct pp_year_store *store,
                                   const struct pp_year_origin *origin, int *paths,
                                   struct pp_error *err);

/* Number of randomisations with this origin. */
int pp_year_store_count(const struct pp_year_store *store,
                        const struct pp_year_origin *origin);

/* Stores that a calculation uses, and the origin of its coefficients. */
struct pp_year_stores {
    struct pp_year_store *const *list;
    int count;
    struct pp_year_origin origin;
};

struct pp_thread_pool;

/* Reads randomisation `index` from one of the stores, or calculates it with
 * pp_year_batch_make and adds it to the stores of PP_YEAR_STORE_UPDATE. To be called by
 * a worker of the pool. stores NULL: none. */
enum pp_status pp_year_stores_batch(const struct pp_year_stores *stores,
                                    struct pp_year_batch *batch,
                                    const struct pp_year_task *task, int index,
                                    int worker, struct pp_thread_pool *pool,
                                    struct pp_error *err);

/* Adds all randomisations, in order, to the stores to write. */
enum pp_status pp_year_stores_write(const struct pp_year_stores *stores,
                                    const struct pp_year_batch *batches,
                                    const struct pp_year_task *task,
                                    struct pp_error *err);

#endif
