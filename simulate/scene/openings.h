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

/* What each opening may bring to one side of a surface, by the guessed brightness
 * outside: kept, as a point chooses more than once. */
enum { PP_OPENINGS_KEPT = 16 };

struct pp_openings_shares {
    struct pp_vec3 point, normal; /* whose they are; a normal of no length: nobody's */
    double of[PP_OPENINGS_KEPT];
};

/* The opening that u in [0, 1) falls to, in proportion to what each may bring to that
 * side of a surface, and its probability; -1: none can bring anything. shares: of one
 * scene and brightness, at first all zero. */
int pp_openings_choose(const struct pp_light_scene *scene,
                       struct pp_brightness brightness, struct pp_vec3 point,
                       struct pp_vec3 normal, struct pp_openings_shares *shares,
                       double u, double *probability);

/* The angular size of an opening from a point: the root of its area over its
 * distance. */
double pp_openings_angular_size(const struct pp_pane *pane, struct pp_vec3 from);

#endif
