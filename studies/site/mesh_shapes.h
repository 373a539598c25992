/* mesh_shapes.h - a mesh as a plan of a site shows it: no triangles, but the parts that are
 * seen from above as one, and their edges.
 *
 * Triangles that share an edge are one part where they bend by less than 20 degrees and lie
 * beside each other from above, so that the edge is none to be drawn. Edges are drawn that
 * belong to one triangle, to a bend, or to where a part turns under itself. So that what is
 * low is not drawn after what is high (sheets are painted from low to high) a part that
 * bends is cut, without a line, where it rises by more than two metres, and one that is
 * plane by more than ten.
 */
#ifndef PP_STUDIES_SITE_MESH_SHAPES_H
#define PP_STUDIES_SITE_MESH_SHAPES_H

#include "model/results/sheets/site_sheet.h"
#include "model/room/world.h"

/* Adds shapes of the world's mesh to the sheet, without a name; the caller clears it, after a
 * failure too. */
enum pp_status pp_mesh_shapes_add(struct pp_site_sheet *sheet,
                                  const struct pp_world *world,
                                  const struct pp_world_mesh *mesh,
                                  struct pp_error *err);

#endif
