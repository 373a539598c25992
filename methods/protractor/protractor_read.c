/* protractor_read.c - reads an opening with a protractor [BRE309], rectangle by
 * rectangle.
 *
 * A vertical opening and its obstructions are the vertical rectangles of elevation.h,
 * each read separately. With d the distance of the opening's plane, an edge at height z
 * and a jamb at x have these angles in section and plan:
 *
 *     tan gamma = z / d,   tan phi = x / d.
 *
 * The plane of an opening at the slope beta (0 horizontal, 90 degrees vertical) is at
 * the perpendicular distance d from the point; b and x are measured in the plane from
 * the foot of that perpendicular, b up the slope. The section, perpendicular to the
 * opening's horizontal edges, shows an edge at b at the altitude
 *
 *     tan gamma = (b sin beta + d cos beta) / (d sin beta - b cos beta),
 *
 * which exceeds 90 degrees where the plane leans over the point. The sight line of the
 * average altitude gamma meets the plane at the slant distance d / sin(gamma + beta).
 * If the plan is tilted into the plane of that sight line, a jamb at x therefore has
 * the angle
 *
 *     tan theta = x sin(gamma + beta) / d.
 *
 * (For beta = 90 degrees that is tan phi cos gamma.) All edges of a horizontal opening
 * are horizontal: its section is perpendicular to the longer ones, since the average
 * altitude is most accurate for long narrow strips. Any other shape is read as a
 * rectangle of equal area, with the same middle and proportions. An obstruction is read
 * as the rectangle of equal area with the jambs of the hidden part and its edge nearer
 * to the zenith; the readings of obstructions are subtracted from that of the opening.
 */
#include "methods/protractor/protractor_read.h"

#include <math.h>
#include <stdlib.h>

#include "methods/view/elevation.h"
#include "methods/view/slope_rectangles.h"
#include "methods/view/visible.h"

static const double slope_tolerance_rad = PP_SLOPE_RECTANGLES_TOLERANCE_RAD;

double pp_protractor_read_slope(const struct pp_opening *opening)
{
    return pp_slope_rectangles_slope(opening);
}

enum pp_status pp_protractor_read_choose(struct pp_protractor *protractor,
                                         const struct pp_sky *sky,
                                         const struct pp_opening *opening,
                                         struct pp_error *err)
{
    static const double made_deg[] = {90.0, 0.0, 30.0, 60.0};
    double slope = pp_protractor_read_slope(opening);
    *protractor = (struct pp_protractor){
        .sky = *sky, .glass = pp_glass_none(), .slope_rad = slope};
    bool bare = opening->glass.panes == 0 && !opening->glass.diffusing;
    if (!bare)
        protractor->glass = pp_glass_clear_single();
    for (int i = 0; i < 4; i++)
        if (fabs(slope - made_deg[i] * PP_RAD) < slope_tolerance_rad) {
            protractor->slope_rad = made_deg[i] * PP_RAD;
            return PP_OK;
        }
    if (bare)
        return PP_OK;
    return pp_fail(err, PP_BAD_INPUT,
                   "no protractor for glass at %.0f degrees; expected 0, 30, 60 or 90",
                   slope / PP_RAD);
}

static bool slope_is_upright(double slope)
{
    return fabs(slope - PP_PI / 2.0) < slope_tolerance_rad;
}

static const struct pp_formula_quantity of_primary[] = {
    {"p_u", PP_UNIT_DAYLIGHT_FACTOR,
     "reading of the primary scale at the altitude of the upper edge"},
    {"p_l", PP_UNIT_DAYLIGHT_FACTOR,
     "reading of the primary scale at the altitude of the lower edge"},
    {0},
};
static const struct pp_formula_quantity of_auxiliary[] = {
    {"k_r", PP_UNIT_NUMBER,
     "reading of the auxiliary scale at the right jamb (positive to the right)"},
    {"k_l", PP_UNIT_NUMBER, "reading of the auxiliary scale at the left jamb"},
    {0},
};
static const struct pp_formula_quantity of_component[] = {
    {"i", PP_UNIT_DAYLIGHT_FACTOR, "initial component, for an infinitely long opening"},
    {"K", PP_UNIT_NUMBER, "correction factor for the width"},
    {0},
};
static const struct pp_formula_quantity of_reflected[] = {
    {"e", PP_UNIT_DAYLIGHT_FACTOR, "equivalent sky component of the obstruction"},
    {"f", PP_UNIT_NUMBER, "luminance factor of the obstruction"},
    {0},
};

#define BRS(left, right, of, what_of, quantities_of)                                   \
    {                                                                                  \
        .symbol = left, .sum = right, .unit = of, .source = "BRE309", .what = what_of, \
        .quantities = quantities_of                                                    \
    }

const struct pp_formula pp_protractor_read_initial =
    BRS("i", "p_u - p_l", PP_UNIT_DAYLIGHT_FACTOR,
        "initial component, for an infinitely long opening", of_primary);
const struct pp_formula pp_protractor_read_width = BRS(
    "K", "k_r - k_l", PP_UNIT_NUMBER, "correction factor for the width", of_auxiliary);
const struct pp_formula pp_protractor_read_no_width =
    BRS("K", "max(k_r - k_l, 0)", PP_UNIT_NUMBER,
        "correction factor for the width, at least 0", of_auxiliary);
const struct pp_formula pp_protractor_read_sc =
    BRS("sc", "i K", PP_UNIT_DAYLIGHT_FACTOR, "sky component", of_component);
const struct pp_formula pp_protractor_read_e =
    BRS("e", "i K", PP_UNIT_DAYLIGHT_FACTOR,
        "equivalent sky component of the obstruction", of_component);
const struct pp_formula pp_protractor_read_erc =
    BRS("erc", "f e", PP_UNIT_DAYLIGHT_FACTOR, "externally reflected component",
        of_reflected);
const struct pp_formula pp_protractor_read_less = {
    .symbol = "sc",
    .sum = "-e",
    .unit = PP_UNIT_DAYLIGHT_FACTOR,
    .source = "BRE309",
    .what = "reduction of the sky component by an obstruction, for a sloping opening",
    .quantities = of_reflected,
    .fixed = true};

/* Reads one rectangle of an opening. section: slope of the opening's plane in
 * section. */
static void read_rectangle(struct pp_protractor_reading *reading,
                           const struct pp_protractor_dial *dial, double slope,
                           struct pp_angle section, const struct pp_slope_rectangle *at)
{
    const double b[2] = {at->low, at->high}, x[2] = {at->left, at->right};
    bool turned_down = !slope_is_upright(slope);
    for (int i = 0; i < 2; i++) {
        reading->edge_rad[i] = pp_slope_rectangles_altitude(b[i], section);
        reading->share[i] = pp_protractor_dial_share(dial, reading->edge_rad[i]);
    }
    reading->average_rad = (reading->edge_rad[0] + reading->edge_rad[1]) / 2.0;
    for (int i = 0; i < 2; i++) {
        double nearer = turned_down ? sin(reading->average_rad + slope) : 1.0;
        reading->jamb_rad[i] = atan(x[i] * nearer);
        reading->correction[i] = pp_protractor_dial_factor(
            dial, reading->average_rad, reading->jamb_rad[i], turned_down);
    }
}

/* Calculates the component of one rectangle by the formulae for its readings. */
static void work_component(struct pp_protractor_reading *reading)
{
    reading->initial =
        pp_formula_value(&pp_protractor_read_initial,
                         (const double[]){reading->share[1], reading->share[0]});
    reading->width_factor = pp_formula_value(
        &pp_protractor_read_no_width,
        (const double[]){reading->correction[1], reading->correction[0]});
    double of_sky =
        pp_formula_value(&pp_protractor_read_sc,
                         (const double[]){reading->initial, reading->width_factor});
    reading->component =
        reading->hidden ? pp_formula_value(&pp_protractor_read_erc,
                                           (const double[]){of_sky, reading->factor})
                        : of_sky;
}

static enum pp_status read_upright(struct pp_protractor_readings *readings,
                                   const struct pp_protractor_dial *dial,
                                   const struct pp_world *world,
                                   const struct pp_outside_light *light,
                                   const struct pp_opening *opening,
                                   struct pp_vec3 point, struct pp_error *err)
{
    const struct pp_angle upright = pp_angle_of(PP_PI / 2.0);
    struct pp_elevation elevation;
    enum pp_status status = pp_elevation_init(&elevation, world, opening, point, err);
    if (status != PP_OK)
        return status;
    readings->list = malloc(((size_t)elevation.count + 1) * sizeof *readings->list);
    if (!readings->list)
        status = pp_fail_memory(err);
    for (int i = 0; i < elevation.count && status == PP_OK; i++) {
        const struct pp_elevation_part *part = &elevation.parts[i];
        struct pp_protractor_reading *reading = &readings->list[readings->count++];
        *reading = (struct pp_protractor_reading){0};
        reading->hidden = !isnan(part->reflectance);
        reading->factor =
            reading->hidden
                ? pp_visible_luminance_factor(&light->sky, part->reflectance)
                : 1.0;
        const struct pp_slope_rectangle at = {.left = part->left,
                                              .right = part->right,
                                              .low = part->low,
                                              .high = part->high};
        read_rectangle(reading, dial, PP_PI / 2.0, upright, &at);
    }
    pp_elevation_clear(&elevation);
    return status;
}

/* Reads the whole opening as sky, then each obstruction, whose component is subtracted
 * from the sky component and added to the externally reflected one. */
static enum pp_status read_sloping(struct pp_protractor_readings *readings,
                                   const struct pp_protractor_dial *dial,
                                   const struct pp_slope_rectangles *rectangles,
                                   struct pp_error *err)
{
    const struct pp_angle section = pp_angle_of(rectangles->slope_rad);
    readings->list = calloc((size_t)rectangles->count + 1, sizeof *readings->list);
    if (!readings->list)
        return pp_fail_memory(err);
    for (int i = 0; i < rectangles->count; i++) {
        const struct pp_slope_rectangle *at = &rectangles->list[i];
        struct pp_protractor_reading *reading = &readings->list[readings->count++];
        reading->hidden = at->hidden;
        reading->factor = at->factor;
        read_rectangle(reading, dial, rectangles->slope_rad, section, at);
        readings->less_hidden = readings->less_hidden || at->hidden;
    }
    return PP_OK;
}

void pp_protractor_read_work(struct pp_protractor_readings *readings)
{
    for (int i = 0; i < readings->count; i++) {
        struct pp_protractor_reading *reading = &readings->list[i];
        work_component(reading);
        *(reading->hidden ? &readings->external : &readings->sky) += reading->component;
        if (reading->hidden && readings->less_hidden)
            readings->sky -= reading->initial * reading->width_factor;
    }
    readings->sky = fmax(readings->sky, 0.0);
}

enum pp_status pp_protractor_read(struct pp_protractor_readings *readings,
                                  const struct pp_protractor_dial *dial,
                                  const struct pp_world *world,
                                  const struct pp_outside_light *light,
                                  const struct pp_opening *opening,
                                  struct pp_vec3 point, struct pp_error *err)
{
    double slope = pp_protractor_read_slope(opening);
    struct pp_vec3 along = pp_slope_rectangles_along(opening, slope);
    *readings = (struct pp_protractor_readings){
        .along = along,
        .out = pp_vec_unit(pp_vec_cross(pp_vec(0.0, 0.0, 1.0), along)),
        .distance_m = pp_vec_dot(pp_vec_sub(point, opening->inner.vertices[0]),
                                 opening->inner.normal),
        .slope_rad = slope};
    enum pp_status status;
    if (slope_is_upright(slope)) {
        status = read_upright(readings, dial, world, light, opening, point, err);
    } else {
        struct pp_slope_rectangles rectangles;
        status =
            pp_slope_rectangles_init(&rectangles, world, light, opening, point, err);
        if (status != PP_OK)
            return status;
        status = read_sloping(readings, dial, &rectangles, err);
        pp_slope_rectangles_clear(&rectangles);
    }
    if (status != PP_OK)
        pp_protractor_sheet_readings_clear(readings);
    return status;
}
