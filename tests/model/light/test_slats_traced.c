/* test_slats_traced.c - light through thirty blinds compared with rays traced between
 * their slats.
 *
 * The rays share no code with the radiosity: they meet the arc itself, as a circle, and
 * leave it by Lambert's law in the section, where the sine of the angle is uniform. */
#include "model/light/slats/slat_cell.h"
#include "tests/lib/dice.h"
#include "tests/lib/near.h"

/* REACH: slats farther along a ray than this many spacings are never met first. */
enum { DEVICES = 30, RAYS = 20000, REACH = 60 };

/* A ray in the section, of unit direction; `share` of its light is left. */
struct section_ray {
    double at[2], to[2], share;
};

/* Distance along the ray to a slat whose chord has its middle at height `b`, and the
 * upward normal there; INFINITY: it is missed. */
static double distance_to_slat(const struct pp_slats *slats, double b,
                               const struct section_ray *ray, double normal[2])
{
    /* u along the chord, inwards; v at right angles to it, upwards */
    double cosine = cos(slats->tilt_rad), sine = sin(slats->tilt_rad);
    double y = ray->at[1] - b, half = 0.5 * slats->width, c = slats->rise;
    double u = ray->at[0] * cosine - y * sine, v = ray->at[0] * sine + y * cosine;
    double du = ray->to[0] * cosine - ray->to[1] * sine,
           dv = ray->to[0] * sine + ray->to[1] * cosine;
    double best = INFINITY, nu = 0.0, nv = 1.0;
    if (c == 0.0) {
        double t = -v / dv;
        if (t > 1e-9 && fabs(u + t * du) <= half)
            best = t;
    } else {
        double radius = 0.5 * (half * half + c * c) / fabs(c);
        double middle = c > 0.0 ? c - radius : c + radius; /* v of the centre */
        double along = u * du + (v - middle) * dv;
        double root =
            along * along - (u * u + (v - middle) * (v - middle) - radius * radius);
        for (int sign = -1; sign <= 1 && root > 0.0; sign += 2) {
            double t = -along + sign * sqrt(root), pu = u + t * du, pv = v + t * dv;
            if (t > 1e-9 && t < best && fabs(pu) <= half
                && (c > 0.0 ? pv > -1e-12 : pv < 1e-12)) {
                best = t;
                nu = pu / radius * (c > 0.0 ? 1.0 : -1.0);
                nv = (pv - middle) / radius * (c > 0.0 ? 1.0 : -1.0);
            }
        }
    }
    normal[0] = nu * cosine + nv * sine;
    normal[1] = -nu * sine + nv * cosine;
    return best;
}

/* Moves the ray to the slat that it meets first and reflects it there; false if it
 * leaves the blind. */
static bool meets_slat(const struct pp_slats *slats, struct section_ray *ray,
                       struct dice *dice)
{
    double reach = 0.5 * slats->width + fabs(slats->rise), best = INFINITY;
    double normal[2] = {0.0, 0.0};
    double leaves = ray->at[0] + (ray->to[0] > 0.0 ? -reach : reach);
    double end = ray->at[1] - leaves / ray->to[0] * ray->to[1];
    double most = REACH * slats->spacing;
    double low = fmax(fmin(ray->at[1], end), ray->at[1] - most),
           high = fmin(fmax(ray->at[1], end), ray->at[1] + most);
    for (double i = floor((low - reach) / slats->spacing);
         i <= ceil((high + reach) / slats->spacing); i++) {
        double n[2], t = distance_to_slat(slats, i * slats->spacing, ray, n);
        if (t < best) {
            best = t;
            normal[0] = n[0];
            normal[1] = n[1];
        }
    }
    if (isinf(best))
        return false;
    bool above = ray->to[0] * normal[0] + ray->to[1] * normal[1] < 0.0;
    double side = above ? 1.0 : -1.0, sine = between(dice, -1.0, 1.0);
    double cosine = side * sqrt(1.0 - sine * sine);
    for (int k = 0; k < 2; k++)
        ray->at[k] += best * ray->to[k];
    ray->to[0] = cosine * normal[0] + sine * normal[1];
    ray->to[1] = cosine * normal[1] - sine * normal[0];
    ray->share *= above ? slats->upper : slats->lower;
    return true;
}

/* Traces rays of that profile angle through one spacing of the blind. */
static struct pp_slat_parts traced_parts(const struct pp_slats *slats, double profile,
                                         struct dice *dice)
{
    struct pp_slat_parts parts = {0};
    double reach = 0.5 * slats->width + fabs(slats->rise);
    for (int i = 0; i < RAYS; i++) {
        struct section_ray ray = {{-reach, slats->spacing * (i + 0.5) / RAYS},
                                  {cos(profile), -sin(profile)},
                                  1.0 / RAYS};
        bool scattered = false;
        while (ray.share > 1e-4 / RAYS && meets_slat(slats, &ray, dice))
            scattered = true;
        double *part = !scattered ? &parts.straight
                       : ray.to[0] > 0.0
                           ? ray.to[1] > 0.0 ? &parts.room_up : &parts.room_down
                       : ray.to[1] > 0.0 ? &parts.back_up
                                         : &parts.back_down;
        *part += ray.share;
    }
    return parts;
}

/* Within 1 % of the incident light; standard errors of the rays are up to 0.3 %. */
static void thirty_blinds_pass_the_light_of_traced_rays(void **state)
{
    (void)state;
    for (int device = 0; device < DEVICES; device++) {
        struct dice dice = {device};
        struct pp_slats slats = {.spacing = 1.0};
        do {
            slats.width = between(&dice, 0.7, 1.5);
            slats.tilt_rad = between(&dice, -75.0, 75.0) * PP_RAD;
            slats.rise = device % 2 ? between(&dice, -0.18, 0.18) : 0.0;
        } while (!pp_slat_cell_fits(&slats));
        slats.upper = between(&dice, 0.1, 0.95);
        slats.lower = between(&dice, 0.1, 0.95);
        double profile = between(&dice, -80.0, 80.0) * PP_RAD;
        struct pp_slat_cell *cell = NULL;
        struct pp_slat_light light;
        assert_int_equal(pp_slat_cell_create(&cell, &slats, NULL), PP_OK);
        pp_slat_cell_light(cell, profile, &light);
        pp_slat_cell_destroy(cell);
        struct pp_slat_parts is = pp_slat_cell_parts(&light),
                             traced = traced_parts(&slats, profile, &dice);
        const double *a = &is.straight, *b = &traced.straight;
        for (int k = 0; k < 5; k++)
            assert_near(a[k], b[k], 0.01);
    }
}

TEST_FILE
{
    static const struct CMUnitTest tests[] = {
        cmocka_unit_test(thirty_blinds_pass_the_light_of_traced_rays),
    };
    add_tests(tests, NULL, NULL);
}
