/* mesh_shapes.h - a mesh in a site plan. The plan does not show triangles, but parts
 * that look connected from above, and their edges.
 *
 * Triangles that share an edge are in the same part if the bend between them is less
 * than 20 degrees and they do not overlap as seen from above. Their common edge is not
 * drawn. An edge is drawn if it belongs to only one triangle, if there is a bend, or
 * where a part folds under itself. Parts are painted in order of height. To avoid
 * painting low areas over high ones, a bent part is divided, without a line, where it
 * rises by more than 2 m. A plane part is divided where it rises by more than 10 m.
 */
#ifndef PP_STUDIES_SITE_MESH_SHAPES_H
#define PP_STUDIES_SITE_MESH_SHAPES_H

#include "model/results/sheets/site_sheet.h"
#include "model/room/world.h"

/* Adds shapes without a name to the sheet for a mesh of the world. The caller clears
 * the sheet, even after a failure. */
enum pp_status pp_mesh_shapes_add(struct pp_site_sheet *sheet,
                                  const struct pp_world *world,
                                  const struct pp_world_mesh *mesh,
                                  struct pp_error *err);

#endif
