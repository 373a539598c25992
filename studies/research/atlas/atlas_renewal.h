/* atlas_renewal.h - recalculates the results of hand methods for a room of an existing
 * atlas, and keeps the simulated values.
 *
 * For a method that is not yet in the atlas, the simulated values in its own world are
 * copied from a method that assumes the same world.
 */
#ifndef PP_STUDIES_RESEARCH_ATLAS_ATLAS_RENEWAL_H
#define PP_STUDIES_RESEARCH_ATLAS_ATLAS_RENEWAL_H

#include "studies/research/atlas/atlas_columns.h"
#include "studies/research/atlas/atlas_drawn.h"
#include "studies/research/atlas/atlas_table.h"

/* Number of complete rooms in the table. PP_BAD_INPUT if the rows are not those of the
 * rooms 0, 1, 2, ... in this order. */
enum pp_status pp_atlas_renewal_rooms(int *rooms, const struct pp_atlas_table *table,
                                      struct pp_error *err);

/* Makes the new rows of room `index`; the caller frees *rows. PP_BAD_INPUT if the
 * points in the table are not the points of the room. */
enum pp_status pp_atlas_renewal_rows(char **rows, size_t *length,
                                     const struct pp_atlas_columns *columns,
                                     const struct pp_atlas_design *design,
                                     const struct pp_atlas_table *table, int index,
                                     struct pp_error *err);

#endif
