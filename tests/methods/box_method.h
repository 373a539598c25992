/* box_method.h - the value of a hand method for one window of a box_room, and a room
 * with the symbols of the split-flux and sphere formulae worked out by hand.
 */
#ifndef PP_TESTS_METHODS_BOX_METHOD_H
#define PP_TESTS_METHODS_BOX_METHOD_H

#include "methods/method.h"
#include "tests/lib/near.h"

#include "tests/lib/box_room.h"

/* Value of a method that gives the internally reflected component or the daylight factor. */
static inline double box_method_value(const struct pp_method *method,
                                      struct box_room *box, int index)
{
    struct pp_part part = {0};
    const struct pp_opening *opening = box->openings + index;
    assert_null(method->refuses_room(&box->world, &box->light, NULL));
    assert_true(!method->refuses
                || !method->refuses(&box->world, &box->light, opening, NULL));
    assert_int_equal(
        method->evaluate(&box->world, &box->light, opening, NULL, NULL, &part, NULL),
        PP_OK);
    return part.value;
}

struct box_method_symbols {
    double tau, Ag, A, R, A_u, A_l, rho_u, rho_l, rho_g, C;
};

/* Glass with a diffuse transmittance of 0.85, the printed value for clear single
 * glass. */
static inline struct pp_glass box_method_printed_glass(void)
{
    struct pp_glass glass = pp_glass_clear_single();
    glass.diffuse = 0.85;
    return glass;
}

/* Builds a room without round dimensions. C is the printed value for 34 degrees. */
static inline struct box_method_symbols box_method_awkward_room(struct box_room *box,
                                                                struct pp_glass glass)
{
    double w = 3.7, d = 5.3, h = 2.9, middle = 0.7 + 1.3 / 2;
    double floor = 0.15, walls = 0.62, ceiling = 0.81;
    box_room_build(box, w, d, h, floor, walls, ceiling);
    struct pp_opening *window = box_room_south(box, 0.4, 0.7, 1.9, 1.3);
    window->glass = glass;
    window->frame_factor = 0.83;
    box->light.ground_reflectance = 0.17;
    box_room_skyline(box, 34.0 * PP_RAD, middle, INFINITY);

    double glass_m2 = 1.9 * 1.3, round = 2 * (w + d);
    double upper_walls = round * (h - middle) - glass_m2 / 2;
    double lower_walls = round * middle - glass_m2 / 2;
    struct box_method_symbols s = {.Ag = glass_m2 * 0.83, .rho_g = 0.17, .C = 0.23};
    s.tau = glass.diffuse;
    s.A = 2 * w * d + round * h;
    s.R = (w * d * (floor + ceiling) + (round * h - glass_m2) * walls + glass_m2 * 0.1)
          / s.A;
    s.A_u = w * d + upper_walls;
    s.A_l = w * d + lower_walls;
    s.rho_u = (w * d * ceiling + upper_walls * walls) / s.A_u;
    s.rho_l = (w * d * floor + lower_walls * walls) / s.A_l;
    return s;
}

#endif
