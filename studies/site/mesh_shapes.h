/* mesh_shapes.h - a mesh in a site plan. Instead of triangles the plan shows the parts
 * that look connected from above, and their edges.
 *
 * Triangles that share an edge are in one part if the bend is less than 20 degrees and
 * they do not overlap when seen from above; that edge is not drawn. Edges are drawn if
 * they belong to one triangle, to a bend, or to a place where a part turns under
 * itself. Sheets are painted from low to high. So that low areas are not painted over
 * high ones, a bent part is cut, without a line, where it rises by more than two
 * metres, and a plane part where it rises by more than ten.
 */
#ifndef PP_STUDIES_SITE_MESH_SHAPES_H
#define PP_STUDIES_SITE_MESH_SHAPES_H

#include "model/results/sheets/site_sheet.h"
#include "model/room/world.h"

/* Adds shapes of the world's mesh to the sheet, without a name; the caller clears it,
 * even after a failure. */
enum pp_status pp_mesh_shapes_add(struct pp_site_sheet *sheet,
                                  const struct pp_world *world,
                                  const struct pp_world_mesh *mesh,
                                  struct pp_error *err);

#endif
