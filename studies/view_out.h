/* view_out.h - the view out of a room from one position of the eye, according to
 * [EN17037] 5.2: horizontal sight angle, distance of visible objects, and layers.
 *
 *   sight angle  the part of the horizon, in plan, covered by openings; overlaps count
 *                once. Exact: the outline of an opening and its reveal, less furniture
 *                and other parts of the room before it
 *   distance     median, weighted by solid angle, of the distance from the glass along
 *                lines of sight; the sky is at infinite distance. Lines that end less
 *                than 2 m beyond the glass are ignored, because a window sill or a
 *                railing is not a view
 *   layers       sky, landscape (all objects outside, and ground less than 5 degrees
 *                below the horizon) and ground
 *
 * The standard does not define the distance; these rules are documented by
 * ClimateStudio. An opening is counted if it has no blind, and its glass is clear and
 * slopes at most 45 degrees from the vertical. Distance and layers are found by lines
 * of sight that are spread evenly over each opening.
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
    PP_VIEW_LAYERS = 7 /* bit mask of all layers */
};

/* Levels of [EN17037]. PP_VIEW_NONE: below the minimum. */
enum pp_view_level { PP_VIEW_NONE, PP_VIEW_MINIMUM, PP_VIEW_MEDIUM, PP_VIEW_HIGH };

struct pp_view_out {
    double sight_angle_rad; /* 0 to 2 pi */
    double distance_m;      /* INFINITY: only sky is visible; 0: no lines of sight were
                             * counted */
    int layers;             /* bit mask of enum pp_view_layer, through any opening */
    int layers_together; /* greatest number of layers, including landscape, through one
                          * opening; 0: no opening shows landscape */
};

/* Number of lines of sight through the rectangle around an opening's visible part. Each
 * has its own height: over level ground the lines of one height end at nearly the same
 * distance, and few heights give a coarse median. */
enum { PP_VIEW_OUT_LINES = 4096 };

/* Calculates the view from an eye in the room. scene: scene of the world
 * (light_scene_of_world.h); lines: number through each opening;
 * PP_VIEW_OUT_LINES, or more for a finer pattern. */
enum pp_status pp_view_out_from(struct pp_view_out *view, const struct pp_world *world,
                                const struct pp_light_scene *scene, struct pp_vec3 eye,
                                int lines, struct pp_error *err);

/* A line of sight: distance from the glass to its end, and its solid angle. */
struct pp_view_line {
    double distance_m, solid_angle;
};

/* Distance reached by half of the lines, weighted by solid angle; 0 if there are no
 * lines. Reorders the lines: the half that contains the median is divided again and
 * again, which is faster than sorting all lines. */
double pp_view_out_median_distance(struct pp_view_line *lines, int count);

/* Limits of the levels; index: enum pp_view_level (index 0: 0). */
extern const double pp_view_out_angle_rad[4];  /* 14, 28, 54 degrees */
extern const double pp_view_out_distance_m[4]; /* 6, 20, 50 m */

/* Level of each of the three quantities, and of the view, which is the lowest of the
 * three. Levels of layers: landscape; landscape and another layer through the same
 * opening; all three layers. */
enum pp_view_level pp_view_out_angle_level(const struct pp_view_out *view);
enum pp_view_level pp_view_out_distance_level(const struct pp_view_out *view);
enum pp_view_level pp_view_out_layer_level(const struct pp_view_out *view);
enum pp_view_level pp_view_out_level(const struct pp_view_out *view);

#endif
