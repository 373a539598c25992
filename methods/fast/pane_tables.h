/* pane_tables.h - the tables of pane_light.h for all openings of a world under one sky.
 * Openings with the same glazing share tables; for a sky that varies with azimuth they
 * must also have the same orientation. */
#ifndef PP_METHODS_FAST_PANE_TABLES_H
#define PP_METHODS_FAST_PANE_TABLES_H

#include "methods/fast/pane_light.h"
#include "model/light/outside_light.h"
#include "model/room/world.h"

struct pp_pane_tables;

/* Makes tables of clear glass and of gradations, which are valid for any receiver.
 * `plane` is the common normal of many receivers: skies without a gradation table are
 * tabulated for this normal to 1e-6, once for each orientation; NULL: not tabulated.
 * On success the caller destroys *tables, which may outlive the world and may be read
 * by any number of threads. */
enum pp_status pp_pane_tables_create(struct pp_pane_tables **tables,
                                     const struct pp_world *world,
                                     const struct pp_outside_light *light,
                                     const struct pp_vec3 *plane, struct pp_error *err);
void pp_pane_tables_destroy(struct pp_pane_tables *tables); /* NULL is allowed */

/* Tables of the opening with this index. */
const struct pp_pane_light *pp_pane_tables_at(const struct pp_pane_tables *tables,
                                              int opening);

#endif
