/* lumen_room.h - the room of the lumen method, worked out by transfer of flux: what
 * the coefficients of its tables are made from.
 *
 * For light from the side the method's room is a box [IES84]: the working plane is its
 * floor and the window's head its ceiling (wall above the window counts as ceiling,
 * what is below the sill as floor), and the windows, evenly spread along one wall, are
 * the whole of that wall. All lengths are in window heights. From inside the window is
 * black. The working plane reflects as the cavity below it does, 0.20: what a floor of
 * 0.30 and walls of 0.50 come to, 0.75 m below a window of 1.5 m, within 0.07.
 *
 *     M = rho (E_direct + sum F M)       on patches of ceiling, plane and three walls
 *     CU = E on the working plane / E on the outside of the window, unglazed
 *
 * The patches exchange light by closed form (rectangle_factor.h), direct light comes by
 * quadrature over the window, and what the five points get of the patches is exact
 * again: what is left is that the exitance is even over a patch.
 *
 * A room of endless width is 10,000 window heights wide, which changes its middle by
 * less than 1e-4 of itself.
 */
#ifndef PP_METHODS_LUMEN_LUMEN_ROOM_H
#define PP_METHODS_LUMEN_LUMEN_ROOM_H

#include "model/base/error.h"
#include "model/light/sky.h"

/* The method's points, in shares of the depth from the window, on the line through its
 * middle. */
enum { PP_LUMEN_POINTS = 5 };
extern const double pp_lumen_places[PP_LUMEN_POINTS]; /* 0.1, 0.3, 0.5, 0.7, 0.9 */

/* Coefficients of utilization at those points, and the average over the plane. */
struct pp_lumen_coefficients {
    double at[PP_LUMEN_POINTS], average;
};

/* Reflectance of the working plane, that of the cavity below it. */
#define PP_LUMEN_PLANE 0.20

struct pp_lumen_finishes {
    double ceiling, walls;
};

struct pp_lumen_room; /* one geometry under one light */

/* width and depth in window heights, greater than 0, width up to INFINITY. fineness 1
 * is the mesh of the tables (about 300 patches to half a room), 2 one twice as fine in
 * each direction. On success *room is the caller's. */
enum pp_status pp_lumen_room_create(struct pp_lumen_room **room, double width,
                                    double depth, int fineness, struct pp_error *err);
void pp_lumen_room_destroy(struct pp_lumen_room *room); /* NULL is allowed */

/* Lights it from a sky that is the same on both sides of the window's normal, which
 * points to -y; NULL: from an even ground. */
void pp_lumen_room_light(struct pp_lumen_room *room, const struct pp_sky *sky);

/* The coefficients with those reflectances, each 0 to below 1. Valid after
 * pp_lumen_room_light. Iterates until nothing changes by 1e-9. */
struct pp_lumen_coefficients pp_lumen_room_solve(
    struct pp_lumen_room *room, const struct pp_lumen_finishes *finishes);

/* How much of the light that entered the last solution cannot account for: what
 * ceiling, plane and walls absorb and what leaves by the window, over what entered,
 * less 1. */
double pp_lumen_room_imbalance(const struct pp_lumen_room *room);

/* The sky that the tables hold for a ratio Ev/Eh of the illuminances on the window and
 * on the ground: for 0.396 (any below 0.5) the CIE overcast sky, else the ISO sky
 * of
 * ratio; PP_BAD_INPUT where none does. */
enum pp_status pp_lumen_room_sky(struct pp_sky *sky, double ev_over_eh,
                                 struct pp_error *err);

#endif
