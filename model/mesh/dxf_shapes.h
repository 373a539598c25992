/* dxf_shapes.h - entities of a DXF file that are surfaces, as faces of a mesh. Inside
 * model/mesh/ only. */
#ifndef PP_MODEL_MESH_DXF_SHAPES_H
#define PP_MODEL_MESH_DXF_SHAPES_H

#include "model/mesh/dxf_tags.h"
#include "model/mesh/mesh_triangles.h"

/* Transformation from an entity's coordinates to the file's: p = origin + x axes[0] + y
 * axes[1] + z axes[2]. */
struct pp_dxf_move {
    struct pp_vec3 origin, axes[3];
};

struct pp_vec3 pp_dxf_shapes_moved(const struct pp_dxf_move *move, struct pp_vec3 p);

/* One entity of a file: tags from ... to - 1; the first tag is its type. */
struct pp_dxf_entity {
    struct pp_mesh_triangles *mesh;
    const struct pp_dxf_tags *tags;
    const struct pp_mesh_lines *lines;
    const struct pp_dxf_move *move;
    int from, to;
};

/* Reads the point with the codes `first`, first + 10 and first + 20; missing
 * coordinates are 0. */
enum pp_status pp_dxf_shapes_point(struct pp_vec3 *point,
                                   const struct pp_dxf_entity *entity, int first,
                                   struct pp_error *err);

/* Axes of the entity in the file's coordinates; z is its extrusion (210). Arbitrary
 * axis algorithm of the DXF reference. */
enum pp_status pp_dxf_shapes_axes(struct pp_dxf_move *move,
                                  const struct pp_dxf_entity *entity,
                                  struct pp_error *err);

enum pp_status pp_dxf_shapes_face(const struct pp_dxf_entity *entity,
                                  struct pp_error *err);
/* Reads a MESH entity: corners and faces before smoothing. */
enum pp_status pp_dxf_shapes_mesh(const struct pp_dxf_entity *entity,
                                  struct pp_error *err);

/* Reads a SOLID or TRACE, which is a surface only if it has a thickness. */
enum pp_status pp_dxf_shapes_solid(const struct pp_dxf_entity *entity,
                                   struct pp_error *err);
enum pp_status pp_dxf_shapes_lwpolyline(const struct pp_dxf_entity *entity,
                                        struct pp_error *err);

/* Reads a POLYLINE; entity->to is the end of its last VERTEX. */
enum pp_status pp_dxf_shapes_polyline(const struct pp_dxf_entity *entity,
                                      struct pp_error *err);

#endif
