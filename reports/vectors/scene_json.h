/* scene_json.h - the geometry of a resolved room as JSON, for programs that draw it. */
#ifndef PP_REPORTS_VECTORS_SCENE_JSON_H
#define PP_REPORTS_VECTORS_SCENE_JSON_H

#include <stdio.h>

#include "model/room/world.h"

/* Prints one object, "pepperpot-scene-1". The object contains surfaces, openings,
 * blocks, skylines and gardens, each with its line in the file, the working plane, and
 * the points. Lengths are in metres, in the room's axes. An outline is a flat list of
 * x, y and z, rounded to 0.1 mm; the working plane has lists of x and y. Angles are in
 * degrees. */
enum pp_status pp_scene_json(const struct pp_world *world,
                             const struct pp_receiver *points, int point_count,
                             FILE *out, struct pp_error *err);

#endif
