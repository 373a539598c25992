/* garden_sun.h - area of a garden that receives at least two hours of sun on 21
 * March. */
#ifndef PP_STUDIES_SITE_GARDEN_SUN_H
#define PP_STUDIES_SITE_GARDEN_SUN_H

#include "model/base/error.h"
#include "model/geometry/curve.h"
#include "model/room/world.h"

struct pp_garden_sun {
    double area_m2, sunlit_m2; /* whole area, and area with two hours of sun or more */
    double error_m2;           /* error of sunlit_m2 due to the tolerance of the
                                * boundary line */
    struct pp_curve_list
        dark; /* outlines of the area with less sun, in x and y of the room; outer
               * outlines are counter-clockwise, holes clockwise */
};

/* Calculates the possible hours of sun at ground level in closed form
 * (methods/exact/sunlit_hours.h). All obstructions hide the sun, including the rooms.
 * The boundary of the area with two hours of sun is accurate to 1/2000 of the garden's
 * diagonal or to 10 mm, whichever is larger. The caller clears *sun, which is empty
 * after a failure. The world must have a latitude. */
enum pp_status pp_garden_sun_find(struct pp_garden_sun *sun,
                                  const struct pp_world *world,
                                  const struct pp_garden *garden, struct pp_error *err);
void pp_garden_sun_clear(struct pp_garden_sun *sun);

#endif
