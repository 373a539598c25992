/* rad_bsdf.h - Radiance's materials BSDF and aBSDF, whose data are a WINDOW XML file.
 *
 *     mod BSDF name             mod aBSDF name
 *     6 thickness file up .     5 file up .
 *     0                         0
 *     0                         0
 *
 * up: three numbers. Three or six numbers instead of the last 0 are diffuse reflectances of
 * front and back, in addition to the data. The front of a surface is the side of the room. A thickness is
 * ignored. aBSDF traces unscattered light as a ray (measured_pane.h). The file is sought
 * from the current folder, then from that of the scene file.
 */
#ifndef PP_FORMATS_RADIANCE_READ_RAD_BSDF_H
#define PP_FORMATS_RADIANCE_READ_RAD_BSDF_H

#include "formats/radiance/read/rad_reader.h"

/* Adds the material. *taken is false, and nothing happens, for other types. */
enum pp_status pp_rad_bsdf_read(struct pp_rad_reader *reader,
                                const struct pp_rad_primitive *primitive,
                                const struct pp_rad_context *context, bool *taken,
                                struct pp_error *err);

#endif
