/* beam_average.c - divides the directions that an opening faces into parts, and
 * integrates over each part by cubature. */
#include "methods/fast/beam_average.h"

#include <cubature.h>

/* Range of bearings (relative to the opening's own) or of altitudes, radians. */
struct bearing_range {
    double low, high;
};

struct beam_integral {
    struct pp_kept_beam *beam;
    const struct pp_plane_light *light;
    struct pp_vec3 out, across; /* horizontal unit vectors: in the opening's bearing,
                                 * and perpendicular to it */
    double level,
        tilt;          /* u.w = level cos(altitude) cos(bearing) + tilt sin(altitude) */
    double bearing[2]; /* limits of the part's bearings (rad) */
    double share[2];   /* limits of the part's altitudes, as fractions of the altitudes
                        * that the opening faces */
    enum pp_status status;
};

/* Range of altitudes at a bearing for which the direction is above the horizon and in
 * front of the opening. */
static struct bearing_range altitudes(const struct beam_integral *integral,
                                      double bearing)
{
    double level = integral->level * cos(bearing), tilt = integral->tilt;
    struct bearing_range range = {0.0, PP_PI / 2.0};
    if (level < 0.0)
        range.low = atan2(-level, tilt);
    else if (tilt < 0.0)
        range.high = atan2(level, -tilt);
    range.low = fmin(fmax(range.low, 0.0), PP_PI / 2.0);
    return range;
}

static int integrand_at(unsigned dim, const double *square, void *data, unsigned fdim,
                        double *values)
{
    (void)dim, (void)fdim;
    struct beam_integral *integral = data;
    double bearing = integral->bearing[0]
                     + square[0] * (integral->bearing[1] - integral->bearing[0]);
    struct bearing_range range = altitudes(integral, bearing);
    double height = range.high - range.low;
    double altitude = range.low
                      + height
                            * (integral->share[0]
                               + square[1] * (integral->share[1] - integral->share[0]));
    double level = cos(altitude), rise = sin(altitude);
    struct pp_vec3 u = pp_vec_along(pp_vec_scale(integral->out, level * cos(bearing)),
                                    level * sin(bearing), integral->across);
    u.z = rise;
    double facing = integral->level * level * cos(bearing) + integral->tilt * rise;
    struct pp_beam_areas areas = {0};
    values[0] = values[1] = 0.0;
    if (!(facing > 0.0) || integral->status != PP_OK)
        return 0;
    integral->status = pp_kept_beam_areas(&areas, integral->beam, u, NULL);
    const struct pp_plane_light *light = integral->light;
    double weight = facing * level * (integral->bearing[1] - integral->bearing[0])
                    * (integral->share[1] - integral->share[0]) * height;
    if (areas.sky > 0.0 || areas.reflecting > 0.0) {
        double sky = weight * light->sky(light->context, u);
        values[0] = sky * areas.sky;
        values[1] = sky * light->of_reflectance * areas.reflecting;
    }
    if (areas.emitting > 0.0 && light->exitance)
        values[1] +=
            weight * light->exitance(light->context, u) / PP_PI * areas.emitting;
    return 0;
}

/* Numbers of parts into which the directions are divided. The parts are unequal, so
 * that no cut is at the middle of a window: in a symmetrical room the error estimates
 * would then be too small. */
enum { FRONT = 4, BACK = 2, LAYERS = 3, PARTS = (FRONT + BACK) * LAYERS };
static const double bearings[FRONT + BACK + 1] = {-1.0, -0.43, 0.09, 0.55,
                                                  1.0,  1.93,  3.0};
static const double layers[LAYERS + 1] = {0.0, 0.21, 0.53, 1.0};

/* Points of the cubature for one part: in the first estimate, and at most. */
enum { FIRST_POINTS = 17, MOST_POINTS = 6000 };

/* Greatest number of tolerances; each follows from the estimate with the one before. */
enum { MOST_TOLERANCES = 4 };

/* Integral over a part: its two values, and the sum of their errors. */
struct part_integral {
    double values[2], error;
};

/* Integrates again the parts whose error exceeds `absolute`, and adds up all parts. */
static enum pp_status integrate_parts(double sum[2], struct part_integral *of,
                                      const struct beam_integral *like, int parts,
                                      double absolute, int points, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = 0; i < parts && status == PP_OK; i++) {
        const double low[2] = {0.0, 0.0}, high[2] = {1.0, 1.0};
        struct beam_integral own = *like;
        double error[2];
        if (of[i].error <= absolute)
            continue;
        for (int k = 0; k < 2; k++) {
            own.bearing[k] = bearings[i / LAYERS + k] * PP_PI / 2.0;
            own.share[k] = layers[i % LAYERS + k];
        }
        status = hcubature(2, integrand_at, &own, 2, low, high, (size_t)points,
                           absolute, 0.0, ERROR_L1, of[i].values, error)
                         != 0
                     ? PP_SYSTEM
                     : own.status;
        of[i].error = error[0] + error[1];
    }
    sum[0] = sum[1] = 0.0;
    for (int i = 0; i < parts && status == PP_OK; i++) {
        sum[0] += of[i].values[0];
        sum[1] += of[i].values[1];
    }
    return status == PP_SYSTEM        ? pp_fail_memory(err)
           : status == PP_INTERRUPTED ? pp_fail(err, PP_INTERRUPTED, "interrupted")
                                      : PP_OK;
}

enum pp_status pp_beam_average(double mean[2], struct pp_beams *beams,
                               const struct pp_opening *opening,
                               const struct pp_plane_light *light,
                               double relative_error, struct pp_error *err)
{
    struct pp_kept_beam *beam;
    mean[0] = mean[1] = 0.0;
    enum pp_status status =
        pp_beams_of(&beam, beams, opening, light->with_outside, err);
    if (status != PP_OK)
        return status;
    struct pp_vec3 w = pp_vec_scale(opening->inner.normal, -1.0);
    double level = hypot(w.x, w.y);
    if (level < 1e-12)
        level = 0.0;
    struct beam_integral integral = {.beam = beam,
                                     .light = light,
                                     .out = level > 0.0
                                                ? pp_vec(w.x / level, w.y / level, 0.0)
                                                : pp_vec(1.0, 0.0, 0.0),
                                     .level = level,
                                     .tilt = fabs(w.z) < 1e-12 ? 0.0 : w.z};
    integral.across = pp_vec(-integral.out.y, integral.out.x, 0.0);
    /* An opening that does not slope upwards faces half of the bearings. */
    int parts = (integral.tilt > 0.0 ? FRONT + BACK : FRONT) * LAYERS;
    double sum[2];
    struct part_integral of[PARTS];
    for (int i = 0; i < parts; i++)
        of[i].error = INFINITY;
    status = integrate_parts(sum, of, &integral, parts, 1e300, FIRST_POINTS, err);
    /* The first estimate is far off for a photographed sky with a small sun, and may be
     * negative. Then the tolerance that follows from it is set again. */
    double total = fabs(sum[0] + sum[1]), before = INFINITY;
    for (int i = 0;
         i < MOST_TOLERANCES && status == PP_OK && total > 0.0 && total < 0.5 * before;
         i++) {
        double absolute = relative_error / 8.0 * total / sqrt(parts);
        status = integrate_parts(sum, of, &integral, parts, absolute, MOST_POINTS, err);
        before = total;
        total = fabs(sum[0] + sum[1]);
    }
    double area_m2 = pp_region_area(&pp_beams_world(beams)->plane);
    mean[0] = sum[0] / area_m2;
    mean[1] = sum[1] / area_m2;
    return status;
}
