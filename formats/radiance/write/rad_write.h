/* rad_write.h - scene descriptions as Radiance scene files [WS98].
 *
 * The files read back (rad_read.h) as the same description: vertices exactly, materials
 * to rounding. rad_write_materials.h writes materials and patterns:
 *
 *     glass         a single clean pane without a frame
 *     BRTDfunc      any other clear glazing, by pp_through and pp_mirrored
 *     plastic ...   opaque; metal if the gloss has the colour, mirror if the material
 *                   has only a mirror reflection; plastic2, metal2 with two roughnesses
 *     trans, trans2 translucent
 *     glow, light,  emitters, with a pattern if they have one; illum if invisible
 *     illum
 *     BSDF, aBSDF   scattering panes, with a data file
 *     mixfunc       shapes whose sides differ
 */
#ifndef PP_FORMATS_RADIANCE_WRITE_RAD_WRITE_H
#define PP_FORMATS_RADIANCE_WRITE_RAD_WRITE_H

#include <stdio.h>

#include "model/base/error.h"
#include "model/light/scene_description.h"

/* Unique names for materials, patterns and pairs of materials, valid in Radiance. */
struct pp_rad_writer;

/* Makes the names. The scene must outlive the writer. PP_BAD_INPUT for materials that
 * no Radiance type can describe. */
enum pp_status pp_rad_write_create(struct pp_rad_writer **writer,
                                   const struct pp_scene_description *scene,
                                   struct pp_error *err);
void pp_rad_write_destroy(struct pp_rad_writer *writer); /* NULL is allowed */

/* Writes shapes `first` to `end` - 1, named `name` with numbers from 1. */
void pp_rad_write_shapes(const struct pp_rad_writer *writer, const char *name,
                         int first, int end, FILE *out);

#endif
