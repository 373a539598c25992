/* rad_bsdf.h - Radiance's materials BSDF and aBSDF, whose data are in an XML file of
 * the program WINDOW.
 *
 *     mod BSDF name             mod aBSDF name
 *     6 thickness file up .     5 file up .
 *     0                         0
 *     0                         0
 *
 * up: three numbers. The last 0 may be replaced by three or six numbers: diffuse
 * reflectances of the front, or of front and back, which are added to the data. Three
 * more numbers, the diffuse transmittance, must be 0. The front of a surface faces the
 * room. The thickness is ignored. aBSDF traces unscattered light as a ray
 * (measured_pane.h). The path of the file is relative to the current folder, or else to
 * the folder of the scene file.
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
