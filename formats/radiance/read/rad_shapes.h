/* rad_shapes.h - converts Radiance shapes to shapes of a scene description. Inside
 * formats/radiance/ only. */
#ifndef PP_FORMATS_RADIANCE_READ_RAD_SHAPES_H
#define PP_FORMATS_RADIANCE_READ_RAD_SHAPES_H

#include "formats/radiance/read/rad_reader.h"

/* Reads a primitive of a shape type and adds the shape to the scene; *taken is false
 * for other types. */
enum pp_status pp_rad_shapes_read(struct pp_rad_reader *reader,
                                  const struct pp_rad_primitive *primitive,
                                  const struct pp_rad_context *context, bool *taken,
                                  struct pp_error *err);

/* Transforms a shape by the context and adds it to the scene: a polygon of `count`
 * corners, or any other shape given by `shape`. Shapes of material void are left
 * out. */
enum pp_status pp_rad_shapes_add_polygon(struct pp_rad_reader *reader,
                                         const struct pp_rad_words *words, int line,
                                         struct pp_rad_meaning modifier,
                                         const struct pp_vec3 *corners, int count,
                                         const struct pp_rad_context *context,
                                         struct pp_error *err);
enum pp_status pp_rad_shapes_add(struct pp_rad_reader *reader,
                                 const struct pp_rad_words *words, int line,
                                 struct pp_rad_meaning modifier, struct pp_shape shape,
                                 const struct pp_rad_context *context,
                                 struct pp_error *err);

#endif
