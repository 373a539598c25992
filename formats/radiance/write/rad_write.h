/* rad_write.h - scene descriptions as Radiance scene files [WS98].
 *
 * The files read back (rad_read.h) as the same description: vertices to the bit, the
 * effect of materials to rounding. Materials and patterns are rad_write_materials.h's.
 *
 *     glass         a single pane, nothing but glass
 *     BRTDfunc      any other clear glazing, by pp_through and pp_mirrored
 *     plastic ...   opaque; metal where the gloss has the colour, mirror where there is
 *                   nothing else; plastic2, metal2 with two roughnesses
 *     trans, trans2 translucent
 *     glow, light   emitters, with a pattern where they have one
 *     mixfunc       of shapes whose sides differ
 */
#ifndef PP_FORMATS_RADIANCE_WRITE_RAD_WRITE_H
#define PP_FORMATS_RADIANCE_WRITE_RAD_WRITE_H

#include <stdio.h>

#include "model/base/error.h"
#include "model/light/scene_description.h"

/* The names that materials, patterns and pairs of materials go by: their own, made fit
 * for Radiance and unlike each other. */
struct pp_rad_writer;

/* scene must live as long as the writer. PP_BAD_INPUT for materials that Radiance has
 * no type for. */
enum pp_status pp_rad_write_create(struct pp_rad_writer **writer,
                                   const struct pp_scene_description *scene,
                                   struct pp_error *err);
void pp_rad_write_destroy(struct pp_rad_writer *writer); /* NULL is allowed */

/* Shapes `first` to `end` - 1, named `name` and their numbers from 1. */
void pp_rad_write_shapes(const struct pp_rad_writer *writer, const char *name,
                         int first, int end, FILE *out);

#endif
