/* openings.h - a room's openings as next-event estimation samples them. */
#ifndef PP_SIMULATE_SCENE_OPENINGS_H
#define PP_SIMULATE_SCENE_OPENINGS_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/room/world.h"
#include "simulate/sampling/sample_polygon.h"
#include "simulate/scene/light_scene.h"
#include "simulate/scene/triangles.h"

/* An opening, with facts that save rays. */
struct pp_pane {
    struct pp_target target;
    const struct pp_opening *opening; /* not owned */
    int part;
    bool seen_by_all;  /* no surface can stand between it and a point in the room */
    bool unobstructed; /* a ray that leaves by it meets no surface any more */
};

/* Fills scene->panes from scene->world; triangles: those of all parts, with the
 * openings' own from `first` on. */
enum pp_status pp_openings_find(struct pp_light_scene *scene,
                                const struct pp_triangles *triangles, int first,
                                struct pp_error *err);

/* The opening that u in [0, 1) falls to, in proportion to what each may bring to that
 * side of a surface by the guessed brightness outside, and its probability; -1: none
 * can bring anything. */
int pp_openings_choose(const struct pp_light_scene *scene,
                       struct pp_brightness brightness, struct pp_vec3 point,
                       struct pp_vec3 normal, double u, double *probability);

/* The angular size of an opening from a point: the root of its area over its
 * distance. */
double pp_openings_angular_size(const struct pp_pane *pane, struct pp_vec3 from);

#endif
