/* openings.h - a room's openings as targets of next-event estimation. */
#ifndef PP_SIMULATE_SCENE_OPENINGS_H
#define PP_SIMULATE_SCENE_OPENINGS_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/room/world.h"
#include "simulate/sampling/sample_polygon.h"
#include "simulate/scene/light_scene.h"
#include "simulate/scene/triangles.h"

enum { PP_PANE_SIDES = 4 };

/* An opening, with properties of its visibility that save rays. */
struct pp_pane {
    struct pp_target target;
    struct pp_target mouth;   /* mouth of the niche, in the face; without a niche, the
                               * same as the target */
    int sides[PP_PANE_SIDES]; /* parts that are the sides of a rectangular niche, with
                               * the normals along, -along, up and -up; -1: no niche */
    const struct pp_opening *opening; /* not owned */
    int part;
    bool seen_by_all;  /* no surface can be between the opening and a point in the
                        * room */
    bool unobstructed; /* a ray that leaves through the opening meets no further
                        * surface */
};

/* Target of directions to an opening. */
static inline const struct pp_target *pp_openings_aim(const struct pp_pane *pane,
                                                      bool mouths)
{
    return mouths ? &pane->mouth : &pane->target;
}

/* The glass of an opening as a target, without its triangles. Points of the target are
 * measured from `centre`. */
struct pp_target pp_openings_target(const struct pp_opening *opening,
                                    struct pp_vec3 centre);

/* Fills scene->panes from scene->world. triangles: those of all parts; the triangles of
 * openings begin at `first`. */
enum pp_status pp_openings_find(struct pp_light_scene *scene,
                                const struct pp_triangles *triangles, int first,
                                struct pp_error *err);

/* Importance of each opening for one side of a surface, from the estimated brightness
 * outside. Stored, since several choices are made at one point. */
enum { PP_OPENINGS_KEPT = 16 };

struct pp_openings_shares {
    struct pp_vec3 point, normal; /* viewing surface; a normal of zero length: no
                                   * surface */
    bool mouths;
    double of[PP_OPENINGS_KEPT];
};

/* Viewer of openings. */
struct pp_openings_viewer {
    const struct pp_brightness
        *brightness;              /* estimated brightness outside; not owned */
    struct pp_vec3 point, normal; /* on one side of a surface */
    bool mouths;                  /* true: targets are mouths of niches, not panes */
};

/* Chooses an opening by u in [0, 1), in proportion to its possible light at the viewer.
 * Also sets the probability of the choice. -1: no opening can contribute. shares: for
 * one scene and brightness, initially all zero. */
int pp_openings_choose(const struct pp_light_scene *scene,
                       const struct pp_openings_viewer *viewer,
                       struct pp_openings_shares *shares, double u,
                       double *probability);

/* The angular size of an opening from a point: the square root of its area, divided by
 * its distance. */
double pp_openings_angular_size(const struct pp_pane *pane, struct pp_vec3 from);

#endif
