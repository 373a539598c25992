/* garden_sun.h - area of a garden that gets two hours of sun on 21 March. */
#ifndef PP_STUDIES_SITE_GARDEN_SUN_H
#define PP_STUDIES_SITE_GARDEN_SUN_H

#include "model/base/error.h"
#include "model/geometry/curve.h"
#include "model/room/world.h"

struct pp_garden_sun {
    double area_m2, sunlit_m2; /* sunlit: two hours or more */
    double error_m2;           /* error of sunlit_m2, by the tolerance of the line */
    struct pp_curve_list
        dark; /* outlines of the rest, in the room's x and y; outer ones
               * counter-clockwise, holes clockwise */
};

/* Calculates the possible hours of sun in closed form (methods/exact/sunlit_hours.h) at
 * ground level. All obstructions hide the sun, the rooms included. The line of two
 * hours is accurate to 1/2000 of the garden's diagonal and to 10 mm. The caller clears
 * sun; empty on failure. The world must have a latitude. */
enum pp_status pp_garden_sun_find(struct pp_garden_sun *sun,
                                  const struct pp_world *world,
                                  const struct pp_garden *garden, struct pp_error *err);
void pp_garden_sun_clear(struct pp_garden_sun *sun);

#endif
