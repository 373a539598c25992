/* atlas_room.h - calculates one room of the atlas: the results of every hand method,
 * and simulated values of the room and of the world that each method assumes. */
#ifndef PP_STUDIES_RESEARCH_ATLAS_ATLAS_ROOM_H
#define PP_STUDIES_RESEARCH_ATLAS_ATLAS_ROOM_H

#include <stdint.h>

#include "studies/research/atlas/atlas_columns.h"
#include "studies/research/atlas/atlas_drawn.h"

/* The columns that every room of the sweep has. */
enum pp_status pp_atlas_room_columns(struct pp_atlas_columns *columns,
                                     const struct pp_atlas_design *design,
                                     struct pp_error *err);

/* Makes the rows of room `index`, with one thread; the caller frees *rows. Equal
 * arguments give equal rows. */
enum pp_status pp_atlas_room_rows(char **rows, size_t *length,
                                  const struct pp_atlas_columns *columns,
                                  const struct pp_atlas_design *design, int index,
                                  const struct pp_atlas_trace *trace,
                                  struct pp_error *err);

#endif
