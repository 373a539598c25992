/* rad_genbox.h - the box of a "genbox" command, with sharp, bevelled or rounded edges.
 * Inside formats/radiance/ only. */
#ifndef PP_FORMATS_RADIANCE_READ_RAD_GENBOX_H
#define PP_FORMATS_RADIANCE_READ_RAD_GENBOX_H

#include "formats/radiance/read/rad_pipe.h"
#include "formats/radiance/read/rad_reader.h"

/* Adds the box of "genbox MATERIAL NAME X Y Z [options]" to the scene. */
enum pp_status pp_rad_genbox(struct pp_rad_reader *reader,
                             const struct pp_rad_pipe *pipe,
                             const struct pp_rad_command *command,
                             const struct pp_rad_context *context,
                             struct pp_error *err);

#endif
