/* rad_read.h - Radiance scene files [WS98] as a scene description.
 *
 * Supported: polygon, sphere, bubble, cone, cup, cylinder, tube, ring, source; void,
 * alias; plastic, metal, trans and the anisotropic plastic2, metal2, trans2 with
 * constant directions, glass, light, glow, illum, mirror; brightfunc skybr of
 * skybright.cal, as gensky writes it; mixfunc with one material a side, and the
 * functions of our own exports (rad_functions.h); lines "!xform", "!genbox" and
 * "!gensky", piped too. Nothing is executed: the lines are evaluated here. Everything
 * else is refused with its file and line, so that no scene is misread. So are scenes of
 * more than 50 million shapes, 200,000 materials, a million copies by xform or 4 GiB
 * read by those.
 */
#ifndef PP_FORMATS_RADIANCE_READ_RAD_READ_H
#define PP_FORMATS_RADIANCE_READ_RAD_READ_H

#include <stddef.h>

#include "model/base/error.h"
#include "model/light/scene_description.h"

struct pp_rad_summary {
    long polygons, others; /* shapes that are in the scene */
    long flat;             /* polygons without an area, left out as Radiance does */
    long unseen;           /* shapes of void, left out */
};

/* Reads the files one after the other, names and all, as if they were one; "-" is
 * standard input. `scene` is initialised here; on failure it is empty. */
enum pp_status pp_rad_read(struct pp_scene_description *scene,
                           struct pp_rad_summary *summary, const char *const *paths,
                           int count, struct pp_error *err);

/* Reads from memory; `file` is the name in messages. */
enum pp_status pp_rad_read_bytes(struct pp_scene_description *scene,
                                 struct pp_rad_summary *summary, const char *bytes,
                                 size_t length, const char *file, struct pp_error *err);

#endif
