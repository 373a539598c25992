/* room_elevation.h - elevation, to scale, of a wall with its openings from inside, with
 * the horizon of an eye and the foot of the perpendicular from the eye. Perspective
 * diagrams can be laid on the elevation. */
#ifndef PP_CHARTS_ROOM_ROOM_ELEVATION_H
#define PP_CHARTS_ROOM_ROOM_ELEVATION_H

#include "charts/sheet/style.h"
#include "model/geometry/bounds.h"
#include "model/room/world.h"

/* Coordinates in the elevation are metres to the right of the foot of the perpendicular
 * from the eye, and metres above it. */
struct pp_room_elevation {
    const struct pp_world *world;
    const struct pp_opening
        *first; /* first opening in the face; the elevation uses its axes */
    struct pp_vec3 eye;
    double distance_m;        /* distance from the eye to the wall */
    struct pp_bounds2 extent; /* extent of the face, including the foot of the
                               * perpendicular */

    /* Scale, and position on paper of the foot of the perpendicular (mm); set by the
     * caller. */
    double mm_per_m, x, y;
};

/* Initialises the elevation of the face that contains the opening. opening must not be
 * NULL. */
void pp_room_elevation_init(struct pp_room_elevation *elevation,
                            const struct pp_world *world,
                            const struct pp_opening *opening, struct pp_vec3 eye);

/* Position on paper (mm) of a point in the plane of the wall. */
void pp_room_elevation_place(const struct pp_room_elevation *elevation,
                             struct pp_vec3 point, double *x, double *y);

void pp_room_elevation_draw(cairo_t *cr, const struct pp_style *style,
                            const struct pp_room_elevation *elevation);

/* Strokes the current path and hatches its inside, for a door or a dado. The path is
 * consumed. */
void pp_room_elevation_hatch(cairo_t *cr, const struct pp_style *style);

#endif
