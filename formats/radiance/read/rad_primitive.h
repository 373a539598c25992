/* rad_primitive.h - one primitive of a Radiance scene: a shape, a material, a pattern
 * or an alias. Inside formats/radiance/ only. */
#ifndef PP_FORMATS_RADIANCE_READ_RAD_PRIMITIVE_H
#define PP_FORMATS_RADIANCE_READ_RAD_PRIMITIVE_H

#include "formats/radiance/read/rad_reader.h"

/* Reads the next primitive: "modifier type name" with its strings and numbers, or an
 * alias. Adds the shape, material or pattern to the scene. *ended is true at the end of
 * the file. */
enum pp_status pp_rad_primitive_read(struct pp_rad_reader *reader,
                                     struct pp_rad_words *words,
                                     const struct pp_rad_context *context, bool *ended,
                                     struct pp_error *err);

#endif
