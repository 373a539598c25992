/* rad_read.h - Radiance scene files [WS98] as a scene description.
 *
 * Supported shapes: polygon, sphere, bubble, cone, cup, cylinder, tube, ring, source.
 * Materials: void, alias, plastic, metal, trans, glass, light, glow, illum, mirror, and
 * the anisotropic plastic2, metal2 and trans2 with constant directions. Measured data:
 * BSDF and aBSDF (rad_bsdf.h). Functions: brightfunc skybr of skybright.cal, as written
 * by gensky, and skybright of perezlum.cal, as written by gendaylit; mixfunc with one
 * material per side; the functions of pepperpot's own exports (rad_functions.h).
 * Commands: "!gensky", "!gendaylit", "!genbox" and "!xform", also piped. They are
 * evaluated here; nothing is executed.
 *
 * Everything else is an error with file and line, so that no scene is misread. The
 * limits are 50 million shapes, 200,000 materials, a million copies by xform, and 4 GiB
 * read by xforms.
 */
#ifndef PP_FORMATS_RADIANCE_READ_RAD_READ_H
#define PP_FORMATS_RADIANCE_READ_RAD_READ_H

#include <stddef.h>

#include "model/base/error.h"
#include "model/light/scene_description.h"

struct pp_rad_summary {
    long polygons, others; /* shapes added to the scene */
    long flat;             /* polygons without area, left out as in Radiance */
    long unseen;           /* shapes of material void, left out */
};

/* Reads the files in order, as if they were one; "-" is standard input, and a path that
 * begins with "!" is a command. `scene` is initialised here; on failure it is empty.
 * PP_BAD_INPUT for unsupported or wrong input. */
enum pp_status pp_rad_read(struct pp_scene_description *scene,
                           struct pp_rad_summary *summary, const char *const *paths,
                           int count, struct pp_error *err);

/* Reads from memory; `file` is the name used in messages. */
enum pp_status pp_rad_read_bytes(struct pp_scene_description *scene,
                                 struct pp_rad_summary *summary, const char *bytes,
                                 size_t length, const char *file, struct pp_error *err);

#endif
