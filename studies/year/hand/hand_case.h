/* hand_case.h - the data from which hand methods for the year calculate: the hours of a
 * weather file, the room's daylight factors and its orientation, and factors under other
 * skies.
 *
 * Usage: init, `prepare` of the methods (which adds the skies that they need), simulation
 * of the skies, setting of the daylight factors, then evaluation.
 */
#ifndef PP_STUDIES_YEAR_HAND_HAND_CASE_H
#define PP_STUDIES_YEAR_HAND_HAND_CASE_H

#include "studies/year/hand/reference_skies.h"
#include "studies/year/year_metrics.h"

/* One record with daylight. */
struct pp_hand_hour {
    struct pp_month_day date;
    double start_h, length_h, occupied_h;
    struct pp_vec3 sun; /* unit; x east, y north, z up */
    double altitude_rad;
    double azimuth_rad; /* from the direction of the equator, positive in the afternoon:
                         * -pi to pi */
    double diffuse_lx, direct_lx; /* diffuse horizontal; direct normal, 0 if the sun is
                                   * down */
    double clearness, brightness;
    int bin;
    bool sunny;         /* true: direct normal irradiance above 120 W/m2 [WMO8] */
    double cloud_cover; /* NAN: not known */
};

struct pp_hand_case {
    const struct pp_world *world;
    const struct pp_weather_year *year;
    bool southern; /* true: the site is south of the equator */
    int hour_count;
    struct pp_hand_hour *hours; /* indexed by sky of the year; owned */
    double all_occupied_h;      /* including hours of darkness */
    struct pp_reference_skies skies;
    int overcast; /* index in `skies` of the overcast sky of simulated daylight
                   * factors */
    double *df;   /* daylight factors in use, by receiver; owned */
};

/* overcast: the sky of simulated daylight factors. */
enum pp_status pp_hand_case_init(struct pp_hand_case *of, const struct pp_world *world,
                                 const struct pp_weather_year *year,
                                 const struct pp_year_clock *clock,
                                 enum pp_standard_sky overcast, struct pp_error *err);
void pp_hand_case_clear(struct pp_hand_case *of);

/* Mean over the openings, by the area of their panes times their corrections for glass,
 * frame and dirt (pp_allowance_factor), of a value that depends on the orientation of a
 * facade: facing the equator, east, the pole, west. Between these orientations the
 * value is interpolated linearly in the bearing. NAN for a room with an opening that
 * slopes less than 45 degrees, or without openings. */
double pp_hand_case_by_facade(const struct pp_hand_case *of, const double values[4]);

/* Index of the orientation with the largest part of this weight: 0 equator, 1 east, 2
 * pole, 3 west; -1 if pp_hand_case_by_facade gives NAN. */
int pp_hand_case_facade(const struct pp_hand_case *of);

#endif
