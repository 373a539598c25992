/* room_features.h - dimensionless properties of a room, and of a point in it, that are
 * known without simulation and on which the errors of hand methods depend.
 *
 * The features do not change if all lengths of the room are scaled by the same factor.
 * Openings count with the area of their glass. Features of a room:
 *
 *     glass-floor     area of glass divided by floor area
 *     glass-inside    area of glass divided by the area of all inside surfaces, W/A
 *     reflectance     R, the area-weighted mean of all inside surfaces
 *     floor, ceiling  reflectance of the floor, of the ceiling
 *     depth-head      depth of the room from its largest vertical opening, divided by
 *                     the height of that opening's head above the working plane;
 *                     without one, the square root of the floor area divided by the
 *                     height of the middle of the largest opening above the plane
 *     depth-width     depth divided by width of the room, seen from that opening; 1
 *                     without one
 *     below           fraction of the openings' area below the working plane
 *     upright         fraction of the openings' area that is vertical (75 degrees or
 *                     more)
 *     walls           number of faces that have openings
 *     spread          area of the largest opening divided by that of all openings
 *     reveal          mean of the openings' depth divided by the square root of area
 *     pane            mean of diffuse divided by normal transmittance
 *     obstruction     degrees: mean angle of the infinitely long skylines that replace
 *                     all obstructions (methods/reflected/obstruction.h)
 *     things          0: nothing or only skylines outside; 1: blocks, surfaces, facades
 *                     or other parts of the building
 *     ground          reflectance of the ground
 *     facing          mean illuminance of the openings' planes from the open sky,
 *                     divided by Eh
 *     opposite        the same for planes that face the openings, such as facades
 *                     across a street
 *     ordinary        1: ten of the properties above (room_features.c) are in the
 *                     ranges of offices, schools and homes; otherwise 0
 *
 * Features of a point, which are NAN for a room as a whole:
 *
 *     depth           least value, over all openings, of the horizontal distance from
 *                     the nearest part of the opening, divided by the height of the
 *                     opening's head above the point
 *     side            distance to the nearest wall divided by the height of the room
 *     view            configuration factor of the openings' inner outlines
 */
#ifndef PP_STUDIES_RESEARCH_ATLAS_ROOM_FEATURES_H
#define PP_STUDIES_RESEARCH_ATLAS_ROOM_FEATURES_H

#include "model/light/outside_light.h"
#include "model/room/world.h"

enum pp_room_feature {
    PP_ROOM_GLASS_FLOOR,
    PP_ROOM_GLASS_INSIDE,
    PP_ROOM_REFLECTANCE,
    PP_ROOM_FLOOR,
    PP_ROOM_CEILING,
    PP_ROOM_DEPTH_HEAD,
    PP_ROOM_DEPTH_WIDTH,
    PP_ROOM_BELOW,
    PP_ROOM_UPRIGHT,
    PP_ROOM_WALLS,
    PP_ROOM_SPREAD,
    PP_ROOM_REVEAL,
    PP_ROOM_PANE,
    PP_ROOM_OBSTRUCTION,
    PP_ROOM_THINGS,
    PP_ROOM_GROUND,
    PP_ROOM_FACING,
    PP_ROOM_OPPOSITE,
    PP_ROOM_ORDINARY,
    PP_ROOM_OF_POINTS, /* features of a point begin here */
    PP_ROOM_DEPTH = PP_ROOM_OF_POINTS,
    PP_ROOM_SIDE,
    PP_ROOM_VIEW,
    PP_ROOM_FEATURES,
};

/* Names as above. */
extern const char *const pp_room_feature_names[PP_ROOM_FEATURES];

/* Features of a room with openings; the features of points are set to NAN. Takes
 * microseconds, or a millisecond with blocks in front of the windows, mainly for the
 * obstruction angles. Without openings all features are NAN. */
enum pp_status pp_room_features(double features[PP_ROOM_FEATURES],
                                const struct pp_world *world,
                                const struct pp_outside_light *light,
                                struct pp_error *err);

/* Fills in the features of a point that faces upwards. */
void pp_room_features_at(double features[PP_ROOM_FEATURES],
                         const struct pp_world *world, struct pp_vec3 point);

#endif
