/* cache_layer.h - the records of one depth, and the requests for them. Inside simulate/
 * only.
 *
 * Depth 0 contains the records of visible surfaces. Depth 1 contains the records of
 * surfaces that light the visible ones.
 */
#ifndef PP_SIMULATE_CACHE_CACHE_LAYER_H
#define PP_SIMULATE_CACHE_CACHE_LAYER_H

#include "simulate/cache/cache_octree.h"
#include "simulate/cache/cache_record.h"

/* Place whose irradiance is requested. */
struct pp_cache_request {
    struct pp_cache_place place;
    float
        guess_m; /* expected radius of a record there; below 0: the place is covered */
};

struct pp_cache_layer {
    struct pp_cache_record_settings settings;
    struct pp_vec3 *corners; /* corners of the settings' hemispheres */
    struct pp_cache_entry *entries;
    int entry_count, entry_capacity;
    struct pp_cache_octree tree;

    struct pp_cache_request *requests; /* requests; those not yet met begin at `next` */
    int request_count, request_capacity, next;
    int *open; /* indices of uncovered requests in the chunk that begins at `next` */
    int open_count;
    bool again; /* records have been added since the first request was examined */
};

/* Inserts an entry: limits the radii of the entry and of its neighbours by each other
 * [KBPZ06], and adds the entry to the tree. */
enum pp_status pp_cache_layer_add(struct pp_cache_layer *layer,
                                  const struct pp_cache_entry *entry,
                                  struct pp_error *err);

/* Adds an entry without limiting radii. */
enum pp_status pp_cache_layer_put(struct pp_cache_layer *layer,
                                  const struct pp_cache_entry *entry,
                                  struct pp_error *err);

/* Rebuilds the tree with the present radii, so that a cache read from a file sums
 * records in the same order. */
enum pp_status pp_cache_layer_rebuild_tree(struct pp_cache_layer *layer,
                                           struct pp_error *err);

/* Weighted mean of the records whose ellipses contain the place; false if there are
 * none. */
bool pp_cache_layer_read(const struct pp_cache_layer *layer,
                         const struct pp_cache_place *place, struct pp_rgb *value);

/* True if pp_cache_layer_read would succeed; faster. */
bool pp_cache_layer_covers(const struct pp_cache_layer *layer,
                           const struct pp_cache_place *place);

/* Expected radius of a record at the place: the smaller radius of the record that is
 * nearest in normalised distance; 0: no record is valid for the place. */
double pp_cache_layer_guess(const struct pp_cache_layer *layer,
                            const struct pp_cache_place *place);

#endif
