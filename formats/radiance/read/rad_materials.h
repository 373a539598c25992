/* rad_materials.h - converts Radiance materials to materials of a scene description.
 * Inside formats/radiance/ only. */
#ifndef PP_FORMATS_RADIANCE_READ_RAD_MATERIALS_H
#define PP_FORMATS_RADIANCE_READ_RAD_MATERIALS_H

#include "formats/radiance/read/rad_reader.h"

/* Reads a primitive of a material type and defines its name; *taken is false for other
 * types. */
enum pp_status pp_rad_materials_read(struct pp_rad_reader *reader,
                                     const struct pp_rad_primitive *primitive,
                                     const struct pp_rad_context *context, bool *taken,
                                     struct pp_error *err);

/* PP_BAD_INPUT if the scene exceeds the limit on materials and patterns. */
enum pp_status pp_rad_materials_check_count(const struct pp_rad_reader *reader,
                                            const struct pp_rad_words *words, int line,
                                            struct pp_error *err);

#endif
