/* view_out.h - the view out of a room from one position of the eye, by [EN17037] 5.2:
 * its horizontal sight angle, the distance of visible objects, and its layers.
 *
 *   sight angle  the part of the horizon, in plan, covered by openings; overlaps count
 *                once. Exact: the outline of an opening and its reveal, less furniture
 *                and other parts of the room before it
 *   distance     median, over solid angle, of the distance from the glass along lines
 *                of sight; that of the sky is infinite. Lines that end less than 2 m
 *                beyond the glass are left out: a window sill or a railing is not a
 *                view
 *   layers       sky, landscape (all objects outside, and ground less than 5 degrees
 *                below the horizon) and ground
 *
 * The standard does not define the distance; these rules are documented by
 * ClimateStudio. Openings count whose glass is clear and rises from the vertical by 45
 * degrees or less. Distance and layers come from a lattice of lines of sight through
 * each opening.
 */
#ifndef PP_STUDIES_VIEW_OUT_H
#define PP_STUDIES_VIEW_OUT_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/room/world.h"
#include "simulate/scene/light_scene.h"

enum pp_view_layer {
    PP_VIEW_SKY = 1,
    PP_VIEW_LANDSCAPE = 2,
    PP_VIEW_GROUND = 4,
    PP_VIEW_LAYERS = 7 /* all layers */
};

/* Levels of [EN17037]; PP_VIEW_NONE: below the minimum. */
enum pp_view_level { PP_VIEW_NONE, PP_VIEW_MINIMUM, PP_VIEW_MEDIUM, PP_VIEW_HIGH };

struct pp_view_out {
    double sight_angle_rad; /* 0 to 2 pi */
    double distance_m;      /* INFINITY: only sky; 0: no line of sight counts */
    int layers;             /* enum pp_view_layer, through any opening */
    int layers_together; /* greatest number through one opening, landscape among them;
                          * 0: no opening shows landscape */
};

/* Lines of sight along each side of an opening's visible part. */
enum { PP_VIEW_OUT_LINES = 48 };

/* The view from an eye in the room. scene: the world's (light_scene_of_world.h). lines:
 * along each side of an opening, PP_VIEW_OUT_LINES or more for an even finer lattice. */
enum pp_status pp_view_out_from(struct pp_view_out *view, const struct pp_world *world,
                                const struct pp_light_scene *scene, struct pp_vec3 eye,
                                int lines, struct pp_error *err);

/* Bounds of the three levels, by index pp_view_level (0: nothing). */
extern const double pp_view_out_angle_rad[4];  /* 14, 28, 54 degrees */
extern const double pp_view_out_distance_m[4]; /* 6, 20, 50 m */

/* Level of each of the three quantities, and of the view: the lowest of the three.
 * Levels of layers: landscape; landscape and one more through the same opening; all
 * three. */
enum pp_view_level pp_view_out_angle_level(const struct pp_view_out *view);
enum pp_view_level pp_view_out_distance_level(const struct pp_view_out *view);
enum pp_view_level pp_view_out_layer_level(const struct pp_view_out *view);
enum pp_view_level pp_view_out_level(const struct pp_view_out *view);

#endif
