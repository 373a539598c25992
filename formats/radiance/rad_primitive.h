/* rad_primitive.h - one primitive of a Radiance scene: its words, and what they add to the
 * scene. Inside formats/radiance/ only. */
#ifndef PP_FORMATS_RADIANCE_RAD_PRIMITIVE_H
#define PP_FORMATS_RADIANCE_RAD_PRIMITIVE_H

#include "formats/radiance/rad_reader.h"

/* Reads the next primitive, "modifier type name" and its strings and numbers or an
 * alias, and adds what it is to the scene; *ended at the end of the file. */
enum pp_status pp_rad_primitive_read(struct pp_rad_reader *reader,
                                     struct pp_rad_words *words,
                                     const struct pp_rad_context *context, bool *ended,
                                     struct pp_error *err);

#endif
