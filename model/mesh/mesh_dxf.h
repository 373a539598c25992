/* mesh_dxf.h - the surfaces of an ASCII DXF file, of AutoCAD R12 and later.
 *
 * Entities read: 3DFACE; POLYLINE that is a polyface or a polygon mesh; LWPOLYLINE,
 * POLYLINE, SOLID and TRACE with a thickness, extruded along their own normal, with
 * floor and lid if closed; MESH; INSERT, as the entities of its block, moved, scaled,
 * rotated, and repeated in columns and rows. Reported as errors, with name and line:
 * entities with unsupported surfaces (3DSOLID, REGION, ...), arcs in extruded outlines,
 * lines, arcs and circles with a thickness, and blocks of another file. Other lines,
 * texts and similar entities are ignored. The unit is $INSUNITS.
 */
#ifndef PP_MODEL_MESH_MESH_DXF_H
#define PP_MODEL_MESH_MESH_DXF_H

#include "model/mesh/mesh_triangles.h"
#include "model/mesh/mesh_lines.h"

/* Fills an empty mesh, which the caller clears even after a failure. PP_BAD_INPUT names
 * file and line. */
enum pp_status pp_mesh_dxf_read(struct pp_mesh_triangles *mesh,
                                struct pp_mesh_lines *lines, struct pp_error *err);

#endif
