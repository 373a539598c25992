/* rad_sky.h - Radiance's skies: those that gensky or gendaylit has printed into a
 * scene, and those of the commands themselves. Inside formats/radiance/ only. */
#ifndef PP_FORMATS_RADIANCE_READ_RAD_SKY_H
#define PP_FORMATS_RADIANCE_READ_RAD_SKY_H

#include "formats/radiance/read/rad_pipe.h"
#include "formats/radiance/read/rad_reader.h"

/* Reads "void brightfunc NAME" of skybr, as written by gensky, or of skybright, as
 * written by gendaylit; *taken is false if the primitive is not a brightfunc. */
enum pp_status pp_rad_sky_read(struct pp_rad_reader *reader,
                               const struct pp_rad_primitive *primitive,
                               const struct pp_rad_context *context, bool *taken,
                               struct pp_error *err);

/* Adds the pattern to the scene and defines the primitive's name. */
enum pp_status pp_rad_sky_define(struct pp_rad_reader *reader,
                                 const struct pp_rad_primitive *primitive,
                                 const struct pp_pattern *pattern,
                                 struct pp_error *err);

/* Adds the output of "gensky" or "gendaylit [options]" to the scene: "skyfunc" and, for
 * a sky with a sun, "solar" and its source. */
enum pp_status pp_rad_sky_generate(struct pp_rad_reader *reader,
                                   const struct pp_rad_pipe *pipe,
                                   const struct pp_rad_command *command,
                                   const struct pp_rad_context *context,
                                   struct pp_error *err);

#endif
