/* hand_case.c - see hand_case.h. */
#include "studies/year/hand/hand_case.h"

#include <math.h>
#include <stdlib.h>

#include "methods/allowance.h"
#include "model/geometry/min_max.h"

/* Threshold of sunshine [WMO8], W/m2. */
static const double SUNSHINE_W_M2 = 120.0;

static void set_hour(struct pp_hand_hour *hour, const struct pp_hand_case *of,
                     const struct pp_weather_hour *from,
                     const struct pp_year_clock *clock)
{
    const struct pp_perez_sky *sky = &of->year->skies[from->sky];
    double toward = of->southern ? 1.0 : -1.0; /* y of the direction of the equator */
    *hour = (struct pp_hand_hour){
        .date = from->date,
        .start_h = from->start_h,
        .length_h = clock->length_h[from->sky],
        .occupied_h = clock->occupied_h[from->sky],
        .sun = sky->sun,
        .altitude_rad = asin(pp_clamp(sky->sun.z, -1.0, 1.0)),
        .azimuth_rad = atan2(-sky->sun.x, toward * sky->sun.y),
        .diffuse_lx = sky->diffuse_lx,
        .direct_lx = sky->sun.z > 0.0 ? sky->direct_lx : 0.0,
        .clearness = sky->clearness,
        .brightness = sky->brightness,
        .bin = sky->bin,
        .sunny = sky->sun.z > 0.0 && from->direct_w_m2 > SUNSHINE_W_M2,
        .cloud_cover = from->cloud_cover};
}

enum pp_status pp_hand_case_init(struct pp_hand_case *of, const struct pp_world *world,
                                 const struct pp_weather_year *year,
                                 const struct pp_year_clock *clock,
                                 enum pp_standard_sky overcast, struct pp_error *err)
{
    struct pp_vec3 zenith = {0.0, 0.0, 1.0};
    *of = (struct pp_hand_case){.world = world,
                                .year = year,
                                .southern = year->epw && year->epw->latitude_rad < 0.0,
                                .hour_count = year->sky_count,
                                .all_occupied_h = clock->all_occupied_h};
    of->hours = calloc((size_t)of->hour_count + 1, sizeof *of->hours);
    if (!of->hours)
        return pp_fail_memory(err);
    for (int i = 0; i < year->count; i++)
        if (year->hours[i].sky >= 0)
            set_hour(&of->hours[year->hours[i].sky], of, &year->hours[i], clock);
    of->overcast = pp_reference_skies_add_standard(&of->skies, overcast, zenith);
    return PP_OK;
}

void pp_hand_case_clear(struct pp_hand_case *of)
{
    pp_reference_skies_clear(&of->skies);
    free(of->hours);
    free(of->df);
    *of = (struct pp_hand_case){.world = NULL};
}

/* ---- orientation ---- */

/* Shares of the four orientations; false if there are none. */
static bool facade_shares(double shares[4], const struct pp_hand_case *of)
{
    const struct pp_world *world = of->world;
    double all = 0.0;
    for (int i = 0; i < 4; i++)
        shares[i] = 0.0;
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_opening *opening = &world->openings[i];
        struct pp_vec3 out = pp_vec_scale(opening->inner.normal, -1.0);
        if (opening->slope_rad < 45.0 * PP_RAD || hypot(out.x, out.y) < 1e-9)
            return false;
        double bearing = world->north_rad + atan2(out.x, out.y);
        /* Quarter turns from the direction of the equator to the east, the pole and the
         * west. */
        double from = of->southern ? bearing : PP_PI - bearing;
        double turn = fmod(from / (0.5 * PP_PI) + 8.0, 4.0);
        int first = (int)turn % 4;
        double weight =
            opening->outer.area_m2 * pp_allowance_factor(PP_ALLOWS_NOTHING, opening);
        shares[first] += weight * (1.0 - (turn - floor(turn)));
        shares[(first + 1) % 4] += weight * (turn - floor(turn));
        all += weight;
    }
    for (int i = 0; i < 4 && all > 0.0; i++)
        shares[i] /= all;
    return all > 0.0;
}

double pp_hand_case_by_facade(const struct pp_hand_case *of, const double values[4])
{
    double shares[4], sum = 0.0;
    if (!facade_shares(shares, of))
        return NAN;
    for (int i = 0; i < 4; i++)
        sum += shares[i] * values[i];
    return sum;
}

int pp_hand_case_facade(const struct pp_hand_case *of)
{
    double shares[4];
    int most = 0;
    if (!facade_shares(shares, of))
        return -1;
    for (int i = 1; i < 4; i++)
        if (shares[i] > shares[most] + 1e-9)
            most = i;
    return most;
}
