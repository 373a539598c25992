/* lumen_room.h - flux transfer in the room of the lumen method for light from the side.
 * The coefficients in the method's tables are results of this calculation.
 *
 * The method's room is a box [IES84]: its floor is the working plane and its ceiling is
 * at the window's head (wall above the window counts as ceiling, wall below the sill as
 * floor), and the windows, evenly spread along one wall, are the whole of that wall.
 * All lengths are in window heights. The window's reflectance from inside is 0. The
 * working plane has the reflectance of the cavity below, 0.20. This is within 0.07 of
 * the value for a floor of 0.30, walls of 0.50 and a cavity 0.75 m deep below a window
 * 1.5 m high.
 *
 *     M = rho (E_direct + sum F M)       on patches of ceiling, plane and three walls
 *     CU = E on the working plane / E on the outside of the window, unglazed
 *
 * Form factors between patches are in closed form (rectangle_factor.h), and so are the
 * illuminances of the five points from the patches. Direct light is calculated by
 * quadrature over the window. The only approximation is the uniform exitance of each
 * patch.
 *
 * A room of infinite width is treated as 10,000 window heights wide, which changes the
 * illuminances in its middle by less than 1e-4.
 */
#ifndef PP_METHODS_LUMEN_LUMEN_ROOM_H
#define PP_METHODS_LUMEN_LUMEN_ROOM_H

#include "model/base/error.h"
#include "model/light/sky.h"

/* The method's points, as fractions of the depth from the window, on the normal through
 * the window's middle. */
enum { PP_LUMEN_POINTS = 5 };
extern const double pp_lumen_places[PP_LUMEN_POINTS]; /* 0.1, 0.3, 0.5, 0.7, 0.9 */

/* Coefficients of utilization at those points, and the average over the plane. */
struct pp_lumen_coefficients {
    double at[PP_LUMEN_POINTS], average;
};

/* Reflectance of the working plane: that of the cavity below it. */
#define PP_LUMEN_PLANE 0.20

struct pp_lumen_finishes {
    double ceiling, walls;
};

struct pp_lumen_room; /* one geometry under one light */

/* width and depth in window heights, greater than 0, width up to INFINITY. fineness 1:
 * the mesh used for the tables (about 300 patches for half a room); 2: a mesh twice as
 * fine in each direction. On success the caller destroys *room. */
enum pp_status pp_lumen_room_create(struct pp_lumen_room **room, double width,
                                    double depth, int fineness, struct pp_error *err);
void pp_lumen_room_destroy(struct pp_lumen_room *room); /* NULL is allowed */

/* Sets the light source: a sky, or, if NULL, a ground of uniform luminance. The sky
 * must be symmetrical about the window's outward normal, which is -y. */
void pp_lumen_room_light(struct pp_lumen_room *room, const struct pp_sky *sky);

/* Calculates the coefficients for these reflectances, each at least 0 and below 1. Call
 * pp_lumen_room_light first. Iterates until no exitance changes by more than 1e-10. */
struct pp_lumen_coefficients pp_lumen_room_solve(
    struct pp_lumen_room *room, const struct pp_lumen_finishes *finishes);

/* Error of the last solution's flux balance: the flux absorbed by ceiling, plane and
 * walls and lost through the window, divided by the flux that has entered, minus 1. */
double pp_lumen_room_imbalance(const struct pp_lumen_room *room);

/* Sky of the tables for a ratio Ev/Eh of the illuminances on the window and on the
 * ground. For any ratio below 0.5 it is the CIE overcast sky (0.396). Otherwise it is
 * the clear sky of ISO 15469 type 13. Its sun is straight ahead of the window, at the
 * altitude that gives the ratio; PP_BAD_INPUT if there is no such altitude. */
enum pp_status pp_lumen_room_sky(struct pp_sky *sky, double ev_over_eh,
                                 struct pp_error *err);

#endif
