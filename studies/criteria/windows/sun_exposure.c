/* sun_exposure.c - exposure to sunlight as [EN17037] recommends it (table A.6), of a room
 * of a dwelling, a ward or a nursery's playroom.
 *
 *   minimum 1.5 h, medium 3 h, high 4 h of sun on a day from 1 February to 21 March
 *
 * The day is 21 March. Sun counts that reaches the reference point of any opening: the
 * middle of its width on the inside of its wall, 1.2 m above the floor and 0.3 m above
 * the sill at least (of sloping glass its middle). The standard leaves out the sun below
 * an altitude that it gives by place; its table was not at hand, so that all sun above the
 * horizon counts here: the figure is an upper bound, which shows that a level is not
 * reached, and cannot show that it is.
 */
#include <math.h>

#include "methods/exact/sunlit_hours.h"
#include "studies/criteria/bearing.h"
#include "studies/criteria/criteria.h"

#define ABOVE_FLOOR_M 1.2
#define ABOVE_SILL_M 0.3

static const char upper_bound[] =
    "with low sun, which the standard leaves out below an altitude by place";

/* The reference point of an opening. */
static struct pp_vec3 exposure_point(const struct pp_opening *opening)
{
    const struct pp_polygon *outline = &opening->inner;
    double low = INFINITY, high = -INFINITY;
    double left = INFINITY, right = -INFINITY;
    struct pp_vec3 origin = outline->vertices[0];
    for (int i = 0; i < outline->count; i++) {
        struct pp_vec3 off = pp_vec_sub(outline->vertices[i], origin);
        double x = pp_vec_dot(off, opening->along), y = pp_vec_dot(off, opening->up);
        left = fmin(left, x);
        right = fmax(right, x);
        low = fmin(low, y);
        high = fmax(high, y);
    }
    double y = 0.5 * (low + high);
    if (fabs(opening->slope_rad - PP_PI / 2.0) < 1.0 * PP_RAD) {
        double floor = ABOVE_FLOOR_M - origin.z;
        y = fmin(high, fmax(low + ABOVE_SILL_M, floor));
    }
    struct pp_vec3 middle = pp_vec_along(origin, 0.5 * (left + right), opening->along);
    return pp_vec_along(middle, y, opening->up);
}

/* The hours of sun through any of the openings. */
static enum pp_status find_hours(double *hours, const struct pp_world *world,
                                 struct pp_error *err)
{
    struct pp_sunlit_place place = {world->latitude_rad, world->north_rad,
                                    world->longitude_rad};
    struct pp_sunlit_day day = {0};
    enum pp_status status = PP_OK;
    for (int i = 0; i < world->opening_count && status == PP_OK; i++) {
        const struct pp_opening *opening = &world->openings[i];
        struct pp_hidden_view view = {exposure_point(opening),
                                      pp_vec_scale(opening->inner.normal, -1.0),
                                      opening->face, opening};
        struct pp_hidden_cones cones;
        status = pp_hidden_cones_init(&cones, world, &view, err);
        if (status != PP_OK)
            break;
        status = pp_sunlit_hours_of_day(&day, &cones, place, 3, 21, err);
        pp_hidden_cones_clear(&cones);
    }
    *hours = pp_sunlit_hours_sum(&day);
    pp_sunlit_hours_clear(&day);
    return status;
}

static enum pp_status assess_sun_exposure(const struct pp_inquiry *inquiry,
                                          struct pp_finding_list *findings,
                                          struct pp_error *err)
{
    static const struct {
        const char *name;
        double hours;
    } levels[] = {{"minimum", 1.5}, {"medium", 3.0}, {"high", 4.0}};
    const struct pp_world *world = inquiry->world;
    double hours;
    if (isnan(world->latitude_rad)) {
        struct pp_finding finding =
            pp_finding_not_judged("the room file gives no latitude (site)", "21 March");
        return pp_finding_list_add(findings, &finding, err);
    }
    enum pp_status status = find_hours(&hours, world, err);
    for (int i = 0; i < 3 && status == PP_OK; i++) {
        struct pp_finding finding =
            pp_finding_of(PP_FIGURE_HOURS, hours, levels[i].hours, false,
                          "%s: %g h on 21 March", levels[i].name, levels[i].hours);
        if (finding.verdict == PP_MET) {
            finding.verdict = PP_UNDECIDED;
            pp_finding_note(&finding, "%s", upper_bound);
        }
        status = pp_finding_list_add(findings, &finding, err);
    }
    return status;
}

const struct pp_criterion pp_criterion_sun_exposure = {
    .name = "sun-exposure",
    .title = "EN 17037 exposure to sunlight",
    .source = "EN17037",
    .summary = "1.5, 3, 4 h of sun on 21 March at the inside of a window",
    .bears_on_use = pp_bearing_is_dwelling,
    .evaluate = assess_sun_exposure,
};
