/* opening_store.h - the radiance outside each opening of a room, calculated once for a
 * given light from outside.
 *
 * With a store, a path that leaves through an opening usually needs only one ray
 * outside. This ray is still traced to the first surface, so that silhouettes stay
 * sharp. The surface's radiance is read from the opening's table (opening_table.h). The
 * path continues only from surfaces that the table does not contain: panes, and
 * surfaces near the opening.
 */
#ifndef PP_SIMULATE_TRANSPORT_OPENING_STORE_H
#define PP_SIMULATE_TRANSPORT_OPENING_STORE_H

#include <stdint.h>

#include "model/base/error.h"
#include "simulate/scene/environment.h"
#include "simulate/scene/light_scene.h"
#include "simulate/transport/opening_table.h"

struct pp_opening_store {
    struct pp_opening_table *tables; /* by opening */
    int count;
    uint32_t samples; /* number of paths for each bin */
};

/* environment: as in struct pp_radiance_state. *store is NULL if there is nothing to
 * calculate. It is also NULL under a photographed sky with bright parts (sky_bright.h),
 * such as the sun: their shadows on surfaces outside are sharper than the directions of
 * a table. The result is the same for any number of threads (0: one for each
 * processor). */
enum pp_status pp_opening_store_create(struct pp_opening_store **store,
                                       const struct pp_light_scene *scene,
                                       const struct pp_environment *environment,
                                       uint64_t seed, int threads,
                                       struct pp_error *err);
void pp_opening_store_destroy(struct pp_opening_store *store); /* NULL is allowed */

#endif
