/* well_window.h - the light on a window off an atrium or light well, by hand.
 *
 * The room is nested (outside/nested.h) in a coarse model that is a box with one or
 * more horizontal rooflights, glazed or open: the well. Its light reaches the window as
 *
 *     E_v = E_s + E_r
 *
 *   E_s   sky component on the wall of the well, by `exact` (exact/direct.h)
 *   E_r   light reflected by walls, floor and roof of the well. They exchange light as
 *         the bands of a shaft do (well.h); the walls have the same luminance all
 *         round a band
 *
 * Both are means of six points of the window. Published relations between the well
 * index and the light on the walls are not used: no reliable source was available.
 *
 * The formula of the average daylight factor has the angle theta of visible sky, which
 * stands for a light of theta / 2 per cent on the window, 45 % under the open sky
 * (39.6 % from the sky, the rest from a ground of reflectance 0.1). The same light from
 * a well therefore has the angle 2 E_v, reduced as theta is by a reveal.
 */
#ifndef PP_METHODS_REFLECTED_WELL_WINDOW_H
#define PP_METHODS_REFLECTED_WELL_WINDOW_H

#include "model/light/outside_light.h"
#include "model/results/worksheet.h"
#include "model/room/world.h"

extern const struct pp_formula pp_well_window_light, pp_well_window_theta;

/* Illuminances of the window from the well, over Eh. */
struct pp_well_window {
    double sky;       /* E_s */
    double reflected; /* E_r */
};

/* refuses_room and refuses of a method for rooms off a well (method.h). */
const char *pp_well_window_refuses_room(const struct pp_world *world);
const char *pp_well_window_refuses(const struct pp_world *world,
                                   const struct pp_outside_light *light,
                                   const struct pp_opening *opening,
                                   const struct pp_receiver *receiver);

/* The light on an opening that neither of them refuses. */
enum pp_status pp_well_window_of(struct pp_well_window *on_window,
                                 const struct pp_world *world,
                                 const struct pp_outside_light *light,
                                 const struct pp_opening *opening,
                                 struct pp_error *err);

/* Records the light on an opening, the assumptions about the well, and theta. */
enum pp_status pp_well_window_angle(struct pp_worksheet *sheet,
                                    const struct pp_world *world,
                                    const struct pp_outside_light *light,
                                    const struct pp_opening *opening,
                                    struct pp_error *err);

#endif
