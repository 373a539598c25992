/* visible_angle.c - see visible_angle.h. */
#include "methods/visible_angle.h"

#include "methods/reflected/obstruction_angle.h"

enum pp_status pp_visible_angle(struct pp_visible_angle *angle,
                                const struct pp_world *world,
                                const struct pp_opening *opening, struct pp_error *err)
{
    enum pp_status status =
        pp_obstruction_angle(&angle->alpha_rad, world, opening, err);
    angle->head_rad = atan2(opening->height_m / 2.0, opening->reveal_m);
    angle->theta_rad = fmax(angle->head_rad - angle->alpha_rad, 0.0);
    return status;
}

void pp_visible_angle_steps(struct pp_steps *steps,
                            const struct pp_visible_angle *angle,
                            const struct pp_opening *opening)
{
    int line = opening->line;
    if (opening->reveal_m > 0.0) {
        pp_steps_add_named(steps, PP_UNIT_METRE, opening->height_m, "h",
                           "opening on line %d: height", line);
        pp_steps_add_named(steps, PP_UNIT_METRE, opening->reveal_m, "d",
                           "opening on line %d: depth of the reveal", line);
        pp_steps_add_worked(steps, PP_UNIT_ANGLE, angle->head_rad, "theta_h",
                            "atan(h / 2 / d)", "altitude of the reveal's head");
    } else {
        pp_steps_add_named(steps, PP_UNIT_ANGLE, angle->head_rad, "theta_h",
                           "opening on line %d: up to the zenith", line);
    }
    pp_steps_add_named(steps, PP_UNIT_ANGLE, angle->alpha_rad, "alpha",
                       "opening on line %d: angle of the obstruction", line);
    pp_steps_add_worked(steps, PP_UNIT_ANGLE, angle->theta_rad, "theta",
                        "max(theta_h - alpha, 0)", "angle of visible sky");
}
