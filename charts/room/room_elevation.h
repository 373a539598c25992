/* room_elevation.h - a wall with its openings seen at right angles from inside, to a
 * true scale, with the horizon of an eye and the foot of its perpendicular. Perspective
 * diagrams can be laid on it. */
#ifndef PP_CHARTS_ROOM_ROOM_ELEVATION_H
#define PP_CHARTS_ROOM_ROOM_ELEVATION_H

#include "charts/sheet/style.h"
#include "model/geometry/bounds.h"
#include "model/room/world.h"

/* Places are metres to the right of the foot and above it. */
struct pp_room_elevation {
    const struct pp_world *world;
    const struct pp_opening
        *first; /* the first opening in the face, whose axes are used */
    struct pp_vec3 eye;
    double distance_m;        /* from the eye to the wall */
    struct pp_bounds2 extent; /* extent of face and foot */

    /* Set by the caller: the scale, and the position of the foot on paper. */
    double mm_per_m, x, y;
};

/* Initialises the elevation of the face of an opening, which must not be NULL. */
void pp_room_elevation_init(struct pp_room_elevation *elevation,
                            const struct pp_world *world,
                            const struct pp_opening *opening, struct pp_vec3 eye);

/* Position on paper of a place in the wall's plane. */
void pp_room_elevation_place(const struct pp_room_elevation *elevation,
                             struct pp_vec3 point, double *x, double *y);

void pp_room_elevation_draw(cairo_t *cr, const struct pp_style *style,
                            const struct pp_room_elevation *elevation);

/* Strokes the path with the current pen and hatches its inside: a door or a dado.
 * Leaves no path. */
void pp_room_elevation_hatch(cairo_t *cr, const struct pp_style *style);

#endif
