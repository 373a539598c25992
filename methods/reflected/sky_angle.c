/* sky_angle.c - the limits of the visible sky in section, for glass of any slope. */
#include "methods/reflected/sky_angle.h"

#include <stddef.h>

#include "methods/reflected/obstruction.h"
#include "methods/refusals.h"

static const struct pp_formula_quantity of_head[] = {
    {"h", PP_UNIT_METRE, "height of the opening"},
    {"d", PP_UNIT_METRE, "depth of the reveal, to the plane of the facade"},
    {0},
};

const struct pp_formula pp_sky_angle_head = {
    .symbol = "theta_h",
    .sum = "atan(h / 2 / d)",
    .unit = PP_UNIT_ANGLE,
    .what = "altitude of the head of the reveal (90 degrees without a reveal)",
    .quantities = of_head,
};

static const struct pp_formula_quantity of_limits[] = {
    {"beta", PP_UNIT_ANGLE, "slope of the glass (0: horizontal)"},
    {"alpha", PP_UNIT_ANGLE, "angle of the obstruction"},
    {0},
};
#define UPPER(text, words)                                                             \
    {                                                                                  \
        .symbol = "theta_h", .sum = text, .unit = PP_UNIT_ANGLE, .what = words,        \
        .quantities = of_limits                                                        \
    }
const struct pp_formula pp_sky_angle_upper[2] = {
    UPPER("180 - beta", "upper limit of the visible sky, for sloping glass"),
    UPPER("180 - alpha", "upper limit of the visible sky, for horizontal glass"),
};

static const struct pp_formula_quantity of_theta[] = {
    {"theta_h", PP_UNIT_ANGLE, "upper limit of the visible sky in section"},
    {"alpha", PP_UNIT_ANGLE, "angle of the obstruction"},
    {0},
};

const struct pp_formula pp_sky_angle_theta = {
    .symbol = "theta",
    .sum = "max(theta_h - alpha, 0)",
    .unit = PP_UNIT_ANGLE,
    .source = "CL84",
    .what = "angle of visible sky",
    .quantities = of_theta,
};

/* Depth from the wall's inner face to its outer face, whether in front of the glass or
 * behind it. */
static double depth_of(const struct pp_opening *opening)
{
    return opening->reveal_m + opening->recess_m;
}

void pp_sky_angle_head_of(struct pp_worksheet *sheet, const struct pp_opening *opening)
{
    if (depth_of(opening) == 0.0) {
        pp_worksheet_put(sheet, PP_UNIT_ANGLE, PP_PI / 2.0, "theta_h",
                         "upper limit of the visible sky: the zenith");
        return;
    }
    pp_worksheet_put(sheet, PP_UNIT_METRE, opening->height_m, "h",
                     "height of the opening");
    pp_worksheet_put(sheet, PP_UNIT_METRE, depth_of(opening), "d",
                     "depth of the reveal");
    pp_worksheet_work(sheet, &pp_sky_angle_head, "altitude of the head of the reveal");
}

static void put_sloping(struct pp_worksheet *sheet, const struct pp_opening *opening)
{
    bool level = sin(opening->slope_rad) < 1e-6;
    pp_worksheet_put(sheet, PP_UNIT_ANGLE, opening->slope_rad, "beta",
                     "slope of the glass");
    pp_worksheet_work(sheet, &pp_sky_angle_upper[level],
                      "upper limit of the visible sky in section");
    pp_worksheet_work(sheet, &pp_sky_angle_theta, "angle of visible sky");
}

enum pp_status pp_sky_angle(struct pp_worksheet *sheet, const struct pp_world *world,
                            const struct pp_outside_light *light,
                            const struct pp_opening *opening, struct pp_error *err)
{
    double alpha_rad;
    bool vertical = pp_refusals_unless_vertical(opening) == NULL;
    enum pp_status status =
        pp_obstruction_angle(&alpha_rad, world, light, opening, err);
    if (status != PP_OK)
        return status;
    if (vertical)
        pp_sky_angle_head_of(sheet, opening);
    pp_worksheet_put(sheet, PP_UNIT_ANGLE, alpha_rad, "alpha",
                     "angle of the obstruction");
    if (vertical)
        pp_worksheet_work(sheet, &pp_sky_angle_theta, "angle of visible sky");
    else
        put_sloping(sheet, opening);
    return PP_OK;
}
