/* room_features.h - dimensionless properties of a room and of a point in it that are
 * known without simulation, and on which the errors of hand methods depend.
 *
 * They do not change if all lengths of the room are scaled by the same factor. Openings
 * count with the area of their glass.
 *
 *     glass-floor     area of glass over that of the floor
 *     glass-inside    the same over the area of all inside surfaces, W/A
 *     reflectance     R, the area-weighted mean of all inside surfaces
 *     floor, ceiling  reflectances of these
 *     depth-head      depth of the room from its largest vertical opening over the height
 *                     of that opening's head above the working plane; without one, the
 *                     square root of the floor's area over the mean height of the
 *                     openings above the plane
 *     depth-width     depth over width of the room, seen from that opening
 *     below           share of the openings' area below the working plane
 *     upright         share of the openings' area that is vertical (from 75 degrees)
 *     walls           number of faces that have openings
 *     spread          area of the largest opening over that of all
 *     reveal          depth of the openings over the square root of their area, mean
 *     pane            diffuse transmittance over the normal one, mean
 *     obstruction     degrees: mean angle of the infinitely long skylines that replace all
 *                     obstructions (methods/reflected/obstruction.h)
 *     things          0: nothing outside or skylines; 1: blocks, surfaces, facades or other
 *                     parts of the building
 *     ground          reflectance of the ground
 *     facing          illuminance of the open sky on the openings' planes, mean, over Eh
 *     opposite        the same on planes that face the openings, such as the facades
 *                     across a street
 *     ordinary        1: an ordinary room: the properties above from glass-floor to ground
 *                     are in the ranges of offices, schools and homes; else 0
 *
 * and of a point, NAN for a room as a whole:
 *
 *     depth           horizontal distance from the nearest part of an opening over that
 *                     opening's height above the point, the least of all openings
 *     side            distance to the nearest wall over the height of the room
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
    PP_ROOM_OF_POINTS, /* the following ones are of a point */
    PP_ROOM_DEPTH = PP_ROOM_OF_POINTS,
    PP_ROOM_SIDE,
    PP_ROOM_VIEW,
    PP_ROOM_FEATURES,
};

/* Names as above. */
extern const char *const pp_room_feature_names[PP_ROOM_FEATURES];

/* Features of a room with openings; those of points are NAN. Takes the time of the
 * obstruction angles: microseconds, or a millisecond with blocks before the windows.
 * Without openings all are NAN. */
enum pp_status pp_room_features(double features[PP_ROOM_FEATURES],
                                const struct pp_world *world,
                                const struct pp_outside_light *light,
                                struct pp_error *err);

/* Fills in the features of a point, which faces up. */
void pp_room_features_at(double features[PP_ROOM_FEATURES],
                         const struct pp_world *world, struct pp_vec3 point);

#endif
